"""Late times: a phase n·t that is rounded once is wrong by about t·2⁻⁵³, however exact n is.

How much of the state that costs is found in balls: each variable is moved to the time to which
its rounded phase belongs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from kowalevski_cas.motion import Motion, load
from kowalevski_cas.motion.parameters import precision
from kowalevski_cas.motion.phases import as_fraction
from study.charts import curve
from study.motions import MOTIONS, Array, parameters, relative_error
from study.step import Measured, Row, Task

TITLE = "the phase at late times"

NAME = "m > 0"

POWERS = tuple(range(0, 31, 2))
STATES = 8
"""How many times are tried about each power of ten."""

ROUNDED = "phase rounded once"

CAPTION = (
    f"the motion with {parameters(NAME)} by its closed form, and with each phase rounded once; "
    f"{STATES} times from $10^k$ to $2\\cdot10^k$, $k\\le{max(POWERS)}$"
)


def measure(quick: bool) -> Iterator[Task]:
    """The closed form, and phases that are rounded once, up to t = 10³⁰."""
    for method, states in (("closed", load("closed")), (ROUNDED, round_phases)):
        yield Task(method, "phase", partial(errors, states, POWERS[::5] if quick else POWERS))


def errors(states: Any, powers: Sequence[int]) -> Measured:
    """The largest relative error of states about each power of ten."""
    spans = [10.0**power * np.linspace(1.0, 2.0, STATES) for power in powers]
    motion = MOTIONS[NAME]
    found = [relative_error(motion, states(motion, times), times) for times in spans]
    return {"powers": list(powers), "errors": found}


def round_phases(motion: Motion, times: Array) -> Array:
    """The states (N, 9) with each phase rounded once to a float, and exact otherwise."""
    with precision(600):
        rates = [as_fraction(oscillation.rate) for oscillation in motion.oscillations()]
    rows = []
    for time in times:
        phases = [Fraction(float(rate) * float(time)) for rate in rates]
        lags = [Fraction(float(time)) - w / rate for w, rate in zip(phases, rates, strict=True)]
        moved = replace(motion, origins=(lags[0], lags[1]))
        rows.append(load("ball")(moved, np.array([time])))
    return np.concatenate(rows)


def draw(axes: Axes, rows: Sequence[Row]) -> None:
    """The error against the power of t."""
    for row in rows:
        curve(axes, row, "powers", "errors")
    axes.set_xlabel("$k$: $t=10^k$")
