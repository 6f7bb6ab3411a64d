"""Balls: a rigorous enclosure of the closed form on O⁴."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from flint import arb, arb_mat

from kowalevski_cas.motion.frame import turned
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.point import PhasePoint
from kowalevski_cas.motion.o4.quadrature import Quadratures
from kowalevski_cas.motion.o4.series import Series, matrix
from kowalevski_cas.motion.o4.variable import Variable
from kowalevski_cas.motion.parameters import ball

class SolutionO4:
    """The closed form at one working precision."""

    def __init__(self, motion: MotionO4) -> None:
        self._motion = motion
        self._variables = [Variable(motion.parameters, arc, lambda x: x) for arc in motion.arcs]
        self._point = PhasePoint(motion.parameters, motion.regime, motion.signs, lambda x: x, arb.sqrt)
        series = [Series(variable) for variable in self._variables]
        self._means = matrix(series, motion.orientations)
        self._sines = [one.sines() for one in series]
        self._floats = Quadratures(motion, series)
        self._origin = self._integrals([ball(angle) for angle in motion.angles])

    def __call__(self, time: Fraction) -> list[arb]:
        """The state, or balls that are not finite where no enclosure is found."""
        aim = self._origin - arb_mat([[0], [ball(time)]])
        phases = self._means.solve(aim).entries()
        turns = [(phase / (2 * arb.pi())).mid().floor() for phase in phases]
        aim -= self._means * arb_mat([[2 * arb.pi() * turn] for turn in turns])
        near = [[float(x - 2 * arb.pi() * y)] for x, y in zip(phases, turns, strict=True)]
        angles = self._enclosed(self._floats.angles(np.array(near))[:, 0].tolist(), aim)
        # A whole period changes the signs of both functions of half the angle.
        halves = [
            tuple(reversed((angle / 2 + arb.pi() * turn).sin_cos()))
            for angle, turn in zip(angles, turns, strict=True)
        ]
        state = list(self._point(*halves))
        cos, sin = self._motion.turn
        return turned(state, ball(cos), ball(-sin)) if sin else state

    def _integrals(self, angles: Sequence[arb]) -> arb_mat:
        """Both integrals, a column."""
        columns = [series(angle) for series, angle in zip(self._sines, angles, strict=True)]
        sines = [
            [sum((sign * column[place] for sign, column in
                  zip(self._motion.orientations, columns, strict=True)), arb(0))]
            for place in (0, 1)
        ]  # fmt: skip
        return self._means * arb_mat([[angle] for angle in angles]) + arb_mat(sines)

    def _slopes(self, angles: Sequence[arb]) -> arb_mat:
        """The matrix of the differentials at these angles."""
        columns = []
        for sign, variable, angle in zip(
            self._motion.orientations, self._variables, angles, strict=True
        ):
            cos = angle.cos()
            values = variable.differentials(((1 + cos) / 2, (1 - cos) / 2), arb.sqrt)
            columns.append([sign * value for value in values])
        return arb_mat(columns).transpose()

    def _enclosed(self, start: list[float], aim: arb_mat) -> list[arb]:
        """The angles where the integrals are those aimed at, by an interval Newton step."""
        angles, before = [arb(x) for x in start], arb("inf")
        while True:
            missing = aim - self._integrals(angles)
            steps = self._slopes(angles).solve(missing).entries()
            size = max((abs(step).upper() for step in steps), key=float)
            if not 4 * size < before:
                break
            before = size
            angles = [(angle + step).mid() for angle, step in zip(angles, steps, strict=True)]
        box = [angle + arb(0, 2 * size) for angle in angles]
        steps = self._slopes(box).solve(missing).entries()
        if all(abs(step) < 2 * size for step in steps):
            return [angle + step for angle, step in zip(angles, steps, strict=True)]
        return [arb("nan"), arb("nan")]
