"""The torus of a motion: flat, by its two angles, and as a surface of angular velocities."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.pictures.orbit import net, orbit, periods, times
from kowalevski_cas.motion.pictures.space import View, blank, curve, reach, triad
from kowalevski_cas.pictures import FAINT, mark, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CAPTION = (
    "One trajectory fills its torus. On the left the torus is flat: $T_1$ and $T_2$ are the "
    "periods of the two angles, and $t_1$, $t_2$ their origins; opposite sides of the square are "
    "the same. On the right the torus is the surface of the angular velocities in the body; on "
    "each line of the net one of the angles rests."
)

TURNS, POINTS = 12, 4000
LINES = 18
"""How many lines the net has of each kind."""


def draw(motion: Motion) -> Figure:
    """The torus of a motion, filled by it."""
    figure = new_figure(height=3.3)
    flat, solid = figure.subplots(1, 2)
    line = mark(0)

    t = times(motion, TURNS, POINTS)
    angles = [
        (t - float(origin)) / period % 1 if 0 < period < np.inf else np.zeros_like(t)
        for origin, period in zip(motion.origins, periods(motion), strict=True)
    ]
    jumps = np.flatnonzero(np.any(np.abs(np.diff(angles)) > 0.5, axis=0)) + 1
    for piece in np.split(np.arange(len(t)), jumps):
        flat.plot(angles[0][piece], angles[1][piece], color=line.colour, lw=0.8)
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
    curve(solid, view, states[:, :3], line.colour, 0.9)
    triad(solid, view, (r"$\omega_1$", r"$\omega_2$", r"$\omega_3$"), reach(states[:, :3]))
    return figure
