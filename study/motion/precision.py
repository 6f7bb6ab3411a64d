"""Work against precision: what a state at a late time costs by each method, and how exact it is.

The reference is the closed form in balls. An integrator that would take longer than
:data:`LIMIT` is left out, by its speed on the first :data:`PILOT` units of time.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np

from kowalevski_cas.motion import Motion, load
from kowalevski_cas.motion.methods.closed import Closed
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.transverse import distance
from kowalevski_cas.pictures import FAINT, new_figure
from study.charts import label_outer, legend_below
from study.motion.cases import (
    FLOOR,
    INTEGRATORS,
    LOOK,
    MOTIONS,
    SLOWEST,
    Array,
    draw_errors,
    drift,
    forecast,
    relative_error,
    timed,
)
from study.step import Measured, Row, Task, left_out

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "Motions on N⁴: work and precision of the methods"

SPANS = tuple(10.0**power for power in range(1, 7))
LIMIT, PILOT = 10.0, 20.0
"""Seconds that an integrator may take, and the time over which its speed is measured."""

SHARPEST = {"dop853": 1e-13, "radau": 1e-9, "lsoda": 1e-12, "taylor": 1e-16}
"""The tolerance at which the error of each integrator is followed over time."""

SWEEP = {
    "dop853": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13),
    "radau": (1e-3, 1e-4, 1e-5, 1e-6),
    "lsoda": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13),
    "taylor": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-16),
}
"""The tolerances at which work is measured against precision."""

AT = 1000.0
"""The time at which work is measured against precision."""

ROUNDS, MANY, CHECKED = 9, 1_000_000, 200


def measure(quick: bool) -> Iterator[Task]:
    """Every method at every time, on an elliptic and a hyperbolic torus; then tolerances."""
    spans, tolerances = (SPANS[:2], 2) if quick else (SPANS, None)
    integrators = [name for name in INTEGRATORS if not (quick and name == SLOWEST)]
    for name, motion in MOTIONS.items():
        for span in spans:
            case = f"{name}, t = {span:g}"
            yield Task("closed", case, partial(_closed, motion, span))
            yield Task("ball", case, partial(_ball, motion, span))
            for method in integrators:
                yield Task(method, case, partial(_run, method, motion, span, SHARPEST[method]))
    motion, at = MOTIONS["m > 0"], spans[-1] if quick else AT
    for method in integrators:
        for tolerance in SWEEP[method][:tolerances]:
            case = f"work, t = {at:g}, tolerance {tolerance:g}"
            yield Task(method, case, partial(_run, method, motion, at, tolerance))
    count = MANY // 10 if quick else MANY
    yield Task("closed", f"{count} states", partial(_many, motion, count))


def _closed(motion: Motion, span: float) -> Measured:
    times, states = np.array([span]), load("closed")
    seconds = median(timed(lambda: states(motion, times))[0] for _ in range(ROUNDS))
    prepared = Closed(motion, span)
    again = median(timed(lambda: prepared(times))[0] for _ in range(ROUNDS))
    found = states(motion, times)
    return {**_judged(motion, span, found), "seconds": seconds, "prepared": again}


def _ball(motion: Motion, span: float) -> Measured:
    times, states = np.array([span]), load("ball")
    seconds = median(timed(lambda: states(motion, times))[0] for _ in range(ROUNDS))
    return {"seconds": seconds, "verdict": "enclosed", "error": 2.0**-53, "span": span}


def _run(method: str, motion: Motion, span: float, tolerance: float) -> Measured:
    """An integrator from the state at t = 0 to a time, where that does not take too long."""
    integrate, start = INTEGRATORS[method], initial_state(motion)

    def run(time: float) -> Array:
        return integrate(start, np.array([time]), tolerance)

    try:
        needed = forecast(run, PILOT, span) if span > 3 * PILOT else forecast(run, 1.0, span)
    except ModuleNotFoundError as error:
        return left_out(str(error))
    if needed > LIMIT:
        return left_out(f"it would take about {needed:.0f} s, more than {LIMIT:g} s")
    seconds, found = timed(lambda: run(span))
    return {**_judged(motion, span, found), "seconds": seconds, "tolerance": tolerance}


def _judged(motion: Motion, span: float, found: Array) -> dict[str, Any]:
    """The error of a state, and how far it is from the levels of the integrals and from N⁴."""
    exact = load("ball")(motion, np.array([0.0, span]))
    return {
        "span": span,
        "error": relative_error(found, exact[1:]),
        "drift": drift(exact[0], found[0]),
        "distance": float(distance(found[0])),
    }


def _many(motion: Motion, count: int) -> Measured:
    """States at random times up to the last of :data:`SPANS`, on both sides of zero."""
    random = np.random.default_rng(2004)
    times = random.uniform(-SPANS[-1], SPANS[-1], count)
    seconds, states = timed(lambda: load("closed")(motion, times))
    chosen = random.choice(count, CHECKED, replace=False)
    error = relative_error(states[chosen], load("ball")(motion, times[chosen]))
    return {"seconds": seconds, "error": error, "states": count, "rate": count / seconds}


# -- charts -------------------------------------------------------------------------

DRIFTS = {
    "$H$": ("H",), "$K$": ("K",), "(4)": ("a^2", "b^2", "c"), "$F_1$, $F_2$": ("F_1", "F_2"),
}  # fmt: skip
"""The integrals whose largest drift is drawn in one panel."""


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Error against time, work against precision, and drift."""
    over_time = [row for row in rows if ", t = " in row["case"] and "work" not in row["case"]]
    return {
        "motion-errors": _errors(over_time),
        "motion-work": _work(rows),
        "motion-drift": _drifts(over_time),
    }


