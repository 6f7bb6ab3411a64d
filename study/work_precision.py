"""Work against precision: what a state at a late time costs by each method, and how exact it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from statistics import median

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from kowalevski_cas.motion import MotionO4, ParametersO4, load
from kowalevski_cas.motion.general import AnyMotion
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.pictures import new_figure
from study.charts import curve, digit, legend_below, seconds
from study.motions import (
    INTEGRATORS,
    MOTIONS,
    Array,
    parameters,
    relative_error,
    time_call,
    tolerances,
)
from study.step import Measured, Row, Task

TITLE = "work against precision"

AT = 1000.0

ON_O4 = ("1.2", "0.7", "-0.9", "0.6")
"""The constants a, b, s, τ of a motion on O⁴."""

CASES: dict[str, tuple[str, AnyMotion]] = {
    "N⁴": (parameters("m > 0"), MOTIONS["m > 0"]),
    "O⁴": (
        "$a={}$, $b={}$, $s={}$, $\\tau_3={}$".format(*ON_O4),
        MotionO4(ParametersO4.of(*ON_O4)),
    ),
}
"""What the panels are about: the constants in words, and the motion."""

TOLERANCES = {
    "dop853": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13),
    "radau": (1e-3, 1e-4, 1e-5, 1e-6),
    "lsoda": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13),
    "taylor": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-16),
}

ROUNDS = 9
MANY, LATEST, CHECKED = 1_000_000, 1e6, 200

WINDOW, DENSE = 100.0, {"dop853": 1e-12, "taylor": 1e-16}
"""A short time that is filled with states, and who does that, at which tolerance."""

CAPTION = (
    f"What the state at $t={AT:g}$ costs, in seconds of processor time, and how exact it is: on "
    f"$N^4$, {CASES['N⁴'][0]}, and on $O^4$, {CASES['O⁴'][0]}. The integrators at tolerances down "
    "to "
    + tolerances({name: min(found) for name, found in TOLERANCES.items()})
    + f"; the closed form and the balls as the median of {ROUNDS} runs. Below: one of "
    f"{digit(MANY)} states, by the closed form at random times, $|t|$ up to {digit(LATEST)}, by "
    f"integrators, {tolerances(DENSE)}, at equal steps from $t=0$ to ${WINDOW:g}$, where dense "
    "output makes them cheap. heyoka compiles before a clock starts, and keeps what it has "
    "compiled; that an integrator is built from it again is counted, and is most of what a Taylor "
    "series costs above. Errors are against rigorous balls; their own are drawn at the roundoff. "
    "From one run to another on a shared machine all times differ by up to a factor of two."
)


def measure(quick: bool) -> Iterator[Task]:
    """The methods that know the motion, then the integrators at their tolerances."""
    count = MANY // 10 if quick else MANY
    for name, (_, motion) in CASES.items():
        one, many = f"{name}: t = {AT:g}", f"{name}: {count} states"
        for method in ("closed", "ball"):
            yield Task(method, one, partial(_measure_closed_form, method, motion))
        yield Task("closed", many, partial(_many, count, motion))
        for method, tolerance in DENSE.items():
            yield Task(method, many, partial(_dense, method, tolerance, count, motion))
        for method, found in TOLERANCES.items():
            few = found[:1] if quick else found
            yield Task(method, one, partial(_measure_integration, method, few, motion))


def _measure_closed_form(method: str, motion: AnyMotion) -> Measured:
    times, states = np.array([AT]), load(method)
    spent = median(time_call(lambda: states(motion, times))[0] for _ in range(ROUNDS))
    found = relative_error(motion, states(motion, times), times)
    return {"times": [spent], "errors": [max(found, 2.0**-53)]}


def _many(count: int, motion: AnyMotion) -> Measured:
    """States at random times on both sides of zero; the time for one of them."""
    times = np.random.default_rng(2004).uniform(-LATEST, LATEST, count)
    return _each(motion, times, *time_call(lambda: load("closed")(motion, times)))


def _dense(method: str, tolerance: float, count: int, motion: AnyMotion) -> Measured:
    """States at equal steps of a short time; the time for one of them."""
    times = np.linspace(0.0, WINDOW, count)
    run = partial(INTEGRATORS[method], initial_state(motion))
    run(times[1:2], tolerance)  # whatever is prepared once
    return _each(motion, times, *time_call(partial(run, times, tolerance)))


def _each(motion: AnyMotion, times: Array, spent: float, states: Array) -> Measured:
    """The time for one state, and the largest error of some."""
    chosen = np.random.default_rng(2004).choice(len(times), CHECKED, replace=False)
    error = relative_error(motion, states[chosen], times[chosen])
    return {"times": [spent / len(times)], "errors": [error]}


def _measure_integration(method: str, found: Sequence[float], motion: AnyMotion) -> Measured:
    times, run = np.array([AT]), partial(INTEGRATORS[method], initial_state(motion))
    for tolerance in found:
        run(np.array([1e-3]), tolerance)  # whatever is prepared once
    runs = [time_call(partial(run, times, tolerance)) for tolerance in found]
    return {
        "tolerances": list(found),
        "times": [spent for spent, _ in runs],
        "errors": [relative_error(motion, states, times) for _, states in runs],
    }


def draw(rows: Sequence[Row]) -> Figure:
    """Seconds against the relative error: down is cheaper, to the right is more exact.

    Above for one state at a late time, below for one of many.
    """
    figure = new_figure(height=5.2)
    panels = figure.subplots(2, len(CASES), sharex=True, sharey="row", height_ratios=(3, 2))
    for line, many in zip(panels, (False, True), strict=True):
        for axes, (name, (words, _)) in zip(line, CASES.items(), strict=True):
            for row in rows:
                here = row["case"].startswith(name) and row["case"].endswith("states") is many
                if here and "errors" in row:
                    curve(axes, row, "errors", "times")
            axes.set(xscale="log", yscale="log", xlim=(10, 1e-17))
            axes.minorticks_off()
            axes.yaxis.set_major_formatter(FuncFormatter(seconds))
            if not many:
                axes.set_title(f"${name[0]}^4$: {words}", size=8.5)
        line[0].set_ylabel("one of many states" if many else f"one state at $t={AT:g}$")
    for axes in panels[1]:
        axes.set_xlabel("relative error of the state")
    panels[1, 0].set_ylim(5e-8, 5e-6)
    legend_below(figure, panels[0, 0], len(TOLERANCES) + 2)
    return figure
