"""The closed form on O⁴ in floating point: vectorised, accurate at every time."""

from __future__ import annotations

import numpy as np
from flint import arb

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.frame import rotate
from kowalevski_cas.motion.o4.arithmetic import FLOATS
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.point import PhasePointO4
from kowalevski_cas.motion.o4.quadrature import Halves, Quadratures
from kowalevski_cas.motion.o4.series import DifferentialSeries
from kowalevski_cas.motion.o4.uniformization import uniformize
from kowalevski_cas.motion.parameters import MethodError, ball, precision
from kowalevski_cas.motion.phases import Phase, parts_needed

BITS = 192
"""The precision of the means, for times below one."""


class ClosedO4:
    """The closed form of one motion, for times up to ``largest``."""

    block = 8192

    def __init__(self, motion: MotionO4, largest: float) -> None:
        known = motion.parameters
        # A phase of many turns needs so many more bits of the rate.
        with precision(BITS + max(0, int(np.frexp(largest)[1]))):
            arcs = [uniformize(known, arc) for arc in motion.arcs]
            series = [DifferentialSeries(by) for by in arcs]
            self._quadratures = Quadratures(series, motion.orientations)
            self._halves = [Halves(by) for by in arcs]
            angles = [by.angle(ball(x)) for by, x in zip(arcs, motion.angles, strict=True)]
            origins = self._quadratures.phases(np.array([[float(x)] for x in angles]))
            if not np.isfinite(origins).all():
                raise MethodError("the angles at t = 0 have no phases: roots are too close")
            rates = self._quadratures.rates
            first, second = (4 * np.pi / abs(float(rate)) for rate in rates)
            self.periods = first, second
            # Functions of half the angles have the period 4π: a quarter of it is π.
            self._phases = [
                Phase(rate / arb.pi(), arb(origin) / arb.pi(), parts_needed(size, largest))
                for rate, (origin,) in zip(rates, origins.tolist(), strict=True)
                for size in [abs(float(rate))]
            ]
            self._point = PhasePointO4(known, motion.regime, motion.signs, FLOATS)
        self._cos, self._sin = (float(x) for x in motion.turn)

    def __call__(self, t: Array) -> Array:
        """The states at times t of shape (N,), as an array of shape (9, N)."""
        quarters = np.array([sum(phase(t)) for phase in self._phases])
        return self.torus(*self._quadratures.angles(np.pi * quarters))

    def torus(self, first: Array, second: Array) -> Array:
        """The states (9, N) by the two angles ψ: points of the torus."""
        pairs = (halves(angle) for halves, angle in zip(self._halves, (first, second), strict=True))
        with np.errstate(divide="ignore", invalid="ignore"):  # of two forms one may have no value
            states = self._point(*pairs)
        return np.array(rotate(states, self._cos, -self._sin) if self._sin else states)
