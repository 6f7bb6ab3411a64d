"""A motion as it was followed: times, states, constants, and how well the integrals were kept."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.parameters import precision
from kowalevski_cas.motion.regimes import coincidences, tori


@dataclass(frozen=True)
class Result:
    """States of shape (N, 9) at times of shape (N,)."""

    motion: Motion
    times: NDArray[np.float64]
    states: NDArray[np.float64]

    @property
    def invariants(self) -> dict[str, object]:
        """The constants of the motion, how far it begins from a given state, and the drift."""
        known = self.motion.parameters
        values = dict(zip("abc", self._fields(), strict=True))
        for name, value in {"m": known.m, "h": known.h, "k": known.k, "g": known.g}.items():
            values[name] = float(value)
        with precision(64):
            values["l"] = float(known.ell)
        return {**values, "off": self.motion.off, "drift": self.drift}

    def _fields(self) -> tuple[float, float, float]:
        """The lengths of the two fields and their scalar product, by the turn χ."""
        known, (cos, sin) = self.motion.parameters, self.motion.turn
        if not sin:
            return float(known.a), float(known.b), 0.0
        difference = known.r_square * (cos**2 - sin**2)
        a_square, b_square = known.p_square + difference, known.p_square - difference
        c = float(known.r_square * cos * sin)
        return math.sqrt(a_square / 2), math.sqrt(max(b_square / 2, Fraction(0))), c

    @cached_property
    def drift(self) -> dict[str, float]:
        """The largest change of each integral over the states."""
        values = formulas.integrals()(*self.states.T)
        names = (name.replace("^", "").replace("_", "") for name in formulas.INTEGRALS)
        return {
            name: float(np.max(np.abs(value - value[0])))
            for name, value in zip(names, map(np.atleast_1d, values), strict=True)
        }

    @property
    def regime(self) -> dict[str, object]:
        """The regime: the order of the roots, the arcs of s1 and s2, the tori, the moduli k²."""
        regime = self.motion.regime
        with precision(64):
            squares = [float(o.modulus_square) for o in self.motion.oscillations()]
        return {
            "order": str(regime),
            "s1": str(regime.s1),
            "s2": str(regime.s2),
            "tori": tori(self.motion.parameters),
            "k1_squared": squares[0],
            "k2_squared": squares[1],
            "separating": coincidences(self.motion.parameters),
        }
