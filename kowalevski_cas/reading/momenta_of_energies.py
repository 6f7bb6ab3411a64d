r"""Momenta by a Lagrangian: :math:`p_x` is :math:`\partial L/\partial\dot x`.

What words call a momentum has its name by its equation, and that it belongs to the Lagrangian is
claimed of it.
"""

from __future__ import annotations

import re

from kowalevski_cas.notation import Name
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.implied import LAGRANGIANS
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.in_words import is_unsure
from kowalevski_cas.reading.known import CLAIM, DEFINITION, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.two_energies import has_squares_of_rates
from kowalevski_cas.reading.unprinted import gives_lagrangian, unprinted

OF_LAGRANGIAN = "momentum"
"""The kind of these claims."""

_MOMENTUM = re.compile(r"\b(?:moment(?:um|a)|conjugate)\b|\b(?:импульс|сопряж[её]нн)\w*", re.I)
_OTHER = re.compile(
    r"\b(?:linear|total|angular|kinetic|mechanical|instead|new|scaled|dimensionless|rescaled|per|unit"
    r"|конечн|момент\s+импульса|полн)\w*",
    re.IGNORECASE,
)
"""Words for a momentum that need not be the one of a coordinate."""


def momentum(item: SourceStatement, known: Known) -> StatementRole | None:
    """What gives the momentum of a coordinate, behind the only Lagrangian."""
    if not _MOMENTUM.search(item.words) or _OTHER.search(item.words) or is_unsure(item.words):
        return None
    if len(item.members) != 2 or not item.bare or item.members[0] != Name(item.bare[0]):
        return None
    if known.is_defined(item.bare[0]) or not _derivative(item, known):
        return None
    says = "words call it a momentum: the Lagrangian has it"
    return StatementRole(CLAIM, says, OF_LAGRANGIAN, item.bare[:1])


def equation_of_momentum(item: SourceStatement, known: Known) -> SourceStatement:
    """That a momentum is the derivative of the Lagrangian by a velocity."""
    tex = f"{item.bare[0]}={_derivative(item, known)}"
    return unprinted(known.paper, f"momentum-{item.order}", tex, item, "the Lagrangian")


def _derivative(item: SourceStatement, known: Known) -> str:
    """The derivative of the Lagrangian by the velocity of the coordinate with an index.

    Without an index it is the only one; empty if there is none, or more than one Lagrangian.
    """
    given = [one for one in known.items if one.order < item.order and _is_lagrangian(one, known)]
    parts = symbol(item.bare[0])
    if len(given) != 1 or parts.letter not in ("p", "P"):
        return ""
    coordinates = [
        name
        for name in known.names.scalars(given[0].rates)
        if not parts.index or parts.index in (name, symbol(name).index)
    ]
    letter = given[0].bare[0]
    [name] = coordinates if len(coordinates) == 1 else [""]
    return rf"\frac{{\partial {letter}}}{{\partial \dot{{{name}}}}}" if name else ""


def _is_lagrangian(item: SourceStatement, known: Known) -> bool:
    """Whether a definition gives the letter of a Lagrangian by squares of velocities."""
    role = known.roles.get(item)
    if role is None or role.name != DEFINITION or not item.bare or len(item.members) != 2:
        return False
    called = cue("hamiltonian", item.words) and item.bare[0] in LAGRANGIANS
    return gives_lagrangian(item) or bool(called and has_squares_of_rates(item))
