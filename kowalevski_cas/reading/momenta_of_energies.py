r"""Momenta of coordinates: :math:`p_x` is :math:`\partial L/\partial\dot x`.

In new coordinates it is :math:`p_\xi=p_x\,\partial x/\partial\xi+p_y\,\partial y/\partial\xi`. What
words call a momentum has its name by its equation, and that it is the one of its coordinate is
claimed of it.
"""

from __future__ import annotations

import re
from contextlib import suppress

from kowalevski_cas.notation import Name, to_latex
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.implied import LAGRANGIANS, conjugate_pairs
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.in_words import is_unsure
from kowalevski_cas.reading.known import CLAIM, DEFINITION, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.two_energies import has_squares_of_rates
from kowalevski_cas.reading.unprinted import gives_lagrangian, unprinted

OF_COORDINATE = "momentum"
"""The kind of these claims."""

_MOMENTUM = re.compile(r"\b(?:moment(?:um|a)|conjugate)\b|\b(?:импульс|сопряж[её]нн)\w*", re.I)
_OTHER = re.compile(
    r"\b(?:linear|total|angular|kinetic|mechanical|instead|new|scaled|dimensionless|rescaled|per|unit"
    r"|конечн|момент\s+импульса|полн)\w*",
    re.IGNORECASE,
)
"""Words for a momentum that need not be the one of a coordinate."""


def momentum(item: SourceStatement, known: Known) -> StatementRole | None:
    """What gives the momentum of a coordinate, behind a Lagrangian or a change of coordinates."""
    if not _MOMENTUM.search(item.words) or _OTHER.search(item.words) or is_unsure(item.words):
        return None
    if len(item.members) != 2 or not item.bare or item.members[0] != Name(item.bare[0]):
        return None
    if known.is_defined(item.bare[0]) or symbol(item.bare[0]).letter not in ("p", "P"):
        return None
    if not (_by_velocity(item, known) or momentum_by_change(item.bare[0], known)):
        return None
    return StatementRole(CLAIM, "words call it a momentum", OF_COORDINATE, item.bare[:1])


def equation_of_momentum(item: SourceStatement, known: Known) -> SourceStatement:
    """That a momentum is a derivative of the Lagrangian, or that of a change of coordinates."""
    tex = f"{item.bare[0]}={_by_velocity(item, known) or momentum_by_change(item.bare[0], known)}"
    return unprinted(known.paper, f"momentum-{item.order}", tex, item, "its coordinate")


def _by_velocity(item: SourceStatement, known: Known) -> str:
    """The derivative of the Lagrangian by the velocity of the coordinate with an index.

    Without an index it is the only one; empty if there is none, or more than one Lagrangian.
    """
    before = [one for one in known.items if one.order < item.order]
    given = [one for one in before if is_lagrangian(one, known) or _ends_with_one(one, known)]
    parts = symbol(item.bare[0])
    if len(given) != 1:
        return ""
    coordinates = [
        name
        for name in known.names.scalars(given[0].rates)
        if not parts.index or parts.index in (name, symbol(name).index)
    ]
    letter, last = given[0].bare[0], to_latex(given[0].members[-1])
    [name] = coordinates if len(coordinates) == 1 else [""]
    if name and len(given[0].members) > 2:
        return rf"\frac{{\partial}}{{\partial \dot{{{name}}}}}\left({last}\right)"
    return rf"\frac{{\partial {letter}}}{{\partial \dot{{{name}}}}}" if name else ""


def momentum_by_change(name: str, known: Known) -> str:
    """The momentum of a new coordinate with an index by those of the coordinates it gives."""
    index = symbol(name).index
    for law in known.laws:
        new = [name for name in law.new if index in (name, symbol(name).index)]
        if not law.base or len(new) != 1:
            continue
        momenta: dict[str, str] = {}
        with suppress(ValueError):
            momenta = dict(conjugate_pairs(sorted(law.base.variables)))
        old = {one.bare[0]: one.members[1] for one in law.change}
        if momenta.keys() == old.keys():
            parts = (
                rf"{momenta[x]}\frac{{\partial}}{{\partial {new[0]}}}\left({to_latex(by)}\right)"
                for x, by in old.items()
            )
            return "+".join(parts)
    return ""


def _ends_with_one(item: SourceStatement, known: Known) -> bool:
    """Whether a chain that words call the Lagrangian ends with it in coordinates and velocities."""
    role = known.roles.get(item)
    named = role is not None and role.name == CLAIM and role.names == item.bare[:1]
    called = cue("hamiltonian", item.words) and item.bare[:1] and item.bare[0] in LAGRANGIANS
    return named and len(item.members) > 2 and bool(called) and has_squares_of_rates(item)


def is_lagrangian(item: SourceStatement, known: Known) -> bool:
    """Whether a definition gives the letter of a Lagrangian by squares of velocities."""
    role = known.roles.get(item)
    if role is None or role.name != DEFINITION or not item.bare or len(item.members) != 2:
        return False
    called = cue("hamiltonian", item.words) and item.bare[0] in LAGRANGIANS
    return gives_lagrangian(item) or bool(called and has_squares_of_rates(item))
