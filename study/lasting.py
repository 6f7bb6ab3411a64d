"""How long each method is right: the error against time, for each class of state.

Times are in units in which the size of the state is about 1. The closed form, the balls and the
reference begin from constants; integrators from the state that is nearest to them.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cache, partial
from statistics import median

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from kowalevski_cas.motion import Motion, MotionO4, Parameters, formulas, load, through
from kowalevski_cas.motion.general import AnyMotion, General
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.units import in_unit, unit_of
from kowalevski_cas.pictures import new_figure
from study.charts import curve, legend_below, look
from study.motions import INTEGRATORS, MOTIONS, Array, tolerances
from study.process import processor_seconds
from study.splitting import STEP, integrate
from study.step import Measured, Row, Task

TITLE = "how long methods are right"

UNIT = Fraction(1, 10**12)
"""Fields so many times smaller: a unit of time 10⁶ times longer."""


ON_M4 = (0.5, 0.25, 0.3, 0.4375, 0.5, 0.25, -0.75, 0.625, 0.125)
"""A state on M⁴, where K = 0: these floats are on it exactly."""


def beside(motion: AnyMotion, away: float) -> AnyMotion:
    """The motion through a state so far off that of another one."""
    start = initial_state(motion)
    return through((start + away * np.array([1, -1, 1, 0, 0, 0, 0, 0, 0])).tolist())


@cache
def cases() -> dict[str, AnyMotion]:
    """A motion of each class of states, in the order of the panels."""
    unit = Motion.of(UNIT * 12 / 10, UNIT * 7 / 10, Fraction(6, 10) / UNIT, ell="0.9")
    near = Parameters.of(1, "0.4", "0.5", 2 - Fraction(1, 10**12))
    alike = 1 - Fraction(1, 10**9)
    on_M4, unstable = through(ON_M4), MotionO4.of("1.2", "0.7", "0.9", "-0.3")
    return {
        "N⁴, elliptic": MOTIONS["m > 0"],
        "N⁴, hyperbolic": MOTIONS["m < 0"],
        "N⁴, separating curve": Motion(near),
        "N⁴, unit of time 10⁶": unit,
        "O⁴, elliptic": MotionO4.of("1.2", "0.7", "-0.9", "0.6"),
        "O⁴, hyperbolic": unstable,
        "O⁴, fast top: τ = −10⁸": MotionO4.of("1.2", "0.7", "1", "-1e8"),
        "O⁴, σ → 0": MotionO4.of("1.2", "0.7", "0.9", "0.24999975"),
        "O⁴, a − b = 10⁻⁹": MotionO4.of(1, alike, alike / 2, (alike**2 - 1) / 2),
        "M⁴": on_M4,
        "10⁻¹⁰ off M⁴": beside(on_M4, 1e-10),
        "10⁻¹⁰ off N⁴, hyperbolic": beside(MOTIONS["m < 0"], 1e-10),
        "10⁻¹⁰ off O⁴, hyperbolic": beside(unstable, 1e-10),
        "off all sets": through([0.1, 0.2, 0.3, 1, 0, 0, 0, 0.4, 0.2]),
    }


INTEGRATED = {
    "dop853": (INTEGRATORS["dop853"], 1e-13, 3),
    "lsoda": (INTEGRATORS["lsoda"], 1e-12, 3),
    "taylor": (INTEGRATORS["taylor"], 1e-16, 5),
    "splitting": (integrate, STEP, 4),
}
"""The integrators, with their tolerances or steps, and the power of ten up to which they go."""

LONG = {"N⁴, elliptic": {"dop853": 4, "taylor": 6, "splitting": 6}}
"""Who goes how far in one of the panels."""

LAST, REFERENCE = 6, 4
"""The powers of ten of the last time, and of the last one off the sets, where balls do not go."""

COLD_RUNS = 3

CAPTION = (
    "The relative error of the state or of its fields, whichever is larger, against time, for each "
    "class of state, where the unit of time is such that the size of the state is about 1; the one "
    "at a separating curve is $10^{-12}$ away from it in $\\ell$. Errors are against rigorous "
    "balls; off the sets, and on $M^4$, against Taylor series in 113 bits, up to $t=10^4$; the "
    "closed form there is of a state on the set, if there is one beside. Integrators at "
    + tolerances({name: INTEGRATED[name][1] for name in ("dop853", "lsoda", "taylor")})
    + f"; the splitting method, of order four, with steps of {STEP:g}. In the last panel what the "
    "first state costs in seconds of processor time, with the start of Python (hollow) and in a "
    f"process that runs (full), as the median of {COLD_RUNS} runs."
)


def measure(quick: bool) -> Iterator[Task]:
    """Each method on each class of state, then the cold and the warm starts."""
    for name, motion in cases().items():
        last = 1 if quick else LAST if motion.point is None else REFERENCE
        if not isinstance(motion, General):
            yield Task("closed", name, partial(errors, motion, load("closed"), last))
        for method, (run, tolerance, power) in INTEGRATED.items():
            reached = min(last, LONG.get(name, {}).get(method, power))
            states = partial(_from_start, run, tolerance)
            yield Task(method, name, partial(errors, motion, states, reached))
    for method in ("closed", "ball", "dop853", "taylor"):
        yield Task(method, "first state", partial(start, method, 1 if quick else COLD_RUNS))


def _from_start(
    run: Callable[[Array, Array, float], Array], tolerance: float, motion: AnyMotion, times: Array
) -> Array:
    """The states by an integrator, in the unit of time in which the state's size is about 1."""
    begin = initial_state(motion)
    unit = unit_of(begin)
    return in_unit(run(in_unit(begin, unit), np.ldexp(times, unit), tolerance), -unit)


