r"""Solutions that words name: “let :math:`u` and :math:`v` be solutions of this equation”.

Each moves by a copy of the equation, whatever its initial values are.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kowalevski_cas.notation import Name, to_latex
from kowalevski_cas.notation.edits import substitute
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

SAYS = "the words that call it a solution"
_LIST = r"(?P<list>§(?:[\s,~]|\band\b|\bи\b|§)*)"
_SOME = (
    r"(?:(?:any|some|arbitrary|two|three|an?|the|linearly|independent|different|particular)\s+)*"
)
_SOME_RU = r"(?:(?:дв[ае]|три|линейно|независимые|частные|произвольные|различные)\s+)*"
_SOLUTIONS = re.compile(
    rf"\blet\s+{_LIST}(?:be|denote)\s+{_SOME}solutions?\s+of\s+"
    r"(?P<which>(?:this|the\s+same)\s+equation\b|(?:(?:the\s+)?equation[\s~]*)?\(?\\(?:eq)?ref\b)"
    rf"|\bпусть\s+{_LIST.replace('list', 'list_ru')}(?:[-—–]+|будут|есть)[\s~]*{_SOME_RU}"
    r"решени[яе]\s+"
    r"(?P<which_ru>этого\s+(?:же\s+)?уравнения|(?:уравнения[\s~]*)?\(?\\(?:eq)?ref\b)",
    re.IGNORECASE,
)
"""Words that name solutions of an equation."""


def rows_of_solutions(
    paper: SourcePaper, rows: Sequence[SourceStatement]
) -> Iterator[SourceStatement]:
    """The equation of each solution that words name, which is that of what they cite.

    It is an equation for one variable, in which nothing else moves.
    """
    text = paper.prose.text
    for found in _SOLUTIONS.finditer(text, paper.prose.start):
        start, end = found.span("list" if found["list"] else "list_ru")
        named = [one for one in paper.items if start <= one.typed.start < end]
        row = _equation(found, named, paper, rows)
        names = [one.formula.name for one in named if isinstance(one.formula, Name)]
        met = {name for one in paper.items if one.typed.start < start for name in one.names}
        if row is None or len(names) < len(named) or met & {*names}:
            continue
        assert row.formula is not None
        ((own, order),) = row.rates.items()
        if any(one.rates == {name: order} for one in rows for name in names):
            continue  # their own equations are printed
        for one, name in zip(named, names, strict=True):
            formula = substitute(row.formula, {own: Name(name)})
            yield unprinted(paper, f"solution-{name}", to_latex(formula), one, SAYS)


def _equation(
    found: re.Match[str],
    named: Sequence[SourceStatement],
    paper: SourcePaper,
    rows: Sequence[SourceStatement],
) -> SourceStatement | None:
    """The equation of which words speak, if it moves one variable by itself."""
    if not named:
        return None
    cited = {one for label in named[0].refs for one in paper.labels.get(label, ())}
    before = [row for row in rows if row.order < named[0].order]
    by_label = "ref" in (found["which"] or found["which_ru"])
    own = [row for row in before if row in cited] if by_label else before[-1:]
    if len(own) != 1 or len(own[0].rates) != 1:
        return None
    moving = {name for row in rows for name in row.rates}
    return own[0] if len(moving & own[0].names) == 1 else None
