r"""How fast methods leave N⁴, against what the cofactor matrix of (15) predicts.

Across a hyperbolic torus every error grows like :math:`e^{\lambda t}`, across an elliptic one
it does not (see :mod:`~kowalevski_cas.motion.transverse`). Each method starts on N⁴, as nearly
as floating point allows, and once more with :math:`\omega_3` displaced.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from kowalevski_cas.motion import Motion, load
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.transverse import distance, exponent
from kowalevski_cas.pictures import INK, new_figure
from study.charts import label_outer, legend_below
from study.motion.cases import (
    FLOOR,
    INTEGRATORS,
    LOOK,
    MOTIONS,
    SLOWEST,
    Array,
    timed,
)
from study.step import Measured, Row, Task, left_out

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "Motions on N⁴: how fast methods leave it"

TOLERANCES = {"dop853": 1e-13, "radau": 1e-8, "lsoda": 1e-12, "taylor": 1e-16}
DISPLACED = 1e-12
SPAN, WINDOWS, POINTS = 80.0, 16, 60
"""The time, the windows into which it is divided, and the states in each of them."""

SMALL, LARGE = 30.0, 1e-3
"""A distance counts as growing from so many times the first one up to this."""


def measure(quick: bool) -> Iterator[Task]:
    """Each integrator on both tori, on N⁴ and beside it; the closed form, which cannot leave."""
    for name, motion in MOTIONS.items():
        yield Task("closed", f"{name}, on N⁴", partial(_closed, motion))
        for shift in (0.0, DISPLACED):
            case = f"{name}, {'beside' if shift else 'on'} N⁴"
            for method in INTEGRATORS:
                if not (quick and method == SLOWEST):
                    yield Task(method, case, partial(_run, method, motion, shift))


def _times() -> Array:
    return np.linspace(0.0, SPAN, WINDOWS * POINTS + 1)[1:]


def _closed(motion: Motion) -> Measured:
    seconds, states = timed(lambda: load("closed")(motion, _times()))
    return {"seconds": seconds, **_followed(motion, states)}


def _run(method: str, motion: Motion, shift: float) -> Measured:
    start = initial_state(motion)
    start[2] += shift
    try:
        seconds, states = timed(lambda: INTEGRATORS[method](start, _times(), TOLERANCES[method]))
    except ModuleNotFoundError as error:
        return left_out(str(error))
    return {"seconds": seconds, "tolerance": TOLERANCES[method], **_followed(motion, states)}


def _followed(motion: Motion, states: Array) -> dict[str, Any]:
    """The distance from N⁴, its median in each window; the rate at which it grows; λ."""
    found = np.median(distance(states).reshape(WINDOWS, POINTS), axis=1)
    middles = (np.arange(WINDOWS) + 0.5) * SPAN / WINDOWS
    predicted = exponent(motion.parameters)
    growing = (found > SMALL * found[0]) & (np.maximum.accumulate(found) < LARGE)
    rate = None
    if np.count_nonzero(growing) >= 3:
        rate = float(np.polyfit(middles[growing], np.log(found[growing]), 1)[0])
    return {
        "times": middles.tolist(),
        "distances": found.tolist(),
        "rate": rate,
        "predicted": abs(predicted.real),
        "frequency": abs(predicted.imag),
    }


# -- the chart ----------------------------------------------------------------------


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """The distance from N⁴ against time, with the predicted slope."""
    figure = new_figure(height=4.6)
    panels = figure.subplots(2, 2, sharex=True, sharey=True)
    for line, name in zip(panels, MOTIONS, strict=True):
        for axes, place in zip(line, ("on", "beside"), strict=True):
            chosen = [r for r in rows if r["case"] == f"{name}, {place} N⁴" and "times" in r]
            for row in chosen:
                look = {**LOOK[row["method"]].line, "ms": 3.5, "lw": 1.0}
                axes.plot(row["times"], row["distances"], label=row["method"], **look)
            if chosen and (slope := chosen[-1]["predicted"]):
                times = np.array([42.0, 74.0])  # below the measured ones
                axes.plot(times, 2e-14 * np.exp(slope * (times - times[0])), color=INK, lw=2.2)
                axes.text(55, 6e-14, rf"$e^{{\lambda t}}$, $\lambda={slope:.3f}$")
            axes.set(yscale="log", ylim=(FLOOR, 10))
            words = "on $N^4$" if place == "on" else r"$\omega_3+10^{-12}$"
            axes.set_title(f"${name}$, {words}")
    label_outer(panels, "$t$", "distance from $N^4$")
    legend_below(figure, panels[0, 0], 5)
    return {"motion-leaving": figure}
