r"""A kinetic and a potential energy, of which the difference is the Lagrangian: :math:`T-V`."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.notation import Derivative, Name, Number, Power
from kowalevski_cas.paper.implied import HAMILTONIANS, LAGRANGIANS
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.statements import SourceStatement

_KINETIC = ("T", r"\mathcal{T}")
_POTENTIAL = ("V", "U", r"\Pi", r"\mathcal{V}", r"\mathcal{U}")
_ENERGIES = (*HAMILTONIANS, *LAGRANGIANS, *_KINETIC)
_ENERGY = re.compile(r"\b(?:kinetic|potential|кинетич|потенциальн)", re.IGNORECASE)
_POTENTIAL_ENERGY = re.compile(r"\b(?:potential|потенциал)", re.IGNORECASE)
_OTHERWISE = re.compile(
    r"\b(?:force\s+functions?|temperature|period|tension|силов\w+\s+функци|температур|период|натяжени)",
    re.IGNORECASE,
)
"""Words for what the same letters are elsewhere."""


def two_energies(
    items: Sequence[SourceStatement],
) -> tuple[SourceStatement, SourceStatement] | None:
    """The kinetic and the potential energy, if each is printed once: in one sentence, or named so.

    One is given by squares of velocities, the other one by places.
    """
    kinetic = [one for one in items if _gives(one, _KINETIC) and has_squares_of_rates(one)]
    potential = [one for one in items if _gives(one, _POTENTIAL) and not one.derives]
    if len(kinetic) != 1 or len(potential) != 1 or kinetic[0].section is not potential[0].section:
        return None
    (first,), (second,) = kinetic, potential
    words = f"{first.words} {second.words}"
    if _OTHERWISE.search(words) or cue("denied", words):
        return None
    near = first.sentence == second.sentence
    named = _ENERGY.search(first.before) and _ENERGY.search(second.before)
    return (first, second) if near or named else None


_OF_OTHER = re.compile(
    r"\b(?:effective|reduced|dimensionless|vector|electric|chemical|thermodynamic|stream|per\s+unit|generali[sz]ed)\b"
    r"|\b(?:эффективн|привед[её]нн|безразмерн|векторн|электрическ|обобщ[её]нн)\w*",
    re.IGNORECASE,
)
"""Words for potentials of which the slope is no force."""


def potential_energy(items: Sequence[SourceStatement]) -> SourceStatement | None:
    """The one potential that words call so, where no other energy is printed."""
    found = [one for one in items if _gives(one, _POTENTIAL) and not one.derives]
    named = [one for one in found if _POTENTIAL_ENERGY.search(one.before[-60:])]
    energies = any(_gives(one, _ENERGIES) for one in items)
    if len(found) != 1 or not named or energies:
        return None
    words = found[0].words
    other = _OTHERWISE.search(words) or _OF_OTHER.search(words) or cue("denied", words)
    return None if other else found[0]


def has_squares_of_rates(item: SourceStatement) -> bool:
    """Whether squares of rates stand in what a statement gives."""
    nodes = item.members[-1].nodes()
    squares = (one.base for one in nodes if isinstance(one, Power) and one.exponent == Number(2))
    return any(isinstance(one, Derivative) for one in squares)


def _gives(item: SourceStatement, letters: Sequence[str]) -> bool:
    """Whether a statement gives one of some letters alone, and nothing else."""
    return len(item.members) == 2 and item.members[0] in [*map(Name, letters)]


def is_named(potential: SourceStatement) -> bool:
    """Whether its letter, or words, call it an energy: U alone may be a function of forces."""
    return "U" not in potential.bare[0] or bool(_POTENTIAL_ENERGY.search(potential.before))
