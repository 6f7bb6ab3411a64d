r"""Momenta of a paper: :math:`\mathbf M=I\boldsymbol\omega`, beside :math:`\dot{\mathbf M}=\ldots`.

The rate of a vector is printed, and the vector is given by another one that has no rate: this one
moves, wherever in the paper the first is given.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kowalevski_cas.notation import Name, Number, Vector
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourceStatement


def find_momenta(
    items: Sequence[SourceStatement], rows: Sequence[SourceStatement], names: Names
) -> dict[SourceStatement, str]:
    r"""The statements that give a vector with a printed rate by one that has none, with this one.

    Where each of the two is given by the other, the first that is printed counts; what another
    section says of it is a special case. A rate of the one that moves, printed behind, follows
    where it stands in the equation of the first, as in :math:`\dot{\mathbf M}=\mathbf
    M\times\boldsymbol\omega`; else that may be an equation in a fixed frame.
    """
    giving = [one for one in items if _gives(one)]
    found: dict[SourceStatement, str] = {}
    for one in giving:
        name = one.bare[0]
        if name in names.vectors and name not in found.values():
            others = (
                other
                for other in giving
                if other.order < one.order
                or (one.section in other.sections and not _has(other, name))
            )
            given = {other.bare[0] for other in others}
            own = [*_rows_of(name, rows, names)]
            own = own if any(not row.typed.inline for row in own) else []  # else it is claimed
            beside = [row for row in rows for at in own[:1] if at.section in row.sections]
            in_law = {names.whole(n) for row in beside for n in row.names}
            turning = {names.whole(n) for row in own for n in row.names}
            before = [row for row in beside if row.typed.start < own[0].sentence[1]]
            rated = {n for row in beside for n in names.scalars(row.rates)}
            first = {n for row in before for n in names.scalars(row.rates)}
            inner = {names.whole(n) for n in one.members[1].names()}
            unknown = inner & in_law & {*names.vectors} - given - {*_fixed(items, own)}
            unknown = unknown & turning or unknown
            moving = [
                one
                for one in unknown
                if (first if one in turning else rated).isdisjoint(names.scalars([one]))
            ]
            if not rated.isdisjoint(one.members[1].names() - {*names.owner}):
                continue  # other letters move in it
            again = any(of.bare[0] == name and of.section in one.sections for of in found)
            told = {n for row in own for n in names.scalars(row.rates)}
            if {*names.vectors[name]} <= told and len(moving) == 1 and not again:
                found[one] = moving[0]
    return found


def _gives(item: SourceStatement) -> bool:
    """Whether a statement has a name alone on its left, and an expression on its right."""
    if len(item.members) != 2 or item.rates or not item.bare or cue("if", item.lead):
        return False
    if cue("equilibrium", item.before):
        return False  # so it is there only
    match item.members:
        case (Name(), Name()):
            return False
        case (Name(), Vector(entries)):
            return not all(isinstance(entry, Name | Number) for entry in entries)
    return isinstance(item.members[0], Name)


def _fixed(items: Iterable[SourceStatement], rows: Sequence[SourceStatement]) -> Iterator[str]:
    """The vectors of which numbers are the components, before some equations of motion."""
    for one in items:
        match one.members:
            case (Name(name), Vector(entries)) if all(isinstance(e, Number) for e in entries):
                yield from [name] if rows and one.order < rows[0].order else ()


def _has(item: SourceStatement, name: str) -> bool:
    """Whether a name stands in what a statement gives."""
    return name in item.members[1].names()


def _rows_of(
    vector: str, rows: Iterable[SourceStatement], names: Names
) -> Iterator[SourceStatement]:
    """The equations of motion for a vector, or for its components."""
    parts = {*names.vectors[vector]}
    yield from (row for row in rows if parts & {*names.scalars(row.rates)})
