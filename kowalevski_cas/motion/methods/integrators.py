"""What SciPy's integrators share: the nine equations from an initial state, both ways in time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.compile import Function
from kowalevski_cas.motion.methods import MethodError
from kowalevski_cas.motion.methods.closed import states as closed
from kowalevski_cas.motion.motion import Motion

Array = NDArray[np.float64]

TOLERANCE = 1e-12
"""The relative and absolute tolerance unless another is asked for."""


PILOT, MOST = 10**4, 10**10
"""After so many evaluations of the rates it is seen whether the last time is within reach: the
others, at the same pace, should not be more than so many, which take a day or several."""


def initial_state(motion: Motion) -> Array:
    """The state at t = 0 from which integrators start."""
    start: Array = (
        closed(motion, np.zeros(1))[0] if motion.point is None else np.array(motion.point)
    )
    return start


def integrate(
    method: str,
    start: Array,
    times: Array,
    tolerance: float = TOLERANCE,
    rates: Function | None = None,
) -> Array:
    """The states at these times, in any order, of the motion with this state at t = 0.

    ``rates`` are those of the nine equations, unless another autonomous system is meant.
    Raises :class:`~kowalevski_cas.motion.methods.MethodError` if the integrator gives up.
    """
    from scipy.integrate import solve_ivp

    right = formulas.equations() if rates is None else rates
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
            _within_reach(method, right, sign, forward[-1]),
            (0.0, forward[-1]),
            start,
            method=method,
            t_eval=forward,
            rtol=tolerance,
            atol=tolerance,
        )
        if not solution.success:
            raise MethodError(f"{method} stopped at t = {sign * solution.t[-1]:g}: "
                              f"{solution.message}")  # fmt: skip
        states[chosen] = solution.y.T
    return states


def _within_reach(
    method: str, right: Function, sign: float, last: float
) -> Callable[[float, Array], list[float]]:
    """The rates in the direction of time, until it is seen that the last time is out of reach."""
    evaluations = 0

    def rates(t: float, y: Array) -> list[float]:
        nonlocal evaluations
        evaluations += 1
        if evaluations == PILOT and t * (MOST / PILOT) < last:
            raise MethodError(
                f"{method} has come to t = {sign * t:.3g} after {PILOT} evaluations: "
                f"t = {sign * last:g} is out of its reach; the closed form is not slower there"
            )
        return [sign * rate for rate in right(*y.tolist())]

    return rates
