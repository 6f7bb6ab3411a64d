"""A Poincaré section of a motion and of others on its level."""

from __future__ import annotations

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.critical import residuals
from kowalevski_cas.motion.general import AnyMotion, General
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.section import COORDINATES, OMEGA3, closed_section, neighbours, section
from kowalevski_cas.motion.units import unit_of
from kowalevski_cas.pictures import INK, new_figure

DISTANCES = np.geomspace(1e-7, 0.3, 8)
"""How far away the other motions begin, as shares of the state's size."""

UNTIL = 1500.0
"""For how long, where the size of the state is 1."""

CAPTION = (
    "A Poincaré section: the states at which a coordinate is largest for the moment, of the motion "
    f"(as the axes) and of {len(DISTANCES)} others on its level of $H$ and $G$, the farther from "
    "its colour the farther from it they begin. A motion on $N^4$ or $O^4$, by its closed form, "
    "draws curves; others fill the image of a torus of dimension three. On the right, how far they "
    "are from the critical set that the motion is nearest to: where its tori are elliptic, motions "
    "stay as far from it as they begin; where they are hyperbolic, they go away and come back."
)


def draw(motion: AnyMotion, coordinate: int = OMEGA3) -> Figure:
    """The section of a motion and of its neighbours."""
    start = initial_state(motion)
    until = float(np.ldexp(UNTIL, -int(unit_of(start))))
    starts = neighbours(start, DISTANCES)
    if isinstance(motion, General) or motion.point is not None:
        own, *others = section(np.vstack((start, starts)), until, coordinate)
    else:
        own, others = closed_section(motion, until, coordinate), section(starts, until, coordinate)
    set_name = _nearest(motion, start)

    figure = new_figure(height=3.6)
    left, right = figure.subplots(1, 2)
    across, up = [k for k in (0, 1, 2) if k != coordinate][:2]
    shades = colormaps["viridis"](np.linspace(0, 0.95, len(DISTANCES)))
    for states, shade in zip(reversed(others), reversed(shades), strict=True):
        _put(left, right, states, shade, (across, up), set_name)
    _put(left, right, own, INK, (across, up), set_name)
    left.set(xlabel=_letter(across), ylabel=_letter(up), aspect="equal")
    left.set_title(f"where {_letter(coordinate)} is largest")
    right.set(yscale="log", xlabel="number of the return")
    right.set_title(f"distance from ${set_name[0]}^4$")
    return figure


def _put(
    left: Axes, right: Axes, states: Array, shade: object, plane: tuple[int, int], set_name: str
) -> None:
    left.plot(*states[:, plane].T, ".", color=shade, ms=2.4 if shade is INK else 1.8, mew=0)
    far = np.maximum(residuals(states)[set_name], 1e-17)
    right.plot(far, ".", color=shade, ms=2.0, mew=0)


def _nearest(motion: AnyMotion, start: Array) -> str:
    """The name of the set that the motion is on, or nearest to at t = 0."""
    if not isinstance(motion, General):
        return "O4" if isinstance(motion, MotionO4) else "N4"
    found = {name: float(far[0]) for name, far in residuals(start[None]).items()}
    return min(found, key=lambda name: (np.isnan(found[name]), found[name]))


def _letter(coordinate: int) -> str:
    """A coordinate as mathematics."""
    name = COORDINATES[coordinate]
    return rf"$\{name[:-1]}_{name[-1]}$"
