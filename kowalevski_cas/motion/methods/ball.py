"""Balls: a rigorous enclosure of the closed form, at any precision and any time."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

import numpy as np
from flint import acb, arb

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.frame import rotate
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.ball import SolutionO4, state_by_angles
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import MethodError, ball, exact, precision
from kowalevski_cas.motion.solution import PhasePoint, Variable
from kowalevski_cas.motion.units import WEIGHTS, in_unit, power

LARGEST_PRECISION = 1 << 17
"""Bits of working precision after which an enclosure is given up."""


def states(motion: Motion | MotionO4, times: Array) -> Array:
    """The states at these times, an array of shape (N, 9), to within rounding."""
    return enclose(motion, times)[0]


def enclose(motion: Motion | MotionO4, times: Array) -> tuple[Array, Array]:
    """The states at these times (N, 9), and how far (N) a number in each can be from the exact one.

    They are the middles of enclosures, or zero if that is in them, with radii below 2⁻⁶⁴ of the
    state's size, so that rounding is most of the error. Raises
    :class:`~kowalevski_cas.motion.parameters.MethodError` if an enclosure stays wide.
    """
    found = enclosures(motion, times.tolist(), 64)
    rows = [[0.0 if x.contains(0) else float(x.mid()) for x in state] for state in found]
    radii = [
        max(float(abs(x - number).upper()) for x, number in zip(state, row, strict=True))
        for state, row in zip(found, rows, strict=True)
    ]
    return np.array(rows).reshape(-1, 9), np.array(radii) * (1 + 2.0**-50)


def start_on_O4(motion: MotionO4) -> Array:
    """The state (9,) at t = 0 of a motion on O⁴, to within rounding, however close two roots are.

    Raises ``MethodError`` if the largest working precision does not suffice.
    """
    working = 128
    unit = motion.parameters.unit
    while working <= LARGEST_PRECISION:
        with precision(working):
            state = state_by_angles(motion.in_unit(unit))
            if _narrow(state, 64):
                row = np.array([0.0 if x.contains(0) else float(x.mid()) for x in state])
                return in_unit(row, np.array(-unit))
        working *= 2
    raise MethodError("no enclosure of the state at t = 0")


def enclosures(
    motion: Motion | MotionO4, times: Iterable[float | Fraction], bits: int
) -> list[list[arb]]:
    """For each time nine balls that contain the state, of radii below 2^−bits times its size.

    Those of ω are relative to the size of the state, those of the fields to that of the fields.
    Raises ``MethodError`` if the largest working precision does not suffice.
    """
    found: list[list[arb]] = []
    unit = motion.parameters.unit
    inner, left = motion.in_unit(unit), [exact(time) * power(unit) for time in times]
    scales = [ball(power(weight * unit)) for weight in WEIGHTS.tolist()]
    working = bits + 64
    while left:
        if working > LARGEST_PRECISION:
            raise MethodError(
                f"no enclosure of {bits} bits at t = {float(left[0] / power(unit)):g}"
            )
        with precision(working):
            solution = SolutionO4(inner) if isinstance(inner, MotionO4) else _Solution(inner)
            while left:
                state = solution(left[0])
                if not _narrow(state, bits):
                    break
                found.append([x * scale for x, scale in zip(state, scales, strict=True)])
                left.pop(0)
        working *= 2
    return found


class _Solution:
    """The closed form at one working precision."""

    def __init__(self, motion: Motion) -> None:
        oscillations = motion.oscillations()
        self._motion = motion
        self._quadruples = [_Jacobi(oscillation) for oscillation in oscillations]
        self._variables = [
            Variable(oscillation, sign, lambda number: number)
            for oscillation, sign in zip(oscillations, motion.signs, strict=True)
        ]
        self._point = PhasePoint(motion.parameters, lambda number: number)

    def __call__(self, time: Fraction) -> list[arb]:
        first, second = (
            variable(quadruple(ball(time - origin)))
            for variable, quadruple, origin in zip(
                self._variables, self._quadruples, self._motion.origins, strict=True
            )
        )
        state = list(self._point(first, second, _select))
        cos, sin = self._motion.turn
        return rotate(state, ball(cos), ball(-sin)) if sin else state


class _Jacobi:
    """The quadruple proportional to sn, cn, dn, 1, by theta functions."""

    def __init__(self, oscillation: Oscillation) -> None:
        self.kind = oscillation.kind
        self.rate = oscillation.rate
        if self.kind == "elliptic":
            quarter = oscillation.quarter
            self.rate = self.rate / (2 * quarter)
            self.tau = acb(0, oscillation.complementary_quarter / quarter)
            _, t2, t3, t4 = (value.real for value in acb.modular_theta(acb(0), self.tau))
            self.scales = (t3 / t2, t4 / t2, t4 / t3, arb(1))

    def __call__(self, since: arb) -> Sequence[arb]:
        argument = self.rate * since
        if self.kind == "rest":
            return arb(0), arb(1), arb(1), arb(1)
        if self.kind == "separatrix":
            sech = argument.sech()
            return argument.tanh(), sech, sech, arb(1)
        if self.kind == "exponential":
            up, down = (argument / 2).exp(), (-argument / 2).exp()
            return up, down, down, up
        thetas = acb.modular_theta(acb(argument), self.tau)
        return [x * theta.real for x, theta in zip(self.scales, thetas, strict=True)]


def _select(condition: arb, positive: arb, negative: arb) -> arb:
    """Either is right everywhere; the sign decides which is sharper."""
    return positive if condition.mid() >= 0 else negative


def _narrow(state: list[arb], bits: int) -> bool:
    if not all(x.is_finite() for x in state):
        return False
    omega, fields = (max(abs(x.mid()) for x in part) for part in (state[:3], state[3:]))
    sizes = [max(omega, fields.sqrt())] * 3 + [fields] * 6
    return all(x.rad() <= arb(2) ** -bits * size for x, size in zip(state, sizes, strict=True))
