"""The torus of a motion: flat, by its two angles, and as a surface of angular velocities."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.pictures.orbit import net, orbit, periods, times
from kowalevski_cas.motion.pictures.space import View, blank, curve, reach, triad
from kowalevski_cas.pictures import FAINT, mark, new_figure

CAPTION = (
    "One trajectory fills its torus. On the left the torus is flat: $T_1$ and $T_2$ are the "
    "periods of the two angles, and $t_1$, $t_2$ their origins; opposite sides of the square are "
    "the same. On the right the torus is the surface of the angular velocities in the body; on "
    "each line of the net one of the angles rests; the axes have the length that is told."
)

TURNS, POINTS = 12, 4000
LINES = 18
"""How many lines the net has of each kind."""


def draw(motion: Motion) -> Figure:
    """The torus of a motion, filled by it."""
    figure = new_figure(height=3.3)
    flat, solid = figure.subplots(1, 2)
    t, whole = times(motion, TURNS, POINTS), periods(motion)
    if 0 < min(whole) and max(whole) < np.inf:
        _fill(flat, t, motion)
    else:
        words = "This motion fills no torus:\na variable rests, or tends to rest."
        flat.text(0.5, 0.5, words, ha="center")
    flat.set(xlim=(0, 1), ylim=(0, 1), xticks=(0, 0.5, 1), yticks=(0, 0.5, 1), aspect="equal")
    flat.set_xlabel(r"$(t-t_1)/T_1$ modulo 1")
    flat.set_ylabel(r"$(t-t_2)/T_2$ modulo 1")
    flat.grid(False)
    for side in ("top", "right"):
        flat.spines[side].set_visible(True)

    view = View()
    blank(solid)
    states = orbit(motion, TURNS, POINTS)
    for loop in net(motion, LINES, 121):
        curve(solid, view, loop[:, :3], FAINT, 0.45, 1.0)
    curve(solid, view, states[:, :3], mark(0).colour, 0.9)
    length = reach(states[:, :3])
    triad(solid, view, (r"$\omega_1$", r"$\omega_2$", r"$\omega_3$"), length)
    solid.set_title(f"axes {length:g}")
    return figure


def _fill(axes: Axes, t: Array, motion: Motion) -> None:
    """Draw the trajectory in the square of the angles, a piece for each passage."""
    angles = [
        (t - float(origin)) / period % 1
        for origin, period in zip(motion.origins, periods(motion), strict=True)
    ]
    jumps = np.flatnonzero(np.any(np.abs(np.diff(angles)) > 0.5, axis=0)) + 1
    for piece in np.split(np.arange(len(t)), jumps):
        axes.plot(angles[0][piece], angles[1][piece], color=mark(0).colour, lw=0.8)
