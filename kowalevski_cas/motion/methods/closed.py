"""The closed form in floating point: vectorised, accurate at every time."""

from __future__ import annotations

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.frame import rotate
from kowalevski_cas.motion.jacobi import jacobi
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.closed import ClosedO4
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.parameters import MethodError, ball, precision
from kowalevski_cas.motion.phases import LARGEST
from kowalevski_cas.motion.solution import PhasePoint, Variable, VariableValues
from kowalevski_cas.motion.units import WEIGHTS, in_unit, unit_of

BITS = 256
"""The precision of the constants before they are rounded."""

PROMISE = 1e-12
"""The error on O⁴, of ω relative to the state and of the fields relative to these."""

CHECKED = 4096
"""At how many states at most, spread over the times, the integrals are compared."""


class Closed:
    """The closed form of one motion, for times up to ``largest``."""

    block = 16384

    def __init__(self, motion: Motion, largest: float) -> None:
        # A phase of many turns needs so many more bits of the rate.
        bits = BITS + max(0, int(np.frexp(largest)[1]))
        with precision(bits):
            oscillations = motion.oscillations()
            origins = [ball(origin) for origin in motion.origins]
            self._jacobi = [
                jacobi(oscillation, origin, largest)
                for oscillation, origin in zip(oscillations, origins, strict=True)
            ]
            self._variables = [
                Variable(oscillation, sign, float)
                for oscillation, sign in zip(oscillations, motion.signs, strict=True)
            ]
            self._point = PhasePoint(motion.parameters, float)
        self._cos, self._sin = (float(x) for x in motion.turn)

    def __call__(self, t: Array) -> Array:
        """The states at times t of shape (N,), as an array of shape (9, N)."""
        return self.torus(t, t)

    def torus(self, first: Array, second: Array) -> Array:
        """The states (9, N) where each variable has a time (N,) of its own: points of the torus."""
        straight = self._point(*self.variables(first, second), _select)
        return np.array(rotate(straight, self._cos, -self._sin) if self._sin else straight)

    def variables(self, first: Array, second: Array) -> tuple[VariableValues, VariableValues]:
        """The two solved variables, each at times of its own."""
        (jacobi_1, jacobi_2), (variable_1, variable_2) = self._jacobi, self._variables
        return variable_1(jacobi_1(first)), variable_2(jacobi_2(second))


def states(motion: Motion | MotionO4, times: Array) -> Array:
    """The states at these times, an array of shape (N, 9); the error does not grow with time.

    Raises ``ValueError`` for times that are not finite, and
    :class:`~kowalevski_cas.motion.parameters.MethodError` where on O⁴ the integrals are not kept as
    well as is promised.
    """
    t = np.ascontiguousarray(times, dtype=float)
    largest = float(np.max(np.abs(t), initial=0.0))
    if not largest <= LARGEST:
        raise ValueError(f"times have to be finite, up to {LARGEST:g}")
    unit = motion.parameters.unit
    inner, t, largest = motion.in_unit(unit), np.ldexp(t, unit), float(np.ldexp(largest, unit))
    closed: Closed | ClosedO4
    closed = ClosedO4(inner, largest) if isinstance(inner, MotionO4) else Closed(inner, largest)
    found, exponents = np.empty((9, len(t))), unit * WEIGHTS[:, None]
    # in two steps, for the whole scale may be no float; by np.ldexp it takes ten times as long
    first, second = (np.ldexp(1.0, part) for part in (exponents // 2, exponents - exponents // 2))
    for start in range(0, len(t), closed.block):  # so that all arrays stay in the cache
        block = slice(start, start + closed.block)
        np.multiply(closed(t[block]) * first, second, out=found[:, block])
    some = in_unit(found.T[:: -(-len(t) // CHECKED) or 1], np.array(unit))
    if isinstance(inner, MotionO4) and not _loss(some, inner) <= PROMISE:
        raise MethodError("the closed form does not keep the integrals to twelve digits there")
    return found.T


def _loss(states: Array, motion: MotionO4) -> float:
    """How far the integrals of states (N, 9) are from those of the motion, relative to sizes.

    The states are those in the motion's own unit of time.
    """
    units = unit_of(states)
    H, K, a_square, b_square, c, G, *_ = formulas.values_of_offer("integrals")(
        *in_unit(states, units).T
    )
    constants, fields = motion.constants_in_unit, float(motion.parameters.p_square)
    lost = [
        np.abs(value - np.ldexp(constants[name], -weight * units))
        for name, value, weight in (("h", H, 2), ("k", K, 4), ("g", G, 6))
    ]
    lost += [
        np.abs(np.ldexp(value, 4 * units) - expected) / fields
        for value, expected in (
            (a_square, constants["a"] ** 2),
            (b_square, constants["b"] ** 2),
            (c, constants["c"]),
        )
    ]
    return float(np.max(lost, initial=0.0))


def _select(condition: Array, positive: Array, negative: Array) -> Array:
    chosen: Array = np.where(condition >= 0, positive, negative)
    return chosen
