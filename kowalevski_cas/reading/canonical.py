r"""Energies in other letters: the Hamiltonian by :math:`T+V`, and momenta by the kinetic energy.

Where the law is one of coordinates and velocities a paper prints the Hamiltonian in momenta: it is
claimed to be :math:`T+V`. Where the law is that of a Hamiltonian, the kinetic energy in new
coordinates is claimed to be :math:`\frac12\sum p\dot q`. A momentum :math:`p_\xi` of which nothing
is printed is :math:`\partial T/\partial\dot\xi`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress

from kowalevski_cas.notation import Derivative, Formula, Name, substitute, to_latex
from kowalevski_cas.notation.symbol import rate_name, symbol
from kowalevski_cas.paper.implied import HAMILTONIANS, canonical_pairs
from kowalevski_cas.paper.slopes import derived
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading.fresh import is_fresh
from kowalevski_cas.reading.kinetic import KINETIC, kinetic_energies
from kowalevski_cas.reading.known import CLAIM, CONVENTION, Known, StatementRole
from kowalevski_cas.reading.momenta_of_energies import momentum_by_change
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

ENERGY, MOMENTUM = "energy", "momentum"
"""The kinds of such claims, and of conventions by which a momentum is known."""
_POTENTIAL = ("V", "U", r"\Pi")
_HAMILTONIAN = re.compile(
    r"\b(?:Hamiltonian|Hamilton['’]?s?\s+function|function\s+of\s+Hamilton|гамильтониан\w*"
    r"|функци\w+\s+Гамильтона)(?:\s+(?:function|is|reads|becomes|has\s+the\s+form|име\w+\s+вид|равна?|then|now)){0,3}[\s:,~—-]*$",
    re.IGNORECASE,
)
_ENERGY = re.compile(
    r"\b(?:kinetic\s+energy|кинетическ\w+\s+энерги\w+)(?:\s+(?:is|becomes|reads|equals|takes\s+the\s+form|is\s+found\s+to\s+be"
    r"|име\w+\s+вид|равна))?[\s:,~—-]*$",
    re.IGNORECASE,
)


def energy(item: SourceStatement, known: Known) -> StatementRole | None:
    """An energy that is printed in letters in which it was not given: it is claimed to be that."""
    name = item.bare[0] if item.bare else ""
    if not (name and is_fresh(name, item, known) and meant(item, known)):
        return None
    return StatementRole(CLAIM, "the energy in other letters", ENERGY, (name,))


def meant(item: SourceStatement, known: Known) -> str:
    """What such an energy is claimed to be, as an equation; empty if it is none."""
    if len(item.members) != 2 or not item.bare or item.members[0] != Name(item.bare[0]):
        return ""
    name = item.bare[0]
    momenta = [n for n in item.names if symbol(n).letter == "p" and not known.moves(n)]
    if name in HAMILTONIANS and momenta and not item.derives and _HAMILTONIAN.search(item.lead):
        return _as_sum(name, item, known)
    if name in KINETIC and _ENERGY.search(item.lead):
        new = [one for one in item.rates if known.is_defined(one) and known.varies(one)]
        pairs = [
            pair
            for law in known.laws
            for pair in canonical_pairs([row.formula for row in law.rows if row.formula])
        ]
        if new and pairs:
            return f"{name}=\\frac12({'+'.join(f'{p}{rate_name(q)}' for q, p in pairs)})"
    return ""


def _as_sum(name: str, item: SourceStatement, known: Known) -> str:
    """That a Hamiltonian is the sum of the energies that are printed before it."""
    found = []
    for letters, derives in ((KINETIC, True), (_POTENTIAL, False)):
        given = [(one, known.definition(one, item)) for one in letters]
        fit = [
            n
            for n, by in given
            if by is not None and by.order < item.order and by.derives is derives
        ]
        found += fit[:1]
    return f"{name}={'+'.join(found)}" if len(found) == 2 else ""


def momenta(known: Known, suffix: str) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """The momenta that nothing gives, of coordinates in which a kinetic energy is printed.

    Or of new coordinates, in which a Hamiltonian is: these are momenta of a point transformation.
    """
    names = frozenset().union(*(one.names for one in known.items))
    for name in sorted(names):
        printed, coordinate = kinetic_energies(name, known), symbol(name).index
        if known.is_defined(name) or known.moves(name):
            continue
        changed = symbol(name).letter in ("p", "P") and name not in known.later
        if not printed and changed and (by := momentum_by_change(name, known)):
            beside = next(one for one in known.items if name in one.names)
            id = re.sub(r"\W+", "-", f"momentum-{name}{suffix}")
            item = unprinted(known.paper, id, f"{name}={by}", beside, "its coordinate")
            yield item, StatementRole(CONVENTION, "the momentum of a new coordinate", "", (name,))
        if len(printed) != 1:
            continue
        with suppress(Meaningless):
            slope = _slope(printed[0].members[-1], coordinate)
            id = re.sub(r"\W+", "-", f"momentum-{name}{suffix}")
            item = unprinted(known.paper, id, f"{name}={to_latex(slope)}", printed[0])
            yield item, StatementRole(CONVENTION, "a momentum", MOMENTUM, (name,))


def _slope(energy: Formula, coordinate: str) -> Formula:
    """The derivative of an energy by the velocity of a coordinate."""
    rates: dict[str, Formula] = {}

    def named(part: Formula) -> Formula:
        match part:
            case Derivative(Name(name)):
                rates[f"rate({name})"] = part
                return Name(f"rate({name})")
        return part.map_children(named)

    return substitute(derived(named(energy), f"rate({coordinate})"), rates)
