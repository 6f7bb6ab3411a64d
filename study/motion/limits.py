"""Where methods fail: close to the separating curves, m → 0, a → b.

Constants are exact, so that ε may be smaller than any float can show beside 1.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kowalevski_cas.motion import Motion, Parameters, load
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.pictures import FAINT, new_figure
from study.charts import label_outer, legend_below
from study.motion.cases import (
    FLOOR,
    INTEGRATORS,
    Array,
    draw_errors,
    forecast,
    relative_error,
    timed,
)
from study.step import Measured, Row, Task, left_out

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "Motions on N⁴: close to the separating curves and in other limits"


class Limit(NamedTuple):
    """A way for constants to become special: in words of mathematics, and as ε → 0."""

    words: str
    at: Callable[[Fraction], Parameters]


def _near(m: str, ell: str, sign: int = 1) -> Callable[[Fraction], Parameters]:
    return lambda e: Parameters.of(1, "0.4", m, Fraction(ell) + sign * e)


LIMITS = {
    "rest-1": Limit(r"$A-a\sim\varepsilon$: $s_1$ comes to rest", _near("0.8", "0.6")),
    "rest-2": Limit(r"$C+b\sim\varepsilon$: $s_2$ comes to rest", _near("0.5", "0.6")),
    "asymptotic-1": Limit(r"$a-C\sim\varepsilon$: $k\to1$ for $s_1$", _near("0.5", "2", -1)),
    "asymptotic-2": Limit(r"$C-b\sim\varepsilon$: $k\to1$ for $s_2$", _near("0.5", "1.4")),
    "infinite": Limit(r"$C-a\sim\varepsilon$, $m<0$: $k\to1$", _near("-0.4", "0.2", -1)),
    "zero-l": Limit(r"$\ell=\varepsilon$, $m<0$: $1-k^2\sim\varepsilon^2$", _near("-0.5", "0")),
    "zero-m": Limit(
        r"$m=\varepsilon$, $h=1.2$", lambda e: Parameters.at_energy(1, "0.4", e, "1.2")
    ),
    "zero-minus-m": Limit(
        r"$m=-\varepsilon$, $h=1.2$", lambda e: Parameters.at_energy(1, "0.4", -e, "1.2")
    ),
    "equal-fields": Limit(r"$a-b=\varepsilon$", lambda e: Parameters.of(1, 1 - e, "0.5", "1.5")),
}

POWERS = (1, 2, 4, 6, 8, 10, 12, 15, 18, 22, 30, 40)
"""The powers of ten of 1/ε."""

TOLERANCES = {"dop853": 1e-13, "lsoda": 1e-12, "taylor": 1e-16}
SPAN, LAST = 100.0, 1e6
"""The time for integrators, and the last time for the closed form."""

PILOT, MOST = 10.0, 2.0
"""The phase nt over which the speed of an integrator is measured, and the seconds it may take."""


def measure(quick: bool) -> Iterator[Task]:
    """The closed form and the integrators, in each limit, for each ε."""
    for name, limit in LIMITS.items():
        for power in POWERS[::6] if quick else POWERS:
            case, epsilon = f"{name}, ε = 1e-{power}", Fraction(1, 10**power)
            yield Task("closed", case, partial(_closed, limit, epsilon))
            for method in TOLERANCES:
                yield Task(method, case, partial(_run, method, limit, epsilon))


def _closed(limit: Limit, epsilon: Fraction) -> Measured:
    """The largest error at times up to :data:`LAST`."""
    motion = Motion(limit.at(epsilon))
    times = np.concatenate([[0.0], np.geomspace(0.1, LAST, 29)])
    seconds, found = timed(lambda: load("closed")(motion, times))
    error = relative_error(found, load("ball")(motion, times))
    return {"seconds": seconds, "error": error, "epsilon": float(epsilon)}


def _run(method: str, limit: Limit, epsilon: Fraction) -> Measured:
    motion, tolerance = Motion(limit.at(epsilon)), TOLERANCES[method]
    integrate, start = INTEGRATORS[method], initial_state(motion)
    fastest = max(float(oscillation.rate) for oscillation in motion.oscillations())

    def run(time: float) -> Array:
        return integrate(start, np.array([time]), tolerance)

    try:
        needed = forecast(run, min(PILOT / fastest, SPAN / 3), SPAN)
    except ModuleNotFoundError as missing:
        return left_out(str(missing))
    if needed > MOST:
        return left_out(f"it would take about {needed:.1g} s, more than {MOST:g} s")
    seconds, found = timed(lambda: run(SPAN))
    error = relative_error(found, load("ball")(motion, np.array([SPAN])))
    return {"seconds": seconds, "error": error, "epsilon": float(epsilon)}


# -- the chart ----------------------------------------------------------------------


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """The error against ε, a panel for each limit."""
    figure = new_figure(height=5.6)
    panels = figure.subplots(3, 3, sharex=True, sharey=True)
    times = {"closed": "t ≤ 10⁶", **dict.fromkeys(TOLERANCES, f"t = {SPAN:g}")}
    for axes, (name, limit) in zip(panels.flat, LIMITS.items(), strict=True):
        chosen = [row for row in rows if row["case"].startswith(f"{name},")]
        for method, time in times.items():
            draw_errors(axes, chosen, method, "epsilon", label=f"{method}, {time}")
        for line in axes.lines:
            line.set(ms=3.5, lw=1.0)
        axes.axvline(2.0**-53, color=FAINT, lw=0.8, zorder=0)
        axes.set(xscale="log", yscale="log", xlim=(1, 1e-42), ylim=(FLOOR, 30))
        axes.set_title(limit.words, size=8)
    label_outer(panels, r"$\varepsilon$", "relative error")
    legend_below(figure, panels[0, 0], 4)
    return {"motion-limits": figure}
