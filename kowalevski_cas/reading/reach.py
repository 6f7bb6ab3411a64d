r"""How far a sine reaches: :math:`\sin\theta(a-b)` of an angle that moves is a product.

What the time stands in is an argument, as in :math:`\sin\omega(t-t_0)`. Any other is left open.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace

from kowalevski_cas.paper.chains import NAME, names_in
from kowalevski_cas.source.displays import TypedFormula

_HEAD = (
    r"\\(?:sin|cos|tan|tg|cot|ctg|sinh|cosh|tanh|sh|ch|th)(?![A-Za-z])"
    r"(?:\s*\^\s*(?:\d|\{\s*\d\s*\}))?"
)
_APPLIED = re.compile(rf"(?P<head>{_HEAD})\s*(?P<of>\d*\s*{NAME})\s*(?P<open>(?:\\left\s*)?\()")
_D = r"(?:d|\\mathrm\s*\{?\s*d\s*\}?)"
_BEFORE_RATE = re.compile(
    rf"({_HEAD}\s*\d*\s*{NAME})\s*"
    rf"(?=\\[dt]?frac\s*\{{\s*{_D}(?![A-Za-z]{{2}})[^{{}}]*\}}\s*\{{\s*{_D}(?![A-Za-z]{{2}}))"
)
"""A sine of a name right before a quotient of differentials."""
_BRACKETS = re.compile(r"\\left\s*\(|\\right\s*\)|[()]")


def with_reach(formulas: Iterable[TypedFormula], moving: Collection[str]) -> Iterator[TypedFormula]:
    r"""The formulas with a dot behind a sine of what moves, or brackets around a whole argument.

    ``moving`` are the names of which rates are printed.
    """
    for one in formulas:
        tex = _dotted(one.tex, moving)
        yield one if tex == one.tex else replace(one, tex=tex)


def _dotted(tex: str, moving: Collection[str]) -> str:
    tex, at = _BEFORE_RATE.sub(r"\1\\cdot ", tex), 0
    while found := _APPLIED.search(tex, at):
        name, start = found["of"].strip("0123456789 "), found.start("open")
        end, at = _closing(tex, start), found.end()
        inside = {*names_in(tex[start:end])} if end else set[str]()
        if name in moving and "t" not in inside:
            tex = rf"{tex[:start]}\cdot{tex[start:]}"
        elif name not in moving and "t" in inside:
            tex = f"{tex[: found.start('of')]}({tex[found.start('of') : end]}){tex[end:]}"
    return tex


def _closing(tex: str, start: int) -> int:
    """Where the bracket that opens at a place is closed; 0 if it is not."""
    depth = 0
    for mark in _BRACKETS.finditer(tex, start):
        depth += 1 if mark[0].endswith("(") else -1
        if depth == 0:
            return mark.end()
    return 0
