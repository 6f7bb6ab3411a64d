r"""The numbers that TeX prints with formulas, by which sentences cite them as (3)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kowalevski_cas.source.displays import ROWS, TypedFormula, row_ends

_NUMBERED = frozenset("equation eqnarray align alignat flalign gather multline dmath".split())
"""The environments of which each formula has a number."""
_OWN = re.compile(r"\\(?:l?eqno|tag\*?)\s*\{?\s*\(?([\w.*']{1,9})\)?")
_NONE = re.compile(r"\\(?:nonumber|notag)(?![A-Za-z])")
_SECTION = re.compile(r"\\section\s*(?:\[[^\]]*\])?\s*\{|(?P<appendix>\\appendix(?![A-Za-z]))")
_WITHIN = re.compile(
    r"\\numberwithin\s*\{equation\}\s*\{section\}"
    r"|\\(?:renewcommand\s*\*?|def)\s*\{?\\theequation\}?\s*\{\s*\\thesection"
)
_RESET = re.compile(r"\\setcounter\s*\{equation\}\s*\{0\}")


def numbers_of(
    formulas: Iterable[TypedFormula], text: str, start: int, header: str
) -> Iterator[tuple[TypedFormula, str]]:
    r"""The formulas with numbers, as TeX counts them: printed by the author, or one after another.

    They begin anew in each section if the source says so, and have its number before them. A text
    that prints numbers of its own by ``\eqno`` counts none. ``start`` is where the body begins,
    ``header`` a text with the macros before it.
    """
    listed = [*formulas]
    own = [(one, found[1]) for one in listed if (found := _OWN.search(one.tex))]
    yield from own
    if any(r"eqno" in one.tex for one, _ in own):
        return
    told = {id(one) for one, _ in own}
    within = _WITHIN.search(header) is not None
    marks = [*_SECTION.finditer(text, start)]
    resets = [one.start() for one in _RESET.finditer(text, start)]
    count, last = 0, start
    for one in listed:
        rows = _rows_with_numbers(one) if one.kind in _NUMBERED and id(one) not in told else 0
        if not rows:
            continue
        passed = [mark for mark in marks if mark.start() < one.start]
        appendix = [k for k, mark in enumerate(passed) if mark["appendix"]]
        begun = [mark.start() for mark in passed] if r"\numberwithin" in header else []
        if any(last <= place < one.start for place in (*begun, *resets)):
            count = 0
        last = one.start
        before = ""
        if within:
            before = (
                f"{chr(64 + len(passed) - 1 - appendix[-1])}." if appendix else f"{len(passed)}."
            )
        for _ in range(rows):
            count += 1
            yield one, f"{before}{count}"


def _rows_with_numbers(formula: TypedFormula) -> int:
    """How many rows of a formula have a number; rows without one stand in it too."""
    tex = formula.tex
    if formula.kind not in ROWS:
        return 0 if _NONE.search(tex) else 1
    first, count = 0, 0
    for end, following in row_ends(tex):
        row = tex[first:end]
        count += bool(row.strip()) and not _NONE.search(row)
        first = following
    return count
