"""Equations of motion that are those of another system than the ones before them."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.printed_rates import PrintedRates, is_averaged
from kowalevski_cas.reading.reactions import constrains
from kowalevski_cas.reading.rows import binds_velocities
from kowalevski_cas.reading.statements import SourceStatement

_FOLLOWS = re.compile(
    r"\b(?:substitut\w+|eliminat\w+|differentiat\w+|see|follows?|hence|therefore|thus|consequently"
    r"|подстав\w+|исключ\w+|дифференцир\w+|видим|следует|отсюда|поэтому|следовательно)\b",
    re.IGNORECASE,
)
"""Words that derive equations from those before."""


def other_system(rates: PrintedRates, item: SourceStatement, part: Sequence[Law]) -> Law | None:
    """A set that is closed by itself, with words for it, or in another section.

    In another section it follows from nothing, and is for names that are not defined by those
    of the law before, nor rest on them.
    """
    before = part[0].first
    beside = stands_beside(rates, item, part)
    titled = before.section is not item.section and cue("another system", item.section.title)
    said = cue("another system", item.before) or titled or beside
    apart = [one for one in item.sections if one not in before.sections]
    new = bool(apart) and before.section not in item.sections
    if (item.refs and not cue("another system", item.before)) or not (new or said):
        return None
    begins = _begins(rates, item, apart[0].start) if apart else item.sentence[0]
    begins = item.typed.start if beside else begins
    end = apart[0].end if apart else item.section.end
    printed_rows = (row for row in rates.undefined(begins) if row not in rates.said.rows)
    rows = [row for row in printed_rows if begins <= row.typed.start < end]
    own = {row for row in rates.rows if row.typed is item.typed}
    given = {row: one for row in own for one in _giving(rates, row, own)}
    rows, own = [row for row in rows if row not in given], own - given.keys()
    law = rates.grown(item, (), rows) if own <= {*rows} else None
    if law is None:
        return None
    if all(rates.is_defined(row, item.section.start) for row in own):
        return None  # it is deduced for names that stand for what moves
    old = {name for one in part for name in one.variables}
    rated, named = {*law.variables}, {*rates.names.scalars(law.mentions)}
    met = {name for one in rates.paper.items if one.typed.start < begins for name in one.names}
    anew = bool(said or (named - met and cue("system", item.before)))
    if not _FOLLOWS.search(item.before):
        anew = anew or _is_of_new_constants(rates, law, part, named - met)
    deduced = cue("deduced", item.before) and not anew
    printed = {row.formula for one in part for row in one.rows}
    if named & old - rated or (deduced and rated <= old):
        return None
    heading = apart[0].start if apart else begins
    since = (
        one
        for one in _since(rates, heading, item)
        if one not in law.momenta and not len(one.bare) == len(one.members) == 2
    )  # a new letter for what moved before is that of the new system
    if not said and any(rates.relates(one, item, old) for one in since):
        return None
    if not said and len(law.items) == 1 and rated < old:  # what follows for one of several
        return None
    if all(row.formula in printed for row in law.items):
        return None
    if not said and all(rates.is_defined(row, rates.paper.prose.start) for row in law.items):
        return None
    between = [one for one in rates.paper.items if begins <= one.typed.start < item.typed.start]
    speaks = any({*rates.names.scalars(one.names)} & old - rated for one in between)
    law.begins = item.sentence[0] if speaks and not beside else begins
    law.begins = min((law.begins, *(one.sentence[0] for one in given.values())))
    return law


def _giving(
    rates: PrintedRates, row: SourceStatement, beside: Collection[SourceStatement]
) -> list[SourceStatement]:
    r"""What gives, below the same heading, what a row derives by what others beside it do.

    So does :math:`r=a(1-e\cos E)` before rates of E and r; a constraint does not.
    """
    moving = {name for one in beside if one is not row for name in one.rates} - {*row.rates}
    headed = [one for one in row.sections if not one.is_run_in]
    return [
        one
        for name in row.rates
        for one in rates.defining.get(name, ())
        if one.order < row.order
        and not constrains(one, row, beside)
        and [part for part in one.sections if not part.is_run_in] == headed
        and not moving.isdisjoint(one.names - {name})
    ]


def stands_beside(rates: PrintedRates, item: SourceStatement, part: Sequence[Law]) -> bool:
    """Whether only “and” stands between a display and that of a law for the same letters."""
    if item.typed.inline or not _AND.fullmatch(item.lead):
        return False
    rated = {name for row in rates.rows if row.typed is item.typed for name in rates.scalars(row)}
    return any(
        {row.typed for row in law.items} == {law.first.typed}
        and law.first.sentence == item.sentence
        and {*law.variables} == rated
        and law.first.typed.end <= item.typed.start
        for law in part
    )


_AND = re.compile(r"[\s,;~]*(?:and|и|as\s+well\s+as)[\s:,~]*", re.IGNORECASE)


def averaged_system(rates: PrintedRates, item: SourceStatement) -> Law | None:
    """A set that is closed by itself and that words call the average of equations before it.

    It has letters for means, even where these are the letters of what moved before.
    """
    if not is_averaged(item):
        return None
    begins, end = item.sentence[0], item.section.end
    rows = [row for row in rates.undefined(begins) if begins <= row.typed.start < end]
    law = rates.grown(item, (), rows) if item in rows else None
    if law is not None:
        law.begins, law.is_averaged = begins, True
    return law


def _is_of_new_constants(
    rates: PrintedRates, law: Law, part: Sequence[Law], new: Collection[str]
) -> bool:
    """Whether the rates of all that moved are given with new letters, which nothing gives.

    They do not follow from the law before, which has nothing of them.
    """
    orders, before = (
        {name: order for one in laws for row in one.rows for name, order in row.rates.items()}
        for laws in ([law], part)
    )
    read = (one for one in rates.paper.items if one.formula is not None)
    given = {name for one in read for name in one.printed.heads.names}
    return orders == before and bool({*new} - given)


def _begins(rates: PrintedRates, row: SourceStatement, heading: int) -> int:
    """Where another system begins: at its heading, unless rates stand between, as of this.

    Those of constraints of velocities are its own.
    """
    since = (one for one in _since(rates, heading, row) if one.typed is not row.typed)
    between = any(one.rates and not binds_velocities(one, rates.rows) for one in since)
    return row.sentence[0] if between else heading


def _since(rates: PrintedRates, begins: int, row: SourceStatement) -> list[SourceStatement]:
    """The statements from an offset on, before a row."""
    return [one for one in rates.paper.items if begins <= one.typed.start and one.order < row.order]
