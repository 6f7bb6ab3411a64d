r"""Matrix equations of motion of a paper, :math:`\dot L=[L,A]`, by the rates of the entries."""

from __future__ import annotations

from dataclasses import replace

from kowalevski_cas.notation import Formula, read
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.paper.matrix_equations import equations_of_entries
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import definitions_below

SOURCE = "an entry of the matrix equation"


def rows_of_matrices(
    paper: SourcePaper, rows: list[SourceStatement]
) -> dict[SourceStatement, list[SourceStatement]]:
    """The rates of the entries, for each row of a matrix that is given by them.

    A row whose entries move already has none: it is claimed. One by which they are not determined
    has none, and its ``trouble`` says why.
    """
    found: dict[SourceStatement, list[SourceStatement]] = {}
    own = [row for row in rows if {*row.rates} & paper.words.matrices]
    rated = {name for row in rows if row not in own for name in row.rates}
    for row in own:
        if row in found:
            continue
        together = [one for one in own if one.sentence == row.sentence]
        about = dict.fromkeys(i for one in together for i in definitions_below(one, paper))
        given = [one for one in about if one.printed.heads.matrix]
        if not given:
            continue
        if rated & {name for one in given for name in one.names}:
            found |= {one: [] for one in together}
            continue
        try:
            tex = [*equations_of_entries(_formulas([*together, *about]), "t")]
            rates = [_row(paper, row, number, one) for number, one in enumerate(tex, 1)]
        except (ValueError, Meaningless) as error:
            row.trouble, rates = str(error), []
        found |= {one: rates if one is row else [] for one in together}
    return found


def _formulas(items: list[SourceStatement]) -> dict[Printed, Formula]:
    return {one.printed: one.formula for one in items if one.formula is not None}


def _row(paper: SourcePaper, by: SourceStatement, number: int, tex: str) -> SourceStatement:
    """An equation of motion that a row says, in its place."""
    display = Display(
        f"{by.printed.display.id}-entry-{number}", tex, by.printed.display.section, source=SOURCE
    )
    formula = read(tex, paper.words, OpenParser)
    return replace(by, printed=display[1], formula=formula, implied_by=by)
