r"""A motion on N⁴: its constants, its regime, and where it is at t = 0.

The closed form in the time t − t_j, with signs ±1 that choose the torus where there are
several, is the motion; :func:`~kowalevski_cas.motion.point.through` finds them for a state.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.regimes import Arc, Regime, regime_of


@dataclass(frozen=True)
class Motion:
    """A motion by its constants and phases.

    ``origins`` are the times t1, t2 at which s1 and s2 are at the first root p of their
    arcs (see :mod:`~kowalevski_cas.motion.oscillation`). ``signs`` are those of S1 and S2 just
    after t1 and t2: where an arc has two components they choose the torus, elsewhere the other
    sign is the same motion half a period later.
    ``arcs`` are those that the regime does not tell: of a variable that stays on a double root,
    or goes down from the upper of two.
    ``turn`` is (cos χ, sin χ) of the rotation that brings (α, β) = c to zero. ``point`` is the
    state at t = 0 from which integrators start, where it is not that of the closed form, which
    is ``off`` it by so much of its size (ω and fields each of their own).

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` where there is no motion.
    """

    parameters: Parameters
    origins: tuple[Fraction, Fraction] = (Fraction(0), Fraction(0))
    signs: tuple[int, int] = (1, 1)
    arcs: tuple[Arc | None, Arc | None] = (None, None)
    turn: tuple[Fraction, Fraction] = (Fraction(1), Fraction(0))
    point: tuple[float, ...] | None = None
    off: float = 0.0

    def __post_init__(self) -> None:
        """Refuse constants that leave no real motion."""
        _ = self.regime

    @cached_property
    def regime(self) -> Regime:
        """The regime of its constants."""
        return regime_of(self.parameters)

    def oscillations(self) -> tuple[Oscillation, Oscillation]:
        """The separated equations, solved anew at the precision of FLINT's context."""
        first, second = self.arcs
        return (
            Oscillation(self.parameters, first or self.regime.s1, True),
            Oscillation(self.parameters, second or self.regime.s2, False),
        )
