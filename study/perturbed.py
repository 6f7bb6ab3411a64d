"""Off integrability: what small changes of the top do to the tori of N⁴, and what fails first.

One change makes the moments of inertia 2 : 2(1+ε) : 1. The other adds a third field, at right
angles to both and of ε times the length of the longer one, that acts on the third axis.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from kowalevski_cas.motion import load
from kowalevski_cas.motion.compile import Function
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.section import neighbours, section
from kowalevski_cas.motion.transverse import exponent
from kowalevski_cas.pictures import PlotMark, mark, new_figure
from study.charts import legend_below
from study.motions import MOTIONS, Array, parameters
from study.step import Measured, Row, Task

TITLE = "off integrability"

CHANGES = {"moments": "moments 2 : 2(1+ε) : 1", "field": "a third field"}

SIZES = (0.0, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 3e-2, 1e-1)
"""The values of ε."""

SHOWN, DISTANCES, UNTIL = 0.03, np.array([1e-3, 3e-2, 0.1, 0.2, 0.3]), 3000.0
"""The ε of the sections, how far from N⁴ their motions begin, and how long they are."""

RENEWED, RENEWALS, APART = 5.0, 400, 1e-8
"""For exponents: after which time two motions are brought together again, how often, how near."""

LONGER, LONGER_SIZES = 10, (1e-6, 1e-4, 1e-2, 1e-1)
"""Exponents after so many times as long, for these ε: what falls may be zero."""

WRONG, STEP, LATEST = 1e-6, 0.25, 200.0
"""From which error on a method has failed, and at which times that is looked at."""

CAPTION = (
    "The top off integrability, by moments of inertia $2:2(1+\\varepsilon):1$ or by a third field "
    "at right angles to both, $\\varepsilon$ times as long as the longer one. Above, sections "
    "where $\\omega_3$ is largest, of motions beside a hyperbolic torus of $N^4$ at five distances "
    f"from it, before and after the change, $\\varepsilon={SHOWN:g}$. Below on the left the "
    f"largest exponent after $t={RENEWED * RENEWALS:g}$ of a motion that begins on a torus of "
    f"$N^4$: elliptic, {parameters('m > 0')}, or hyperbolic, {parameters('m < 0')}; then when "
    "methods fail first, with an error of $10^{-6}$: the closed form of the unchanged top, and "
    "DOP853 at $10^{-13}$, against Taylor series; what has not failed at "
    f"$t={LATEST:g}$ is drawn there. On the hyperbolic torus at $\\varepsilon=0$ it is the Taylor "
    "series that leaves, and the closed form that is right; its exponent there is "
    f"$\\lambda={exponent(MOTIONS['m < 0'].parameters).real:.3f}$, and what is drawn is a mean "
    "with the time away from the torus. Neighbours that part like $t$ have an exponent of about "
    f"$(\\ln t)/t={np.log(RENEWED * RENEWALS) / (RENEWED * RENEWALS):.3f}$ after so long: that of "
    f"the elliptic torus means zero. Hollow: after a time {LONGER} times as long, in which it "
    "falls as that does. On the hyperbolic torus exponents for $\\varepsilon\\le10^{-4}$ are not "
    "settled, and show no chaos; from $10^{-2}$ on they change by a fifth or less."
)


def rates(change: str, size: float) -> Function:
    """The rates of the nine variables in the changed top, as a function of numbers."""
    moments = (2.0, 2.0 * (1 + size * (change == "moments")), 1.0)

    def changed(*state: Any) -> tuple[Any, ...]:
        omega, alpha, beta = state[:3], state[3:6], state[6:]
        third = _cross(alpha, beta)
        scale = size * (change == "field") / float(MOTIONS["m > 0"].parameters.b)  # |α×β| = ab
        moment = [moments[k] * omega[k] for k in range(3)]
        torque = _cross(moment, omega)
        torque[1] = torque[1] - alpha[2]
        torque[2] = torque[2] + alpha[1]
        torque[0] = torque[0] + beta[2]
        torque[2] = torque[2] - beta[0]
        torque[0] = torque[0] - scale * third[1]
        torque[1] = torque[1] + scale * third[0]
        turning = [torque[k] / moments[k] for k in range(3)]
        return (*turning, *_cross(alpha, omega), *_cross(beta, omega))

    return changed


def _cross(x: Sequence[Any], y: Sequence[Any]) -> list[Any]:
    return [x[k - 2] * y[k - 1] - x[k - 1] * y[k - 2] for k in range(3)]


def measure(quick: bool) -> Iterator[Task]:
    """Sections, exponents and failures, for each change."""
    until = UNTIL / 100 if quick else UNTIL
    yield Task("none", "section", partial(measure_section, "moments", 0.0, until))
    for change in CHANGES:
        yield Task(change, "section", partial(measure_section, change, SHOWN, until))
        for name in MOTIONS:
            sizes = SIZES[::7] if quick else SIZES
            renewals = RENEWALS // 100 if quick else RENEWALS
            yield Task(
                change, f"exponent: {name}", partial(exponents, change, name, sizes, renewals)
            )
            yield Task(
                change, f"longer: {name}",
                partial(longer, change, name, LONGER_SIZES, LONGER * renewals),
            )  # fmt: skip
            latest = LATEST / 20 if quick else LATEST
            yield Task(change, f"failure: {name}", partial(failures, change, name, sizes, latest))


def measure_section(change: str, size: float, until: float) -> Measured:
    """The points of the sections of five motions beside the hyperbolic torus."""
    starts = neighbours(initial_state(MOTIONS["m < 0"]), DISTANCES)
    found = section(starts, until, rates=rates(change, size))
    return {"points": [np.round(states[:, :2], 4).tolist() for states in found]}


def _integrator(change: str, size: float) -> Any:
    import heyoka

    variables = heyoka.make_vars(*(f"x{index}" for index in range(9)))
    system = list(zip(variables, rates(change, size)(*variables), strict=True))
    return heyoka.taylor_adaptive(system, [0.0] * 9)


def exponents(change: str, name: str, sizes: Sequence[float], renewals: int) -> Measured:
    """The largest exponent of the motion that begins on N⁴, for each ε."""
    found = []
    for size in sizes:
        integrator = _integrator(change, size)
        state = initial_state(MOTIONS[name])
        other = state + APART * np.array([1.0, -1, 1, 0, 0, 0, 0, 0, 0]) / np.sqrt(3)
        growth = 0.0
        for _ in range(renewals):
            ends = []
            for begin in (state, other):
                integrator.time, integrator.state[:] = 0.0, begin
                integrator.propagate_until(RENEWED)
                ends.append(integrator.state.copy())
            state, gap = ends[0], ends[1] - ends[0]
            growth += float(np.log(np.linalg.norm(gap) / APART))
            other = state + APART * gap / np.linalg.norm(gap)
        found.append(growth / (renewals * RENEWED))
    return {"sizes": list(sizes), "exponents": found}


def longer(change: str, name: str, sizes: Sequence[float], renewals: int) -> Measured:
    """The same of more renewals."""
    found = exponents(change, name, sizes, renewals)
    return {"sizes": found["sizes"], "longer": found["exponents"]}


def failures(change: str, name: str, sizes: Sequence[float], latest: float) -> Measured:
    """The first time at which each method is wrong by so much, for each ε."""
    from scipy.integrate import solve_ivp

    motion, times = MOTIONS[name], np.arange(STEP, latest, STEP)
    start = initial_state(motion)
    unchanged, closed, dop853 = load("closed")(motion, times), [], []
    for size in sizes:
        integrator, moved = _integrator(change, size), rates(change, size)
        integrator.time, integrator.state[:] = 0.0, start
        exact = integrator.propagate_grid(np.append(0.0, times))[-1][1:]
        by_scipy = solve_ivp(
            lambda _, y, moved=moved: moved(*y.tolist()), (0.0, latest), start, method="DOP853",
            t_eval=times, rtol=1e-13, atol=1e-13,
        ).y.T  # fmt: skip
        closed.append(_failed(unchanged, exact, times))
        dop853.append(_failed(by_scipy, exact, times))
    return {"sizes": list(sizes), "closed": closed, "dop853": dop853}


def _failed(found: Array, exact: Array, times: Array) -> float:
    wrong = np.linalg.norm(found - exact, axis=1) > WRONG * np.linalg.norm(exact, axis=1)
    return float(times[np.argmax(wrong)] if wrong.any() else times[-1])


def draw(rows: Sequence[Row]) -> Figure:
    """Sections above, exponents and failures below."""
    figure = new_figure(height=4.8)
    above, below = figure.subplots(2, 3)
    words = {"none": "before", **CHANGES}
    for axes, (change, title) in zip(above, words.items(), strict=True):
        for row in rows:
            if row["method"] == change and "points" in row:
                _draw_section(axes, row)
        axes.set(xlabel=r"$\omega_1$", ylabel=r"$\omega_2$", aspect="equal")
        axes.set_title(title, size=8)
    below[0].set_title("largest exponent", size=8)
    below[1].set_title("the closed form fails", size=8)
    below[2].set_title("DOP853 fails", size=8)
    for index, (name, change) in enumerate((n, c) for n in MOTIONS for c in CHANGES):
        here = [row for row in rows if row["method"] == change]
        kind = "elliptic" if name == "m > 0" else "hyperbolic"
        found = [row for row in here if row["case"].endswith(f": {name}")]
        _draw_sizes(below, found, mark(index), f"{kind}, {words[change]}")
    for axes in below:
        axes.set_xscale("symlog", linthresh=1e-9)
        axes.set(xlabel=r"$\varepsilon$", xticks=[0, 1e-8, 1e-5, 1e-2])
        axes.minorticks_off()
    for axes in below[1:]:
        axes.set(yscale="log", ylim=(0.1, 2 * LATEST), ylabel="$t$")
    legend_below(figure, below[0], 2)
    return figure


def _draw_sizes(below: Sequence[Axes], rows: Sequence[Row], of: PlotMark, label: str) -> None:
    """Draw what is measured of a torus for each ε; hollow what is so of more time."""
    style = {**of.line, "marker": of.marker, "ms": 3}
    for row in rows:
        for axes, key in zip(below, ("exponents", "closed", "dop853"), strict=True):
            if key in row:
                axes.plot(row["sizes"], row[key], label=label, **style)
        if "longer" in row:
            hollow = {**style, "linestyle": "", "mfc": "none", "ms": 4.5}
            below[0].plot(row["sizes"], row["longer"], **hollow)


def _draw_section(axes: Axes, row: Row) -> None:
    """Draw the points of each motion, the nearest last."""
    for index, points in reversed(list(enumerate(row["points"]))):
        axes.plot(*np.array(points).reshape(-1, 2).T, ".", color=mark(index).colour, ms=1.4, mew=0)
