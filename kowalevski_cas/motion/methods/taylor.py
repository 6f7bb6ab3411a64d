"""Taylor series of the nine equations, by heyoka where it is installed."""

from __future__ import annotations

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.general import AnyMotion
from kowalevski_cas.motion.methods.integrators import both_ways, initial_state, sizes
from kowalevski_cas.motion.parameters import MethodError

TOLERANCE = 1e-16


def states(motion: AnyMotion, times: Array, tolerance: float = TOLERANCE) -> Array:
    """The states at these times, an array of shape (N, 9).

    Raises :class:`~kowalevski_cas.motion.parameters.MethodError` if heyoka stops.
    """
    return integrate(initial_state(motion), times, tolerance)


def integrate(start: Array, times: Array, tolerance: float = TOLERANCE) -> Array:
    """The states at these times, in any order, of the motion with this state at t = 0."""
    import heyoka

    variables = heyoka.make_vars(*(f"x{index}" for index in range(9)))
    scales = [heyoka.par[index] for index in range(9)]
    scaled = [x * scale for x, scale in zip(variables, scales, strict=True)]
    rates = formulas.values_of_offer("equations")(*scaled)
    system = [(x, rate / scale) for x, rate, scale in zip(variables, rates, scales, strict=True)]
    integrator = heyoka.taylor_adaptive(system, [0.0] * 9, pars=[1.0] * 9, tol=tolerance)

    def run(start: Array, times: Array) -> Array:
        added = int(times[0] != 0)  # the grid begins at 0
        integrator.pars[:] = sizes(start)
        integrator.time, integrator.state[:] = 0.0, start / integrator.pars
        outcome, *_, values = integrator.propagate_grid(np.append([0.0] * added, times))
        if outcome != heyoka.taylor_outcome.time_limit:
            raise MethodError(f"taylor stopped at t = {integrator.time:g}: {outcome}")
        states: Array = values[added:] * integrator.pars
        return states

    return both_ways(run, start, times)
