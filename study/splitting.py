"""A geometric integrator: the Hamiltonian in parts whose motions are rotations, composed.

Each part of the kinetic energy turns the fields and the moment about one axis, the potential energy
changes the moment alone. So every step is a Poisson map: the lengths of the fields and their
product are kept to within rounding, and the energy does not drift. Composed symmetrically, the
parts have order two, and three such steps with the weights of H. Yoshida order four.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from study.motions import Array

STEP = 0.1

_CUBE = 2 ** (1 / 3)
WEIGHTS = (1 / (2 - _CUBE), -_CUBE / (2 - _CUBE), 1 / (2 - _CUBE))

MOMENTS = (2.0, 2.0, 1.0)


def advance(state: list[Any], time: Any, cos: Any, sin: Any) -> list[Any]:
    """One symmetric step of order two, in numbers or expressions, with their functions."""
    state = _push(state, time / 2)
    for axis, share in ((2, 0.5), (1, 0.5), (0, 1.0), (1, 0.5), (2, 0.5)):
        state = _turn(state, axis, share * time, cos, sin)
    return _push(state, time / 2)


def _push(state: list[Any], time: Any) -> list[Any]:
    """The motion by the potential energy: the moment gains e₁×α + e₂×β."""
    _, alpha, beta = state[:3], state[3:6], state[6:]
    torque = (beta[2], -alpha[2], alpha[1] - beta[0])
    omega = [state[k] + time * torque[k] / MOMENTS[k] for k in range(3)]
    return [*omega, *alpha, *beta]


def _turn(state: list[Any], axis: int, time: Any, cos: Any, sin: Any) -> list[Any]:
    """The motion by one part of the kinetic energy: x' = x × ω for all three vectors."""
    angle = time * state[axis]
    c, s = cos(angle), sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    moment = [state[k] * MOMENTS[k] for k in range(3)]
    turned = []
    for vector in (moment, state[3:6], state[6:]):
        new = list(vector)
        new[i], new[j] = c * vector[i] + s * vector[j], c * vector[j] - s * vector[i]
        turned.append(new)
    omega = [turned[0][k] / MOMENTS[k] for k in range(3)]
    return [*omega, *turned[1], *turned[2]]


@cache
def _compiled() -> Any:
    """A step of order four, compiled: of the state and the time that it takes."""
    import heyoka

    variables = heyoka.make_vars(*(f"x{index}" for index in range(9)), "h")
    *state, time = variables
    for weight in WEIGHTS:
        state = advance(state, weight * time, heyoka.cos, heyoka.sin)
    return heyoka.cfunc(state, variables)


def integrate(start: Array, times: Array, tolerance: float) -> Array:
    """The states (N, 9) at times that grow, by steps of the length ``tolerance`` or less."""
    step, inputs, state, now = _compiled(), np.append(start, 0.0), np.array(start), 0.0
    found = []
    for time in times.tolist():
        count = max(1, int(np.ceil((time - now) / tolerance)))
        inputs[9] = (time - now) / count
        for _ in range(count):
            step(inputs, outputs=state)
            inputs[:9] = state
        found.append(state.copy())
        now = time
    return np.array(found)
