"""Taylor series of the nine equations, by heyoka where it is installed."""

from __future__ import annotations

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.general import AnyMotion
from kowalevski_cas.motion.methods import MethodError
from kowalevski_cas.motion.methods.integrators import initial_state

TOLERANCE = 1e-16


def states(motion: AnyMotion, times: Array, tolerance: float = TOLERANCE) -> Array:
    """The states at these times, an array of shape (N, 9).

    Raises :class:`~kowalevski_cas.motion.methods.MethodError` if heyoka stops.
    """
    return integrate(initial_state(motion), times, tolerance)


def integrate(start: Array, times: Array, tolerance: float = TOLERANCE) -> Array:
    """The states at these times, in any order, of the motion with this state at t = 0."""
    import heyoka

    variables = heyoka.make_vars(*(f"x{index}" for index in range(9)))
    system = list(zip(variables, formulas.offered("equations")(*variables), strict=True))
    integrator = heyoka.taylor_adaptive(system, list(start), tol=tolerance)
    found = np.empty((len(times), 9))
    for sign in (1, -1):
        chosen = np.flatnonzero(times >= 0 if sign > 0 else times < 0)
        if not len(chosen):
            continue
        # The grid begins at 0 and is strictly monotonic, away from 0.
        since, places = np.unique(np.abs(times[chosen]), return_inverse=True)
        added = int(since[0] > 0)
        grid = sign * np.concatenate([[0.0] * added, since])
        integrator.time, integrator.state[:] = 0.0, start
        outcome, *_, values = integrator.propagate_grid(grid)
        if outcome != heyoka.taylor_outcome.time_limit:
            raise MethodError(f"taylor stopped at t = {integrator.time:g}: {outcome}")
        found[chosen] = values[added:][places]
    return found
