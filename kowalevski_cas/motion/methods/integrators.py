"""SciPy's integrators: the nine equations from an initial state, both ways in time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.compile import Function
from kowalevski_cas.motion.general import AnyMotion, General
from kowalevski_cas.motion.methods import MethodError
from kowalevski_cas.motion.methods.closed import states as closed

TOLERANCE = 1e-12
"""The relative and absolute tolerance unless another is asked for."""


def states(
    motion: AnyMotion, times: Array, tolerance: float = TOLERANCE, method: str = "DOP853"
) -> Array:
    """The states at these times, an array of shape (N, 9), by the SciPy method of this name."""
    return integrate(method, initial_state(motion), times, tolerance)


def initial_state(motion: AnyMotion) -> Array:
    """The state at t = 0 from which integrators start."""
    if motion.point is not None:
        return np.array(motion.point)
    assert not isinstance(motion, General)
    start: Array = closed(motion, np.zeros(1))[0]
    return start


def integrate(method: str, start: Array, times: Array, tolerance: float = TOLERANCE) -> Array:
    """The states at these times, in any order, of the motion with this state at t = 0.

    Raises :class:`~kowalevski_cas.motion.methods.MethodError` if the integrator gives up.
    """
    from scipy.integrate import solve_ivp

    states = np.empty((len(times), len(start)))
    for sign in (1.0, -1.0):
        chosen = np.flatnonzero(times >= 0 if sign > 0 else times < 0)
        chosen = chosen[np.argsort(sign * times[chosen])]
        if not len(chosen):
            continue
        forward = sign * times[chosen]
        if forward[-1] == 0:
            states[chosen] = start
            continue
        solution = solve_ivp(
            _towards(sign, formulas.offered("equations")),
            (0.0, forward[-1]),
            start,
            method=method,
            t_eval=forward,
            rtol=tolerance,
            atol=tolerance,
        )
        if not solution.success:
            reached = sign * solution.t[-1]
            raise MethodError(f"{method} stopped at t = {reached:g}: {solution.message}")
        states[chosen] = solution.y.T
    return states


def _towards(sign: float, right: Function) -> Callable[[float, Array], list[float]]:
    """The rates in a direction of time."""
    return lambda t, y: [sign * rate for rate in right(*y.tolist())]
