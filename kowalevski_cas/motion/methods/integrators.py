"""SciPy's integrators: the nine equations from an initial state, both ways in time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.general import AnyMotion, General
from kowalevski_cas.motion.methods.ball import start_on_O4
from kowalevski_cas.motion.methods.closed import states as closed
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.parameters import MethodError
from kowalevski_cas.motion.units import in_unit, unit_of

TOLERANCE = 1e-12
"""The tolerance, relative to the size of the state and of either field, unless another is asked
for."""

LEAST = -500
"""The exponent of the least field that is followed to its own size: tolerances are floats."""


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
    if isinstance(motion, MotionO4):
        return start_on_O4(motion)
    start: Array = closed(motion, np.zeros(1))[0]
    return start


def integrate(method: str, start: Array, times: Array, tolerance: float = TOLERANCE) -> Array:
    """The states at these times, in any order, of the motion with this state at t = 0.

    Raises :class:`~kowalevski_cas.motion.parameters.MethodError` if the integrator gives up.
    """
    from scipy.integrate import solve_ivp

    rates = formulas.values_of_offer("equations")

    def run(begin: Array, grid: Array) -> Array:
        if grid[-1] == 0:
            return begin[None]
        solution = solve_ivp(
            lambda t, y: rates(*y.tolist()), (0.0, grid[-1]), begin, method=method, t_eval=grid,
            rtol=tolerance, atol=tolerance * sizes(begin),
        )  # fmt: skip
        if not solution.success:
            raise MethodError(f"{method} stopped at t = {solution.t[-1]:g}: {solution.message}")
        states: Array = solution.y.T
        return states

    return both_ways(run, start, times)


def sizes(state: Array) -> Array:
    """What the nine numbers of a state (9,) of the size 1 are compared with: powers of two.

    For a velocity that is 1; for a field, its own size, which it keeps: that of a fast top is tiny.
    """
    fields = np.max(np.abs(state[3:].reshape(2, 3)), axis=1)  # of 0 the exponent is 0
    exponents = np.maximum(np.frexp(fields)[1], LEAST)
    found: Array = np.ldexp(1.0, np.repeat([0, *exponents], 3))
    return found


def both_ways(run: Callable[[Array, Array], Array], start: Array, times: Array) -> Array:
    """The states at times in any order, by ``run`` of a start and times on one way from 0.

    It gets a start of the size 1, so that its tolerances are relative, and the farthest time last.
    Raises :class:`~kowalevski_cas.motion.parameters.MethodError` if a field is lost there.
    """
    unit, given = unit_of(start), start
    start, times = in_unit(given, unit), np.ldexp(times, unit)
    if any(np.any(given[k : k + 3]) and not np.any(start[k : k + 3]) for k in (3, 6)):
        raise MethodError("a field is so small beside ω² that no float holds it in its unit")
    found = np.empty((len(times), 9))
    for sign in (1.0, -1.0):
        chosen = np.flatnonzero(times >= 0 if sign > 0 else times < 0)
        if len(chosen):
            since, places = np.unique(np.abs(times[chosen]), return_inverse=True)
            found[chosen] = run(start, sign * since)[places]
    return in_unit(found, -unit)
