"""Work against precision: what a state at a late time costs by each method, and how exact it is.

The reference is the closed form in balls. An integrator that would take longer than
:data:`LIMIT` is left out, by its speed on the first :data:`PILOT` units of time.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np

from kowalevski_cas.motion import Motion, load
from kowalevski_cas.motion.methods import Missing
from kowalevski_cas.motion.methods.closed import Closed
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.transverse import distance
from kowalevski_cas.pictures import FAINT, new_figure, save, style
from study.motion.cases import (
    INTEGRATORS,
    LOOK,
    MOTIONS,
    SLOWEST,
    Array,
    drift,
    forecast,
    left_out,
    relative_error,
    timed,
)
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.axes import Axes

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
    except Missing as error:
        return left_out(str(error))
    if needed > LIMIT:
        return left_out(f"it would take about {needed:.0f} s, more than {LIMIT:g} s")
    seconds, found = timed(lambda: run(span))
    return {**_judged(motion, span, found), "seconds": seconds, "tolerance": tolerance}


def _judged(motion: Motion, span: float, found: Array) -> dict[str, Any]:
    """The error of a state, and how far it is from the levels of the integrals and from N⁴."""
    exact = load("ball")(motion, np.array([0.0, span]))
    return {
        "verdict": "measured",
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
    return {
        "seconds": seconds,
        "verdict": "measured",
        "error": error,
        "states": count,
        "rate": count / seconds,
    }


# -- charts -------------------------------------------------------------------------


def draw(rows: Sequence[Row], folder: Path) -> None:
    """Error against time, work against precision, and drift; a table of what was left out."""
    over_time = [row for row in rows if ", t = " in row["case"] and "work" not in row["case"]]
    with style():
        save(_errors(over_time), folder, "motion-errors")
        save(_work(rows), folder, "motion-work")
        save(_drifts(over_time), folder, "motion-drift")
    (folder / "motion-precision.md").write_text(_table(rows), encoding="utf-8")


def _series(rows: Sequence[Row], name: str, key: str) -> Iterator[tuple[str, list[Any], list[Any]]]:
    """For each method the times and what was measured there, on the torus with this name."""
    for method in LOOK:
        chosen = [
            row
            for row in rows
            if row["method"] == method and row["case"].startswith(name) and key in row
        ]
        if chosen:
            yield method, [row["span"] for row in chosen], [row[key] for row in chosen]


def _plot(axes: Axes, method: str, x: Sequence[float], y: Sequence[float]) -> None:
    look = LOOK[method]
    axes.plot(x, y, color=look.colour, marker=look.marker, ls=look.dashes, label=method)


def _errors(rows: Sequence[Row]) -> Any:
    figure = new_figure(height=3.6)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    for axes, name in zip(panels, MOTIONS, strict=True):
        for method, spans, errors in _series(rows, name, "error"):
            _plot(axes, method, spans, np.maximum(errors, 1e-17).tolist())
        axes.axhline(1e-13, color=FAINT, lw=0.8, zorder=0)
        kind = "elliptic" if name == "m > 0" else "hyperbolic"
        axes.set(xscale="log", yscale="log", ylim=(2e-17, 30), xlabel="$t$")
        axes.set_title(f"${name}$: {kind} torus")
    panels[0].set_ylabel("relative error of the state at $t$")
    panels[0].annotate("$10^{-13}$", (9e5, 1.5e-13), color=FAINT, ha="right")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=6)
    return figure


def _work(rows: Sequence[Row]) -> Any:
    figure = new_figure(4.6, 3.6)
    axes = figure.subplots()
    work = [row for row in rows if row["case"].startswith("work") and "error" in row]
    span = work[0]["span"] if work else AT
    for method in LOOK:
        chosen = [row for row in work if row["method"] == method] or [
            row for row in rows
            if method in ("closed", "ball") and row["method"] == method
            and row.get("span") == span and row["case"].startswith("m > 0")
        ]  # fmt: skip
        if chosen:
            _plot(
                axes, method, [max(row["error"], 1e-17) for row in chosen],
                [row["seconds"] for row in chosen],
            )  # fmt: skip
    axes.set(xscale="log", yscale="log", xlim=(30, 1e-17))
    axes.set_xlabel(f"relative error of the state at $t={span:g}$")
    axes.set_ylabel("seconds")
    if axes.lines:
        axes.legend()
    return figure


def _drifts(rows: Sequence[Row]) -> Any:
    figure = new_figure(height=4.4)
    kinds = {
        "$H$": ("H",), "$K$": ("K",), "(4)": ("a^2", "b^2", "c"), "$F_1$, $F_2$": ("F_1", "F_2"),
    }  # fmt: skip
    panels = figure.subplots(2, 4, sharex=True, sharey=True)
    for line, name in zip(panels, MOTIONS, strict=True):
        for axes, (title, names) in zip(line, kinds.items(), strict=True):
            for method, spans, values in _series(rows, name, "drift"):
                worst = [max(value[one] for one in names) for value in values]
                _plot(axes, method, spans, np.maximum(worst, 1e-17).tolist())
            axes.set(xscale="log", yscale="log", ylim=(5e-18, 30))
            axes.set_title(f"{title}, ${name}$")
    for axes in panels[1]:
        axes.set_xlabel("$t$")
    for axes in panels[:, 0]:
        axes.set_ylabel("drift")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=6)
    return figure


def _table(rows: Sequence[Row]) -> str:
    """Every row as Markdown, with the reason where nothing was measured."""
    lines = [
        "| method | case | seconds | relative error | drift of H, K, (4), (16) | verdict |",
        "|---|---|---:|---:|---|---|",
    ]
    for row in rows:
        seconds = "" if row["seconds"] is None else f"{row['seconds']:.2g}"
        error = f"{row['error']:.1e}" if "error" in row else ""
        lost = row.get("drift", {})
        groups = (("H",), ("K",), ("a^2", "b^2", "c"), ("F_1", "F_2"))
        moved = ", ".join(f"{max(lost[n] for n in g):.0e}" for g in groups) if lost else ""
        words = f"{row['verdict']}: {row['reason']}" if row.get("reason") else row["verdict"]
        if "rate" in row:
            words += f", {row['rate']:.2g} states a second"
        if "prepared" in row:
            words += f"; {row['prepared']:.1g} s if prepared"
        lines.append(
            f"| {row['method']} | {row['case']} | {seconds} | {error} | {moved} | {words} |"
        )
    return "\n".join([*lines, *_compared(rows), ""])


def _compared(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """By how much the closed form is faster than each integrator at its sharpest."""
    span = next(
        (row["span"] for row in rows if row["case"].startswith("work") and "span" in row), 0
    )
    closed = [
        row for row in rows if row["method"] == "closed" and row["case"] == f"m > 0, t = {span:g}"
    ]
    lines = []
    for method in INTEGRATORS if closed else ():
        work = [
            row
            for row in rows
            if row["method"] == method and row["case"].startswith("work") and "error" in row
        ]
        if work:
            best = min(work, key=lambda row: row["error"])
            ratio = best["seconds"] / closed[0]["seconds"]
            lines.append(
                f"- {method}: at best {best['error']:.1e} in {best['seconds']:.2g} s, "
                f"{ratio:.0f} times the time of the closed form, whose error is "
                f"{closed[0]['error']:.1e}."
            )
    return ["", f"The state at t = {span:g} on the elliptic torus:", "", *lines] if lines else []
