"""A motion on O⁴: its constants, its regime, and where it is at t = 0."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

import numpy as np

from kowalevski_cas.motion.frame import fields, straighten
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.regimes import RegimeO4, regime_of
from kowalevski_cas.motion.parameters import Inadmissible, Real, usable
from kowalevski_cas.motion.regimes import Arc
from kowalevski_cas.motion.units import in_unit, without_unit


@dataclass(frozen=True)
class MotionO4:
    """A motion by its constants, two angles, and the signs of radicals.

    The angles say where u1 and u2 are on their arcs at t = 0 (see
    :mod:`~kowalevski_cas.motion.o4.point`). The ``signs`` are those of K1, μ2, A2, B2, K2 where
    both angles are between 0 and π, the other radicals being positive; they choose the torus, and
    the point on it. ``turn`` is (cos χ, sin χ) of the rotation that brings (α, β) = c to zero.
    ``point`` is the state at t = 0 from which integrators start, where it is not that of the closed
    form, which is ``off`` it by so much of its size.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` where there is no motion.
    """

    parameters: ParametersO4
    angles: tuple[Fraction, Fraction] = (Fraction(0), Fraction(0))
    signs: tuple[int, ...] = (1, -1, 1, 1, 1)
    turn: tuple[Fraction, Fraction] = (Fraction(1), Fraction(0))
    point: tuple[float, ...] | None = None
    off: float = 0.0

    @staticmethod
    def of(
        a: Real,
        b: Real,
        s: Real,
        tau: Real,
        *,
        c: Real = 0,
        angles: Sequence[Real] = (0, 0),
        torus: int = 1,
    ) -> MotionO4:
        """The motion in fields of lengths a, b with the scalar product c, by s and τ.

        ``torus`` is one of those of the regime, numbered from 1. Raises
        :class:`~kowalevski_cas.motion.parameters.Inadmissible` where there is no motion, and
        ``ValueError`` for what is not a finite number.
        """
        longer, shorter, turn = straighten(usable(a), usable(b), usable(c))
        parameters = ParametersO4(longer, shorter, usable(s), usable(tau))
        first, second = map(usable, angles)
        signs = regime_of(parameters).signs_of(torus)
        return MotionO4(parameters, (first, second), signs, turn)

    def __post_init__(self) -> None:
        """Refuse constants that leave no real motion, and signs for which E² is negative."""
        if not self.regime.signs[2] and self.signs[1] > 0:
            raise Inadmissible("σ < 0: μ1 and μ2 have opposite signs, for E² is positive")

    @cached_property
    def regime(self) -> RegimeO4:
        """The regime of its constants."""
        return regime_of(self.parameters)

    @property
    def arcs(self) -> tuple[Arc, Arc]:
        """The arcs of u1 and u2."""
        return self.regime.u1, self.regime.u2

    @property
    def orientations(self) -> tuple[int, int]:
        """The signs with which the differentials of u1 and of u2 go into the quadratures."""
        K1, mu2, A2, B2, K2 = self.signs
        return K1, -mu2 * A2 * B2 * K2

    def in_unit(self, unit: int) -> MotionO4:
        """The same motion in a unit of time in which a rate of this power of two is 1."""
        point = self.point and tuple(in_unit(np.array(self.point), np.array(unit)).tolist())
        return replace(self, parameters=self.parameters.in_unit(unit), point=point)

    @property
    def constants(self) -> dict[str, float | str]:
        """The lengths a, b of the fields and their scalar product c, the integrals, s and τ."""
        return without_unit(self.constants_in_unit, self.parameters.unit)

    @property
    def constants_in_unit(self) -> dict[str, float]:
        """The constants in a unit of time in which a is about 1."""
        known = self.parameters.in_unit(self.parameters.unit)
        values = (*fields(known.p_square, known.r_square, self.turn), *known.integrals)
        named = dict(zip("abchkg", values, strict=True))
        return {**named, "s": float(known.s), "tau": float(known.tau)}
