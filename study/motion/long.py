"""Very long times: the phase, which every method but the closed form loses.

A phase n·t that is rounded once to a float is wrong by about t·2⁻⁵³ however exact n is. How
much of the state that costs is found in balls: each variable is moved to the time to which
its rounded phase belongs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from kowalevski_cas.motion import Motion, load
from kowalevski_cas.motion.parameters import precision
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.pictures import new_figure
from study.charts import legend_below
from study.motion.cases import FLOOR, MOTIONS, Array, draw_errors, relative_error, timed
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "Motions on N⁴: very long times"

POWERS = tuple(range(0, 31, 2))
ROUNDED = "phase rounded once"
STATES = 8
"""How many times are tried about each power of ten."""


def measure(quick: bool) -> Iterator[Task]:
    """The closed form, and a phase that is rounded once, up to t = 10³⁰."""
    for name, motion in MOTIONS.items():
        for power in POWERS[::5] if quick else POWERS:
            case = f"{name}, t = 1e{power}"
            yield Task("closed", case, partial(_closed, motion, power))
            yield Task(ROUNDED, case, partial(_rounded, motion, power))


def _times(power: int) -> Array:
    return 10.0**power * np.linspace(1.0, 2.0, STATES)


def _closed(motion: Motion, power: int) -> Measured:
    times = _times(power)
    seconds, found = timed(lambda: load("closed")(motion, times))
    error = relative_error(found, load("ball")(motion, times))
    return {"seconds": seconds, "error": error, "time": times[0]}


def _rounded(motion: Motion, power: int) -> Measured:
    times = _times(power)
    with precision(600):
        rates = [as_fraction(oscillation.rate) for oscillation in motion.oscillations()]
    rows = []
    for time in times:
        phases = [Fraction(float(rate) * float(time)) for rate in rates]
        lags = [Fraction(float(time)) - w / rate for w, rate in zip(phases, rates, strict=True)]
        moved = replace(motion, origins=(lags[0], lags[1]))
        rows.append(load("ball")(moved, np.array([time])))
    error = relative_error(np.concatenate(rows), load("ball")(motion, times))
    return {"seconds": None, "error": error, "time": times[0]}


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """The error against time."""
    figure = new_figure(height=3.0)
    panels = figure.subplots(1, 2, sharey=True)
    for axes, name in zip(panels, MOTIONS, strict=True):
        chosen = [row for row in rows if row["case"].startswith(name)]
        for method in ("closed", ROUNDED):
            draw_errors(axes, chosen, method, "time")
        axes.set(xscale="log", yscale="log", ylim=(FLOOR, 30), xlabel="$t$")
        axes.set_title(f"${name}$")
    panels[0].set_ylabel("relative error of the state")
    legend_below(figure, panels[0], 2)
    return {"motion-long": figure}