def _errors(rows: Sequence[Row]) -> Figure:
    figure = new_figure(height=3.6)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    for axes, name in zip(panels, MOTIONS, strict=True):
        chosen = [row for row in rows if row["case"].startswith(name)]
        for method in LOOK:
            draw_errors(axes, chosen, method, "span")
        axes.axhline(1e-13, color=FAINT, lw=0.8, zorder=0)
        kind = "elliptic" if name == "m > 0" else "hyperbolic"
        axes.set(xscale="log", yscale="log", ylim=(2 * FLOOR, 30), xlabel="$t$")
        axes.set_title(f"${name}$: {kind} torus")
    panels[0].set_ylabel("relative error of the state at $t$")
    panels[0].annotate("$10^{-13}$", (9e5, 1.5e-13), color=FAINT, ha="right")
    legend_below(figure, panels[0], 6)
    return figure


def _work(rows: Sequence[Row]) -> Figure:
    figure = new_figure(4.6, 3.6)
    axes = figure.subplots()
    work = [row for row in rows if row["case"].startswith("work") and "error" in row]
    span = work[0]["span"] if work else AT
    work += [
        row
        for row in rows
        if row["method"] in ("closed", "ball") and row["case"] == f"m > 0, t = {span:g}"
    ]
    for method in LOOK:
        chosen = [{**row, "error": max(row["error"], FLOOR)} for row in work]
        draw_errors(axes, chosen, method, "error", "seconds")
    axes.set(xscale="log", yscale="log", xlim=(30, FLOOR))
    axes.set_xlabel(f"relative error of the state at $t={span:g}$")
    axes.set_ylabel("seconds")
    if axes.lines:
        axes.legend()
    return figure


def _drifts(rows: Sequence[Row]) -> Figure:
    figure = new_figure(height=4.4)
    panels = figure.subplots(2, 4, sharex=True, sharey=True)
    for line, name in zip(panels, MOTIONS, strict=True):
        chosen = [row for row in rows if row["case"].startswith(name) and "drift" in row]
        for axes, (title, names) in zip(line, DRIFTS.items(), strict=True):
            worst = [{**row, "worst": max(row["drift"][one] for one in names)} for row in chosen]
            for method in LOOK:
                draw_errors(axes, worst, method, "span", "worst")
            axes.set(xscale="log", yscale="log", ylim=(FLOOR / 2, 30))
            axes.set_title(f"{title}, ${name}$")
    label_outer(panels, "$t$", "drift")
    legend_below(figure, panels[0, 0], 6)
    return figure