def errors(motion: AnyMotion, states: Callable[[AnyMotion, Array], Array], last: int) -> Measured:
    """The relative errors at powers of ten of the unit of time, up to a last one."""
    times = 10.0 ** np.arange(0, last + 0.5, 0.5)
    unit = unit_of(initial_state(motion))
    scaled = np.ldexp(times, -unit)
    exact, found = (in_unit(of(motion, scaled), unit) for of in (reference, states))
    difference, fields = np.abs(found - exact), slice(3, 9)
    off = np.linalg.norm(difference, axis=1) / np.linalg.norm(exact, axis=1)
    of_fields = np.linalg.norm(difference[:, fields], axis=1)
    off = np.maximum(off, of_fields / np.linalg.norm(exact[:, fields], axis=1))
    return {"times": times.tolist(), "errors": [float(max(one, 2.0**-53)) for one in off]}


def reference(motion: AnyMotion, times: Array) -> Array:
    """The states by balls, or where there is no closed form by Taylor series in 113 bits."""
    if motion.point is None:
        return load("ball")(motion, times)
    import heyoka

    variables = heyoka.make_vars(*(f"x{index}" for index in range(9)))
    rates = formulas.values_of_offer("equations")(*variables)
    number = partial(heyoka.real, prec=113)
    integrator = heyoka.taylor_adaptive(
        list(zip(variables, rates, strict=True)), [number(x) for x in motion.point],
        fp_type=heyoka.real, prec=113,
    )  # fmt: skip
    found = []
    for time in times.tolist():
        integrator.propagate_until(number(time))
        found.append([float(x) for x in integrator.state])
    return np.array(found)


PROGRAM = """
import numpy as np
from kowalevski_cas.motion import Motion, load
load({!r})(Motion.of("1.2", "0.7", "0.6", ell="0.9"), np.array([1.0]))
"""


def start(method: str, runs: int) -> Measured:
    """The seconds for one state in a process of its own, and in this one."""
    call = [sys.executable, "-c", PROGRAM.format(method)]
    states, motion, once = load(method), MOTIONS["m > 0"], np.array([1.0])
    states(motion, once)
    cold = [_seconds(partial(subprocess.run, call, check=True)) for _ in range(runs)]
    warm = [_seconds(partial(states, motion, once)) for _ in range(runs)]
    return {"cold": median(cold), "warm": median(warm)}


def _seconds(call: Callable[[], object]) -> float:
    begin = processor_seconds()
    call()
    return processor_seconds() - begin


def draw(rows: Sequence[Row]) -> Figure:
    """A panel a class of states, and one of starts."""
    figure = new_figure(height=9.1)
    panels = list(figure.subplots(5, 3, sharex=False).flat)
    for axes, name in zip(panels, cases(), strict=False):
        for row in rows:
            if row["case"] == name and "errors" in row:
                curve(axes, row, "times", "errors")
                axes.lines[-1].set(ms=2.8, lw=1.0)
        axes.set(xscale="log", yscale="log", xlim=(0.7, 2 * 10.0**LAST), ylim=(1e-17, 10))
        axes.set_yticks([1e-16, 1e-12, 1e-8, 1e-4, 1])
        axes.set_xticks([1, 1e2, 1e4, 1e6])
        axes.set_title(name, size=8)
        axes.minorticks_off()
    for axes in panels[:-1:3]:
        axes.set_ylabel("relative error")
    for axes in panels[12:14]:
        axes.set_xlabel("$t$")
    _draw_starts(panels[-1], [row for row in rows if "cold" in row])
    legend_below(figure, panels[0], len(INTEGRATED) + 1)
    return figure


def _draw_starts(axes: Axes, rows: Sequence[Row]) -> None:
    """The seconds for a first state, cold and warm."""
    for place, row in enumerate(rows):
        style = look(row["method"])
        for seconds, fill in ((row["cold"], "white"), (row["warm"], style.colour)):
            axes.plot(seconds, place, style.marker, color=style.colour, mfc=fill, ms=5)
    axes.set(xscale="log", xlim=(1e-4, 30), xlabel="seconds")
    axes.set_title("first state", size=8)
    axes.set_yticks(range(len(rows)), [row["method"] for row in rows], size=7)
    axes.invert_yaxis()
