r"""Rates that a paper says otherwise: by columns, matrices, differentials, complex amplitudes.

From :math:`\dot L=[L,A]` follow the rates of entries, from :math:`i\dot a=\bar ab` that of
:math:`\bar a`. A chain :math:`dx/P=dy/Q=dz/R` says how x, y, z move by a time that
is not printed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import (
    Constant,
    Formula,
    Name,
    PoissonBracket,
    Vector,
    equal,
    read,
    to_latex,
)
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.amplitudes import UNIT, conjugate_equations, conjugate_name
from kowalevski_cas.paper.columns import equations_by_entries
from kowalevski_cas.paper.differentials import differentials, rates
from kowalevski_cas.paper.matrix_equations import equations_of_entries
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.phrases import supposing
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement, is_closing
from kowalevski_cas.reading.unprinted import definitions_below

SOURCE = "the equation that says it"


def rows_of_columns(paper: SourcePaper, item: SourceStatement) -> Iterator[SourceStatement]:
    """The equations between the entries of columns with rates; a statement itself if it has none.

    A matrix may have a letter that the same sentence gives.
    """
    found: list[SourceStatement] = []
    nodes = item.formula.nodes() if item.formula is not None and item.derives else ()
    if item.formula is not None and any(isinstance(node, Vector) for node in nodes):
        given = {
            one.members[0].name: one.members[1]
            for one in paper.items
            if one.sentence == item.sentence and len(one.members) == 2
            if isinstance(one.members[0], Name) and isinstance(one.members[1], Vector)
        }
        with suppress(Meaningless):
            equations = equations_by_entries(item.formula, given, paper.words)
            found = [_row(paper, item, k, to_latex(one)) for k, one in enumerate(equations, 1)]
    yield from found or [item]


def row_of_value(paper: SourcePaper, item: SourceStatement) -> SourceStatement:
    r"""An equation of a rate with its value behind it, as :math:`p=mr^2\dot\varphi=\mathrm{const}`.

    Any other statement is left alone.
    """
    kept = [member for member in item.members if not isinstance(member, Constant)]
    if item.rates and len(kept) == 2 and isinstance(kept[0], Name):
        return _row(paper, item, 1, to_latex(equal(kept[1], kept[0])))
    return item


def rows_of_matrices(
    paper: SourcePaper, rows: list[SourceStatement]
) -> dict[SourceStatement, list[SourceStatement]]:
    """The rates of the entries, for each row of a matrix that is given by them.

    A row whose entries move by themselves has none: it is claimed. One by which they are not
    determined has none, and its ``trouble`` says why.
    """
    found: dict[SourceStatement, list[SourceStatement]] = {}
    own = [row for row in rows if {*row.rates} & paper.words.matrices]
    for row in own:
        if row in found:
            continue
        together = [one for one in own if one.sentence == row.sentence]
        about = dict.fromkeys(i for one in together for i in definitions_below(one, paper))
        given = [one for one in about if one.printed.heads.matrix]
        if not given:
            continue
        by_rows = {name for one in given for name in one.printed.heads.names}
        about = {
            one: None
            for one in about
            if one in given or by_rows.isdisjoint(one.printed.heads.names)  # it is claimed
        }
        general = (one for one in about if one.order < row.order or not supposing(one))
        about = dict.fromkeys(_one_of_each(general, row))
        names = {name for one in given for name in one.names}
        if _are_rated(names, row, [one for one in rows if one not in own]):
            found |= {one: [] for one in together}
            continue
        try:
            tex = [*equations_of_entries(_formulas([*together, *about]), "t")]
            own_rates = [_row(paper, row, number, one) for number, one in enumerate(tex, 1)]
        except (ValueError, Meaningless) as error:
            row.trouble, own_rates = str(error), []
        found |= {one: own_rates if one is row else [] for one in together}
    return found


def _are_rated(names: set[str], row: SourceStatement, others: Iterable[SourceStatement]) -> bool:
    r"""Whether rates of names in matrices are printed before a row for these, or all behind it.

    Behind it, :math:`\dot M_{12}=\ldots` with other elements on the right says how one moves. If
    words call the row the equations of motion, they have to say so of what is behind it.
    """
    printed = [one for one in others if names & {*one.rates}]
    if any(one.order < row.order for one in printed):
        return True
    of_motion = cue("system", row.before)
    printed = [one for one in printed if cue("system", one.before) or not of_motion]
    printed = [one for one in printed if not _has_brackets(one)]
    rated = {name for one in printed for name in one.rates}
    letters = {symbol(name).head for name in rated}
    needed = {name for one in printed for name in one.names & names}
    return bool(rated) and all(symbol(name).head not in letters for name in needed - rated)


def _has_brackets(item: SourceStatement) -> bool:
    nodes = item.formula.nodes() if item.formula is not None else ()
    return any(isinstance(node, PoissonBracket) for node in nodes)


def _one_of_each(
    items: Iterable[SourceStatement], row: SourceStatement
) -> Iterator[SourceStatement]:
    """The statements that give names: the last to the end of a sentence, or the first behind it."""
    end = row.sentence[1]
    ordered = sorted(items, key=lambda one: one.order)
    before = [one for one in ordered if one.typed.start < end]
    given = set[str]()
    for one in (*reversed(before), *(one for one in ordered if one.typed.start >= end)):
        names = {*one.printed.heads.names}
        if not names or names - given:
            yield one
        given |= names


def rows_of_differentials(paper: SourcePaper) -> Iterator[SourceStatement]:
    """The rates for each chain of differentials; one that gives another time gives no rate."""
    for item in paper.items:
        if item.other_time in paper.words.times:
            continue
        if item.formula is not None and differentials(item.formula):
            for number, tex in enumerate(rates(item.formula), 1):
                yield _row(paper, item, number, tex)


def rows_of_conjugates(
    paper: SourcePaper, rows: list[SourceStatement]
) -> Iterator[SourceStatement]:
    """The rates of the conjugates of what moves by equations with the imaginary unit."""
    if not any(UNIT in row.names for row in rows):
        return
    # that a name has the value of another one, at some place, closes no chain
    still = (one for one in paper.items if len(one.bare) < 2 or is_closing(one))
    aside = [one.formula for one in still if one.formula is not None and not one.rates]
    formulas = [row.formula for row in rows if row.formula is not None]
    moving = {name for row in rows for name in row.rates}
    of = {conjugate_name(name): row for row in rows for name in row.rates}
    for number, tex in enumerate(conjugate_equations([*formulas, *aside], moving), 1):
        names = read(tex, paper.words, OpenParser).names() & of.keys()
        if names:
            by = of[min(names, key=lambda name: of[name].order)]
            yield _row(paper, by, number, tex)


def _formulas(items: list[SourceStatement]) -> dict[Printed, Formula]:
    return {one.printed: one.formula for one in items if one.formula is not None}


def _row(paper: SourcePaper, by: SourceStatement, number: int, tex: str) -> SourceStatement:
    """An equation of motion that a row says, in its place."""
    display = Display(
        f"{by.printed.display.id}-rate-{number}", tex, by.printed.display.section, source=SOURCE
    )
    formula = read(tex, paper.words, OpenParser)
    return replace(by, printed=display[1], formula=formula, implied_by=by)
