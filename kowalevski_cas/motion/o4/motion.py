r"""A motion on O⁴: its constants, its regime, and where it is at t = 0."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.regimes import Arc, Regime, regime_of


@dataclass(frozen=True)
class MotionO4:
    """A motion by its constants, the two angles at t = 0, and the signs of radicals.

    The angles say where u1 and u2 are on their arcs (see
    :mod:`~kowalevski_cas.motion.o4.variable`), the ``signs`` which torus is meant and which of its
    points (see :class:`~kowalevski_cas.motion.o4.point.PhasePoint`). ``turn`` is (cos χ, sin χ) of
    the rotation that brings (α, β) = c to zero. ``point`` is the state at t = 0 from which
    integrators start, where it is not that of the closed form, which is ``off`` it by so much of
    its size.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` where there is no motion.
    """

    constants: ParametersO4
    angles: tuple[Fraction, Fraction] = (Fraction(0), Fraction(0))
    signs: tuple[int, ...] = (1, -1, 1, 1, 1)
    turn: tuple[Fraction, Fraction] = (Fraction(1), Fraction(0))
    point: tuple[float, ...] | None = None
    off: float = 0.0

    def __post_init__(self) -> None:
        """Refuse constants that leave no real motion, and signs for which E² is negative."""
        _ = self.regime

    @cached_property
    def regime(self) -> Regime:
        """The regime of its constants."""
        return regime_of(self.constants)

    @property
    def arcs(self) -> tuple[Arc, Arc]:
        """The arcs of u1 and u2."""
        return self.regime.u1, self.regime.u2

    @property
    def orientations(self) -> tuple[int, int]:
        """The signs with which the differentials of u1 and of u2 go into the quadratures."""
        K1, mu2, A2, B2, K2 = self.signs
        return K1, -mu2 * A2 * B2 * K2
