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
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kowalevski_cas.motion import Motion, load
from kowalevski_cas.motion.parameters import precision
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.pictures import mark, new_figure, save, style
from study.motion.cases import LOOK, MOTIONS, Array, relative_error, timed
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
    return {"seconds": seconds, "verdict": "measured", "error": error, "time": times[0]}


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
    return {"seconds": None, "verdict": "measured", "error": error, "time": times[0]}


def draw(rows: Sequence[Row], folder: Path) -> None:
    """The error against time."""
    with style():
        save(_chart(rows), folder, "motion-long")


def _chart(rows: Sequence[Row]) -> Figure:
    figure = new_figure(height=3.0)
    panels = figure.subplots(1, 2, sharey=True)
    for axes, name in zip(panels, MOTIONS, strict=True):
        for method, look in (("closed", LOOK["closed"]), (ROUNDED, mark(6))):
            chosen = [
                row for row in rows
                if row["method"] == method and row["case"].startswith(name) and "error" in row
            ]  # fmt: skip
            axes.plot(
                [row["time"] for row in chosen],
                [max(row["error"], 1e-17) for row in chosen],
                color=look.colour, marker=look.marker, ls=look.dashes, label=method,
            )  # fmt: skip
        axes.set(xscale="log", yscale="log", ylim=(1e-17, 30), xlabel="$t$")
        axes.set_title(f"${name}$")
    panels[0].set_ylabel("relative error of the state")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure
