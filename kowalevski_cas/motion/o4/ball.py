"""Balls: a rigorous enclosure of the closed form on O⁴."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from flint import arb, arb_mat

from kowalevski_cas.motion.frame import rotate
from kowalevski_cas.motion.o4.arithmetic import BALLS
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.point import PhasePointO4
from kowalevski_cas.motion.o4.quadrature import Quadratures
from kowalevski_cas.motion.o4.series import DifferentialSeries, matrix
from kowalevski_cas.motion.o4.uniformization import uniformize
from kowalevski_cas.motion.parameters import ball


def state_by_angles(motion: MotionO4) -> list[arb]:
    """The state at t = 0, where the motion has its angles: no quadrature is needed."""
    halves = [ball(angle) / 2 for angle in motion.angles]
    point = PhasePointO4(motion.parameters, motion.regime, motion.signs, BALLS)
    first, second = ((half.cos(), half.sin()) for half in halves)
    return _turn_back(motion, list(point(first, second)))


def _turn_back(motion: MotionO4, state: list[arb]) -> list[arb]:
    """The state in the fields as they were given."""
    cos, sin = motion.turn
    return rotate(state, ball(cos), ball(-sin)) if sin else state


class SolutionO4:
    """The closed form at one working precision."""

    def __init__(self, motion: MotionO4) -> None:
        self._motion, known = motion, motion.parameters
        self._arcs = [uniformize(known, arc) for arc in motion.arcs]
        self._point = PhasePointO4(known, motion.regime, motion.signs, BALLS)
        series = [DifferentialSeries(by) for by in self._arcs]
        self._differentials = [integral.differentials for integral in series]
        self._means = matrix([integral.enclose_means() for integral in series], motion.orientations)
        self._sines = [integral.enclose_sines() for integral in series]
        self._floats = Quadratures(series, motion.orientations)
        self._origin = self._integrals(
            [by.angle(ball(angle)) for by, angle in zip(self._arcs, motion.angles, strict=True)]
        )

    def __call__(self, time: Fraction) -> list[arb]:
        """The state; balls that are not finite where no enclosure is found."""
        aim = self._origin - arb_mat([[0], [ball(time)]])
        phases, turn = self._means.solve(aim, nonstop=True).entries(), 2 * arb.pi()
        turns = [(phase / turn).mid().floor() for phase in phases]
        aim -= self._means * arb_mat([[turn * count] for count in turns])
        near = [[float(phase - turn * k)] for phase, k in zip(phases, turns, strict=True)]
        angles = self._enclose(self._floats.angles(np.array(near))[:, 0].tolist(), aim)
        # After a turn the functions of half the angle have the other sign.
        first, second = (
            by.at(angle + turn * count)
            for by, angle, count in zip(self._arcs, angles, turns, strict=True)
        )
        return _turn_back(self._motion, list(self._point(first, second)))

    def _integrals(self, angles: Sequence[arb]) -> arb_mat:
        """Both integrals, a column."""
        found = self._means * arb_mat([[angle] for angle in angles])
        for sign, series, angle in zip(self._motion.orientations, self._sines, angles, strict=True):
            found += arb_mat([[sign * value] for value in series(angle)])
        return found

    def _slopes(self, angles: Sequence[arb]) -> arb_mat:
        """The matrix of the differentials at these angles."""
        columns = [
            [sign * value for value in differentials(angle)]
            for sign, differentials, angle in zip(
                self._motion.orientations, self._differentials, angles, strict=True
            )
        ]
        return arb_mat(columns).transpose()

    def _enclose(self, start: Sequence[float], aim: arb_mat) -> list[arb]:
        """The angles where the integrals are those aimed at.

        Newton's method, as long as its steps shrink, and then an interval Newton step: if it
        leads into the interior of a box, the box has exactly one solution, and that is where it
        leads.
        """
        angles, before = [arb(x) for x in start], arb("inf")
        while True:
            missing = aim - self._integrals(angles)
            steps = self._slopes(angles).solve(missing, nonstop=True).entries()
            size = max((abs(step).upper() for step in steps), key=float)
            if not 4 * size < before:
                break
            before = size
            angles = [(angle + step).mid() for angle, step in zip(angles, steps, strict=True)]
        box = [angle + arb(0, 2 * size) for angle in angles]
        steps = self._slopes(box).solve(missing, nonstop=True).entries()
        if all(abs(step) < 2 * size for step in steps):
            return [angle + step for angle, step in zip(angles, steps, strict=True)]
        return [arb("nan"), arb("nan")]
