"""Work against precision: what a state at a late time costs by each method, and how exact it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from statistics import median
from typing import TYPE_CHECKING

import numpy as np

from kowalevski_cas.motion import load
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.pictures import new_figure
from study.charts import curve, digit, seconds
from study.motions import INTEGRATORS, MOTIONS, parameters, relative_error, timed, tolerances
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "work against precision"

NAME, AT = "m > 0", 1000.0

TOLERANCES = {
    "dop853": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13),
    "radau": (1e-3, 1e-4, 1e-5, 1e-6),
    "lsoda": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13),
    "taylor": (1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-16),
}

ROUNDS = 9
MANY, LATEST, CHECKED = 1_000_000, 1e6, 200

CAPTION = (
    f"What the state at $t={AT:g}$ of the motion with {parameters(NAME)} costs, in seconds of "
    "processor time, and how exact it is. The integrators at tolerances down to "
    + tolerances({name: min(found) for name, found in TOLERANCES.items()})
    + f"; the closed form and the balls as the median of {ROUNDS} runs; and the closed form for "
    f"{digit(MANY)} states at random times, $|t|$ up to {digit(LATEST)}, for one of them. Errors "
    "are against rigorous balls, whose own is drawn at the roundoff."
)


def measure(quick: bool) -> Iterator[Task]:
    """The methods that know the motion, then the integrators at their tolerances."""
    case, count = f"t = {AT:g}", MANY // 10 if quick else MANY
    for method in ("closed", "ball"):
        yield Task(method, case, partial(_known, method))
    yield Task("closed", f"{count} states", partial(_many, count))
    for method, found in TOLERANCES.items():
        yield Task(method, case, partial(_integrated, method, found[:1] if quick else found))


def _known(method: str) -> Measured:
    motion, times, states = MOTIONS[NAME], np.array([AT]), load(method)
    spent = median(timed(lambda: states(motion, times))[0] for _ in range(ROUNDS))
    found = relative_error(motion, states(motion, times), times)
    return {"times": [spent], "errors": [max(found, 2.0**-53)]}


def _many(count: int) -> Measured:
    """States at random times on both sides of zero; the time for one of them."""
    random, motion = np.random.default_rng(2004), MOTIONS[NAME]
    times = random.uniform(-LATEST, LATEST, count)
    spent, states = timed(lambda: load("closed")(motion, times))
    chosen = random.choice(count, CHECKED, replace=False)
    error = relative_error(motion, states[chosen], times[chosen])
    return {"times": [spent / count], "errors": [error]}


def _integrated(method: str, found: Sequence[float]) -> Measured:
    motion, times = MOTIONS[NAME], np.array([AT])
    run = partial(INTEGRATORS[method], initial_state(motion), times)
    run(max(found))  # whatever is prepared once
    runs = [timed(partial(run, tolerance)) for tolerance in found]
    return {
        "tolerances": list(found),
        "times": [spent for spent, _ in runs],
        "errors": [relative_error(motion, states, times) for _, states in runs],
    }


def draw(rows: Sequence[Row]) -> Figure:
    """Seconds against the relative error: down is cheaper, to the right is more exact."""
    from matplotlib.ticker import FuncFormatter

    figure = new_figure(height=3.6)
    axes = figure.subplots()
    for row in rows:
        if "errors" in row:
            many = row["case"].endswith("states")
            label = "closed form, many states at once" if many else ""
            curve(axes, row, "errors", "times", label)
            if many:
                axes.lines[-1].set(markerfacecolor="white", linestyle="none")
    axes.set(xscale="log", yscale="log", xlim=(10, 1e-17))
    axes.minorticks_off()
    axes.yaxis.set_major_formatter(FuncFormatter(seconds))
    axes.set_xlabel(f"relative error of the state at $t={AT:g}$")
    axes.set_ylabel("processor time")
    axes.set_title(parameters(NAME), size=8.5)
    axes.legend(loc="lower left")
    return figure
