r"""Letters with a bar that are new names: :math:`\bar x=x+y` gives one where nothing is complex."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.paper.chains import NAME
from kowalevski_cas.source.displays import TypedFormula

_BAR = r"\\(?:bar|overline)(?![A-Za-z])"
_BARRED = rf"{_BAR}\s*(?:\{{\s*(?P<name>{NAME})\s*\}}|(?P<of>{NAME}))"
_GIVES = re.compile(
    rf"(?:^|\\\\|,|;|\\q?quad(?![A-Za-z])|\\label\s*\{{[^{{}}]*\}})\s*&?\s*{_BARRED}\s*&?\s*=\s*&?"
    r"(?P<value>(?:(?!\\\\|\\q?quad)[^=,;])+)"
)
_FIRST = re.compile(rf"\s*(?:\\label\s*\{{[^{{}}]*\}}\s*)?&?\s*{_BARRED}\s*&?\s*=")
_RUN = re.compile(
    r"\\(?:label|tag|(?:eq)?ref|begin|end|text|mbox|operatorname)\s*\{[^{}]*\}|\bi\s*="
    r"|_\s*(?:\{[^{}]*\}|\w)|\\[A-Za-z]+(?:\s*\{\s*i\s*\})?|[A-Za-z]"
)
"""Words, an index, a macro, or a letter: i alone is the imaginary unit."""
_COMPLEX = re.compile(
    r"\b(?:complex|conjugate\s+(?:of|to|function|number|quantit)\w*|holomorphic|комплексн\w*|сопряж[её]нн\w+\s+(?:к|функци|числ|величин)\w*)",
    re.IGNORECASE,
)
_OTHERS = ("tilde", "hat", "check", "breve")


def with_bars(formulas: Sequence[TypedFormula], text: str) -> Iterator[TypedFormula]:
    r"""The formulas, with another accent in the place of bars that make new names.

    Where i is printed, or words call something complex, a bar is a conjugate; but several letters
    with bars that are given side by side, one of them by its own letter, are new names.
    """
    mark = next(
        (one for one in _OTHERS if f"\\{one}" not in text and f"\\wide{one}" not in text), ""
    )
    renames = mark and _make_names([one.tex for one in formulas], text)
    for formula in formulas:
        tex = re.sub(_BAR, rf"\\{mark}", formula.tex) if renames else formula.tex
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def _make_names(texts: Sequence[str], text: str) -> bool:
    """Whether the first formula with a bar that says something gives a name to what has none."""
    first = next((tex for tex in texts if re.search(_BAR, tex) and "=" in tex), "")
    if not _FIRST.match(first) or any({"i", r"\mathrm{i}"} & {*_RUN.findall(tex)} for tex in texts):
        return False
    given = {one["name"] or one["of"]: one["value"] for one in _GIVES.finditer(first)}
    new = [name for name, value in given.items() if value.strip(" .,;\n") != name]
    if not new or any(re.search(_BAR, value) for value in given.values()):
        return False
    own = [name for name in new if name in re.findall(NAME, given[name])]
    return bool(len(given) > 1 and own) or _COMPLEX.search(text) is None
