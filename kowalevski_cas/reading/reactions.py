r"""Reactions: forces of which nothing is said but what they keep.

So is the tension in :math:`m_1\ddot x=m_1g-T,\ m_2\ddot x=T-m_2g`. A letter of a force that stands
in several equations of a sentence is one, where a further equation binds what moves in these: a
constraint, or a second equation for the same acceleration.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from kowalevski_cas.notation import Name, Negative, Sum
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.constraints import MULTIPLIERS
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.rows import BINDING
from kowalevski_cas.reading.statements import SourceStatement

LETTERS = ("T", "N", "F", "f", "S", "R")
"""The letters of such forces."""


def reactions(rows: Sequence[SourceStatement], items: Iterable[SourceStatement]) -> tuple[str, ...]:
    """The letters of forces in several of some equations of motion that nothing gives before."""
    if not rows:
        return ()
    rated = {name for row in rows for name in row.rates}
    first = min(row.order for row in rows)
    given = {
        one.bare[0]
        for one in items
        if one.order < first and one.bare and one.members[0] == Name(one.bare[0])
    }
    names = sorted({name for row in rows for name in row.names} - rated - given)
    return tuple(
        name
        for name in names
        if symbol(name).letter in LETTERS
        and sum(name in row.names for row in rows) > 1
        and any(_is_term(name, row) for row in rows)
    )


def _is_term(name: str, row: SourceStatement) -> bool:
    """Whether a letter is a force by itself in an equation, and multiplies nothing."""
    sides = [
        term
        for member in row.members
        for term in (member.terms if isinstance(member, Sum) else (member,))
    ]
    return any(term in (Name(name), Negative(Name(name))) for term in sides)


def is_reacting(one: SourceStatement, row: SourceStatement) -> bool:
    r"""Whether a force that is alone on a side of a row stands in an equation for another name.

    That is one of its display, or sentence, as in :math:`m\ddot x=R,\ I\ddot\varphi=M-aR`; one of
    them gives an acceleration.
    """
    letters = (*LETTERS, *MULTIPLIERS)
    forces = {name for name in row.bare if one.typed is row.typed or symbol(name).letter in letters}
    orders = {*one.rates.values(), *row.rates.values()}
    return (
        one.sentence == row.sentence
        and max(orders, default=0) > 1
        and not forces.isdisjoint(one.names)
        and one.rates.keys().isdisjoint(row.rates)
    )


def have_multiplier(one: SourceStatement, other: SourceStatement) -> bool:
    r"""Whether two equations of motion, for other names, have the letter of a multiplier.

    So have :math:`m\ddot x=\lambda x,\ m\ddot y=\lambda y`: a constraint may bind both.
    """
    rated = {*one.rates, *other.rates}
    shared = (one.names & other.names) - rated
    apart = {*one.rates}.isdisjoint(other.rates)
    return apart and any(symbol(name).letter in MULTIPLIERS for name in shared)


def constrains(one: SourceStatement, row: SourceStatement, rows: Iterable[SourceStatement]) -> bool:
    r"""Whether what gives a coordinate is a constraint, as :math:`z=x^2/2p`, and no other name.

    A row for it has a multiplier with others of its sentence. Words speak of a constraint, or of
    multipliers, or it ends the display of these rows.
    """
    beside = [other for other in rows if other.sentence == row.sentence and other is not row]
    second = [other for other in beside if {*other.rates.values()} == {2}]
    pulled = {*row.rates.values()} == {2} and any(have_multiplier(row, other) for other in second)
    ends = one.typed is row.typed and one.order > max((r.order for r in (row, *beside)), default=0)
    said = any(cue(name, one.lead) for name in BINDING) or cue("multiplier", row.words)
    return pulled and not one.rates and bool(ends or said)


def is_bound(
    row: SourceStatement, rows: Collection[SourceStatement], items: Iterable[SourceStatement]
) -> bool:
    """Whether other rows of its sentence, with a reaction, say how all moves that a row derives."""
    beside = [one for one in rows if one.sentence == row.sentence and one is not row]
    gives = all(
        any(
            one.rates.get(name, 0) > order
            or (one.rates.get(name, 0) == order and one.order < row.order)
            for one in beside
        )
        for name, order in row.rates.items()
    )
    return bool(row.rates) and gives and bool(reactions([*beside, row], items))
