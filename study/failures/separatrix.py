r"""Close to a separating curve: :math:`C\to a`, where the modulus of an elliptic function is 1.

Constants are exact, so that ε may be smaller than any float can show beside 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial

import numpy as np
from matplotlib.axes import Axes

from kowalevski_cas.motion import Motion, Parameters, load
from kowalevski_cas.motion.methods.integrators import initial_state
from study.charts import curve
from study.motions import INTEGRATORS, relative_error, tolerances
from study.step import Measured, Row, Task

TITLE = "near a separating curve"

POWERS = (1, 2, 4, 6, 8, 10, 12, 15, 18, 22, 30, 40)
"""The powers of ten of 1/ε."""

TOLERANCES = {"dop853": 1e-13, "taylor": 1e-16}

SPAN = 100.0

CAPTION = (
    r"motions with $a=1$, $b=0.4$, $m=0.5$, $\ell=2-\varepsilon$ at "
    f"$t={SPAN:g}$; tolerances {tolerances(TOLERANCES)}; errors begin to grow when a motion has "
    "left the curve and come back, the later the larger $k$ is: for $k=40$ after $t=80$"
)


def measure(quick: bool) -> Iterator[Task]:
    """The closed form and the integrators, for each ε."""
    powers = POWERS[::6] if quick else POWERS
    for method in ("closed", *TOLERANCES):
        yield Task(method, "separatrix", partial(errors, method, powers))


def errors(method: str, powers: Sequence[int]) -> Measured:
    """The relative errors of the states of a method."""
    found, times = [], np.array([SPAN])
    for power in powers:
        motion = Motion(Parameters.of(1, "0.4", "0.5", 2 - Fraction(1, 10**power)))
        if method == "closed":
            states = load("closed")(motion, times)
        else:
            states = INTEGRATORS[method](initial_state(motion), times, TOLERANCES[method])
        found.append(relative_error(motion, states, times))
    return {"powers": list(powers), "errors": found}


def draw(axes: Axes, rows: Sequence[Row]) -> None:
    """The error against the power of 1/ε."""
    for row in rows:
        curve(axes, row, "powers", "errors")
    axes.set_xlabel(r"$k$: $a-C\sim10^{-k}$")
