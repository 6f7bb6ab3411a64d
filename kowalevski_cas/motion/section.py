"""Poincaré sections: the states of motions at which a coordinate is largest for the moment.

A bounded coordinate is largest again and again, whatever the motion, unless it comes to rest: so
there is no plane to choose that some motions never cross.
"""

from __future__ import annotations

from importlib.util import find_spec

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array, Mask
from kowalevski_cas.motion.compile import Function
from kowalevski_cas.motion.methods.closed import states as closed
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.parameters import MethodError
from kowalevski_cas.motion.units import in_unit, unit_of

COORDINATES = tuple(f"{vector}{k}" for vector in ("omega", "alpha", "beta") for k in (1, 2, 3))

OMEGA3 = COORDINATES.index("omega3")

TOLERANCE = 1e-13

GRID = 100
"""States of the closed form in a unit of time, the size of the state being 1, among which
the coordinate is looked at."""

HALVINGS = 60
"""Steps of a bisection, after which a time is one of two floats beside one another."""


def section(
    starts: Array, until: float, coordinate: int = OMEGA3, rates: Function | None = None
) -> list[Array]:
    """The states (N, 9) at which the coordinate is largest, for each of the starts (M, 9) at t = 0.

    By heyoka, which finds the zeros of Taylor polynomials, or where it is not installed by DOP853.
    ``rates`` are those of another system in the nine variables. Raises
    :class:`~kowalevski_cas.motion.parameters.MethodError` if an integration stops.
    """
    rates = rates or formulas.values_of_offer("equations")
    unit = unit_of(starts[0])
    run = _by_taylor if find_spec("heyoka") else _by_dop853
    found = run(in_unit(starts, unit), float(np.ldexp(until, unit)), coordinate, rates)
    return [in_unit(states, -unit) for states in found]


def _by_taylor(starts: Array, until: float, coordinate: int, rates: Function) -> list[Array]:
    import heyoka

    variables = heyoka.make_vars(*(f"x{index}" for index in range(9)))
    moved = rates(*variables)
    rows: list[Array] = []

    def keep(integrator: heyoka.taylor_adaptive, time: float, _: int) -> None:
        integrator.update_d_output(time)
        rows.append(integrator.d_output.copy())

    largest = heyoka.nt_event(moved[coordinate], keep, direction=heyoka.event_direction.negative)
    system = list(zip(variables, moved, strict=True))
    integrator = heyoka.taylor_adaptive(system, [0.0] * 9, nt_events=[largest], tol=TOLERANCE)
    found = []
    for start in starts:
        rows.clear()
        integrator.time, integrator.state[:] = 0.0, start
        outcome, *_ = integrator.propagate_until(until)
        if outcome != heyoka.taylor_outcome.time_limit:
            raise MethodError(f"taylor stopped at t = {integrator.time:g}: {outcome}")
        found.append(np.reshape(rows, (-1, 9)))
    return found


def _by_dop853(starts: Array, until: float, coordinate: int, rates: Function) -> list[Array]:
    from scipy.integrate import solve_ivp

    def largest(_: float, state: Array) -> float:
        return float(rates(*state.tolist())[coordinate])

    largest.direction = -1.0  # type: ignore[attr-defined] # where SciPy looks for it
    found = []
    for start in starts:
        solution = solve_ivp(
            lambda _, state: rates(*state.tolist()), (0.0, until), start, method="DOP853",
            events=largest, rtol=TOLERANCE, atol=TOLERANCE,
        )  # fmt: skip
        if not solution.success:
            raise MethodError(f"DOP853 stopped at t = {solution.t[-1]:g}: {solution.message}")
        found.append(np.reshape(solution.y_events[0], (-1, 9)))
    return found


def closed_section(motion: Motion | MotionO4, until: float, coordinate: int = OMEGA3) -> Array:
    """The states (N, 9) at which the coordinate is largest, by the closed form: on N⁴ or O⁴."""
    rates = formulas.values_of_offer("equations")

    def rises(times: Array) -> Mask:
        found: Mask = rates(*closed(motion, times).T)[coordinate] > 0
        return found

    rate = np.ldexp(float(GRID), int(unit_of(closed(motion, np.zeros(1)))[0]))
    grid = np.linspace(0.0, until, int(rate * until) + 2)
    rising = rises(grid)
    turns = np.flatnonzero(rising[:-1] & ~rising[1:])
    before, after = grid[turns], grid[turns + 1]
    for _ in range(HALVINGS):
        middle = (before + after) / 2
        early = rises(middle)
        before, after = np.where(early, middle, before), np.where(early, after, middle)
    return closed(motion, after)


def neighbours(state: Array, distances: Array) -> Array:
    """States (N, 9) beside a state (9,) on its level of H, G and the constants of the fields.

    They are so far away (N,), as shares of the state's size, in directions by chance.
    """
    unit = unit_of(state)
    start = in_unit(state, unit)
    level, random = _level(start), np.random.default_rng(1)
    *_, basis = np.linalg.svd(_slopes(start))
    found = []
    for distance in distances:
        direction = random.normal(size=9 - len(level)) @ basis[len(level) :]
        beside = start + distance * direction / np.linalg.norm(direction)
        for _ in range(20):
            beside = beside - np.linalg.pinv(_slopes(beside)) @ (_level(beside) - level)
        found.append(beside)
    return in_unit(np.array(found), -unit)


def _level(state: Array) -> Array:
    """The values of H, a², b², c, G."""
    values = dict(
        zip(formulas.INTEGRALS, formulas.values_of_offer("integrals")(*state), strict=True)
    )
    return np.array([values[name] for name in ("H", "a^2", "b^2", "c", "G")])


def _slopes(state: Array) -> Array:
    """The derivatives (5, 9) of these; a step in the imaginary direction subtracts nothing."""
    step = 1e-30
    slopes: Array = np.array([_level(state + 1j * step * e).imag / step for e in np.eye(9)]).T
    return slopes
