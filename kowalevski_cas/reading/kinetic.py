"""Kinetic energies that a paper prints, by which it means momenta as well."""

from __future__ import annotations

from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.implied import LAGRANGIANS
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.statements import SourceStatement

KINETIC = ("T",)
_ACTIONS = [[(letter,) for letter in letters] for letters in (LAGRANGIANS, KINETIC)]


def has_momentum(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a name is the momentum of a new coordinate, by what is printed before."""
    parts = symbol(name)
    new = known.is_defined(parts.index) and not known.moves(parts.index)
    return bool(new and [one for one in kinetic_energies(name, known) if one.order < item.order])


def kinetic_energies(name: str, known: Known) -> list[SourceStatement]:
    """The kinetic energies that are printed in the velocity of the coordinate of a momentum.

    A Lagrangian in this velocity comes before: it may have other terms that are linear in it.
    """
    parts = symbol(name)
    if parts.letter != "p" or not parts.index or not known.varies(parts.index):
        return []
    given = [one for one in known.items if parts.index in one.rates and one.members]
    found = ([one for one in given if one.bare[:1] in heads] for heads in _ACTIONS)
    return next(filter(None, found), [])
