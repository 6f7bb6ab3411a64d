r"""How fast methods leave N⁴, against what the cofactor matrix of (15) predicts.

Across a hyperbolic torus every error grows like :math:`e^{\lambda t}`, across an elliptic one
it does not (see :mod:`~kowalevski_cas.motion.transverse`). Each method starts on N⁴, as nearly
as floating point allows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np
from matplotlib.figure import Figure

from kowalevski_cas.motion import Motion, formulas, load
from kowalevski_cas.motion.arrays import Array, Complex
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.transverse import exponent, kind
from kowalevski_cas.pictures import INK, new_figure
from study.charts import curve, legend_below
from study.motions import INTEGRATORS, MOTIONS, parameters, tolerances
from study.step import Measured, Row, Task

TITLE = "leaving N⁴"

TOLERANCES = {"dop853": 1e-13, "radau": 1e-8, "lsoda": 1e-12, "taylor": 1e-16}

SPAN, WINDOWS, POINTS = 80.0, 16, 60
"""The time, the windows into which it is divided, and the states in each of them."""

SMALL, LARGE = 30.0, 1e-3
"""A distance counts as growing from so many times the first one up to this."""

LEFT, RIGHT = (kind(motion.parameters) for motion in MOTIONS.values())

CAPTION = (
    "The distance from $N^4$ of a motion that starts on it: the median in each of "
    f"{WINDOWS} windows of time up to $t={SPAN:g}$. On the left an {LEFT} torus, "
    f"{parameters('m > 0')}; on the right a {RIGHT} one, {parameters('m < 0')}, which "
    r"integrators leave like $e^{\lambda t}$, with the $\lambda$ that follows from the cofactors "
    f"of (15). Tolerances: {tolerances(TOLERANCES)}."
)


def measure(quick: bool) -> Iterator[Task]:
    """The closed form, which cannot leave, and each integrator, on both tori."""
    for name, motion in MOTIONS.items():
        for method in ("closed", *TOLERANCES):
            if not (quick and method == "radau"):
                yield Task(method, name, partial(follow, method, motion))


def follow(method: str, motion: Motion) -> Measured:
    """The distance from N⁴, its median in each window; the rate at which it grows; λ."""
    times = np.linspace(0.0, SPAN, WINDOWS * POINTS + 1)[1:]
    if method == "closed":
        states = load(method)(motion, times)
    else:
        states = INTEGRATORS[method](initial_state(motion), times, TOLERANCES[method])
    found = np.median(distance(states).reshape(WINDOWS, POINTS), axis=1)
    middles = (np.arange(WINDOWS) + 0.5) * SPAN / WINDOWS
    growing = (found > SMALL * found[0]) & (np.maximum.accumulate(found) < LARGE)
    rate = None
    if np.count_nonzero(growing) >= 3:
        rate = float(np.polyfit(middles[growing], np.log(found[growing]), 1)[0])
    return {
        "times": middles.tolist(),
        "distances": found.tolist(),
        "rate": rate,
        "predicted": abs(exponent(motion.parameters).real),
    }


def transverse(states: Array) -> tuple[Complex, Complex]:
    """F1, F2 (…, 2) and the matrices (…, 2, 2) of d(F1,F2)/dt at states (…, 9)."""
    functions, rates = formulas.values_of_offer("across"), formulas.values_of_offer("across_rates")
    known = formulas.values_of_offer("complex_variables")(*np.moveaxis(states, -1, 0), 1j)
    root = np.sqrt(known[0] * known[1])  # of x1x2
    F1, F2, U1, U2 = functions(*known, root)
    columns = [rates(*unit, U1, U2, *known[:2], root) for unit in ((1.0, 0.0), (0.0, 1.0))]
    entries = np.broadcast_arrays(*(column[row] for row in (0, 1) for column in columns), F1)[:4]
    matrix = 1j * np.stack(entries, axis=-1).reshape(*np.shape(F1), 2, 2)  # τ = it
    return np.stack((F1, F2), axis=-1), matrix


def distance(states: Array) -> Array:
    r"""How far states (…, 9) are from N⁴: :math:`|F_1|` and :math:`|F_2|` in one number (…).

    They are added in the ratio of the two entries of the matrix, so that the sum of
    squares stays the same along an elliptic motion, to first order.
    """
    values, matrix = transverse(states)
    ratio = abs(matrix[..., 1, 0] / matrix[..., 0, 1])
    found: Array = np.sqrt(abs(values[..., 0]) ** 2 * ratio + abs(values[..., 1]) ** 2)
    return found


def draw(rows: Sequence[Row]) -> Figure:
    """The distance from N⁴ against time, with the predicted slope."""
    figure = new_figure(height=3.4)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    for axes, name in zip(panels, MOTIONS, strict=True):
        chosen = [row for row in rows if row["case"] == name and "times" in row]
        for row in chosen:
            curve(axes, row, "times", "distances")
        if chosen and (slope := chosen[0]["predicted"]):
            times = np.array([42.0, 74.0])  # below the measured ones
            axes.plot(times, 2e-14 * np.exp(slope * (times - times[0])), color=INK, lw=2.2)
            axes.text(55, 6e-14, rf"$e^{{\lambda t}}$, $\lambda={slope:.3f}$")
        axes.set(yscale="log", xlabel="$t$")
        words = f"{kind(MOTIONS[name].parameters)} torus: {parameters(name)}"
        axes.set_title(words, size=7.5)
    panels[0].set_ylabel("distance from $N^4$")
    legend_below(figure, panels[0], 5)
    return figure
