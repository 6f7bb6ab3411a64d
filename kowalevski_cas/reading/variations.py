r"""Variations: one name, as :math:`\delta_x` for :math:`\delta x`, where a paper derives it.

So are differences :math:`\Delta x`, :math:`\Delta t`, where these letters stand nowhere else.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.source.displays import TypedFormula

_DOTS = r"\\d{1,4}ot(?![A-Za-z])"
_NAME = (
    r"(?:\\(?!d{1,4}ot|d?frac|left|right|in|cdot|times|[lgn]eq?|to|,)[A-Za-z]+|[A-Za-z])"
    r"(?:_(?:\w|\{\w+\}))?"
)
_GAP = r"(?:\s|\\[,;!])*"
_RATE = (
    r"{dots}\s*\{{\s*\\{mark}\s*{name}\s*\}}"
    r"|\bd(?:\^\d)?{gap}\(?\s*\\{mark}\s*{name}\s*\)?\s*\}}\s*\{{\s*d"
)
"""The rate of a variation."""


def with_variations(formulas: Sequence[TypedFormula]) -> Iterator[TypedFormula]:
    r"""The formulas, with one name in the place of each variation, if some of them derive one.

    A mark that stands without a letter, as in :math:`\delta>0`, or before a rate that is printed
    before the first of a variation, as in :math:`-\delta\dot x`, is a number: it varies nothing.
    """
    printed = [one.tex for one in formulas]
    marks = [mark for mark in ("delta", "Delta") if _varies(mark, printed)]
    marks += [r"Delta"] if "Delta" not in marks and _are_differences(printed) else []
    for formula in formulas:
        tex = formula.tex
        for mark in marks:
            tex = _renamed(tex, mark)
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def _varies(mark: str, printed: Sequence[str]) -> bool:
    """Whether a letter makes variations of those behind it."""
    rate = re.compile(_RATE.format(dots=_DOTS, mark=mark, name=_NAME, gap=_GAP))
    first = next((place for place, tex in enumerate(printed) if rate.search(tex)), None)
    if first is None:
        return False
    alone = re.compile(rf"\\{mark}(?![A-Za-z])(?!\s*(?:{_DOTS}\s*\{{?\s*)?{_NAME})")
    before = re.compile(rf"\\{mark}\s*{_DOTS}")
    return not any(map(alone.search, printed)) and not any(map(before.search, printed[:first]))


def _are_differences(printed: Sequence[str]) -> bool:
    """Whether several letters stand behind this sign alone, and it behind nothing but them."""
    difference = re.compile(rf"\\Delta\s*({_NAME})")
    letters = {name for tex in printed for name in difference.findall(tex)}
    rest = " ".join(difference.sub(" ", tex) for tex in printed)
    beside = "|".join(map(re.escape, (r"\Delta", *letters)))
    return len(letters) > 1 and not re.search(rf"(?<![A-Za-z\\])(?:{beside})(?![A-Za-z])", rest)


def is_power_of_difference(tex: str) -> bool:
    r"""Whether a power may be that of a difference, as :math:`\Delta x^2` is, or of a letter."""
    return bool(re.search(rf"\\[dD]elta\s*{_NAME}'*\s*\^", tex))


def _renamed(tex: str, mark: str) -> str:
    """A formula with names of variations."""
    own = rf"(?P<name>{_NAME})"
    for dotted in (
        rf"(?P<dots>{_DOTS})\s*\{{\s*\\{mark}\s*{own}\s*\}}",
        rf"\\{mark}\s*(?P<dots>{_DOTS})\s*\{{\s*{own}\s*\}}",
        rf"\\{mark}\s*(?P<dots>{_DOTS})\s*{own}",
    ):
        tex = re.sub(dotted, lambda one: rf"{one['dots']}{{\{mark}}}_{{{one['name']}}}", tex)
    behind_d = (
        rf"(?<=[{{\s])d(?P<order>\^\d)?{_GAP}\(?\s*\\{mark}\s*{own}\s*\)?(?=\s*\}}\s*\{{\s*d)"
    )
    tex = re.sub(behind_d, lambda one: rf"d{one['order'] or ''}\{mark}_{{{one['name']}}}", tex)
    return re.sub(rf"\\{mark}\s*{own}", lambda one: rf"\{mark}_{{{one['name']}}}", tex)
