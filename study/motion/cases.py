"""What the steps about motions share: two motions, the integrators, errors."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from time import process_time
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion import Motion, Parameters
from kowalevski_cas.motion.formulas import INTEGRALS, integrals
from kowalevski_cas.motion.methods import taylor
from kowalevski_cas.motion.methods.integrators import integrate
from kowalevski_cas.pictures import Mark, mark
from study.step import Row

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]
Integrator = Callable[[Array, Array, float], Array]

MOTIONS = {
    "m > 0": Motion(Parameters.of("1.2", "0.7", "0.6", "0.9")),
    "m < 0": Motion(Parameters.of("1.2", "0.7", "-0.5", "0.33")),
}
"""A motion on an elliptic torus, and one on a hyperbolic torus."""

INTEGRATORS: dict[str, Integrator] = {
    "dop853": partial(integrate, "DOP853"),
    "radau": partial(integrate, "Radau"),
    "lsoda": partial(integrate, "LSODA"),
    "taylor": taylor.integrate,
}
"""The states at some times, by the state at t = 0, the times, and a tolerance."""

SLOWEST = "radau"
"""The integrator that a quick study leaves out."""

LOOK: dict[str, Mark] = {
    name: mark(index)
    for index, name in enumerate(("closed", *INTEGRATORS, "ball", "phase rounded once"))
}
"""The mark of each method, in all charts of motions."""

FLOOR = 1e-17
"""Where an error is drawn that is smaller still, or zero."""


def relative_error(found: Array, exact: Array) -> float:
    """The largest error of states (N, 9), each relative to the length of the state."""
    return float(np.max(np.linalg.norm(found - exact, axis=1) / np.linalg.norm(exact, axis=1)))


def drift(start: Array, end: Array) -> dict[str, float]:
    """How far each integral is from its value at the start, for two states (9)."""
    before, after = integrals()(*start), integrals()(*end)
    return {name: abs(float(b - a)) for name, a, b in zip(INTEGRALS, before, after, strict=True)}


def timed(run: Callable[[], Any]) -> tuple[float, Any]:
    """The seconds of processor time that a call took, and its result."""
    begin = process_time()
    result = run()
    return process_time() - begin, result


def forecast(run: Callable[[float], Any], pilot: float, span: float) -> float:
    """The seconds that a run up to ``span`` would take, by runs up to ``pilot`` and three times it.

    What is spent at the start of every run is not taken for slowness.
    """
    run(pilot)  # whatever is prepared once
    short, _ = timed(lambda: run(pilot))
    longer, _ = timed(lambda: run(3 * pilot))
    return longer + max(longer - short, 0.0) * (span - 3 * pilot) / (2 * pilot)


def draw_errors(
    axes: Axes, rows: Iterable[Row], method: str, x: str, y: str = "error", label: str = ""
) -> None:
    """Draw what a method measured, those rows that have it; what is exact is at the floor."""
    chosen = [row for row in rows if row["method"] == method and y in row]
    if chosen:
        axes.plot(
            [row[x] for row in chosen],
            [max(row[y], FLOOR) for row in chosen],
            label=label or method,
            **LOOK[method].line,
        )
