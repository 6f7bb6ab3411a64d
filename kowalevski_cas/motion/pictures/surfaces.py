"""The bifurcation diagram of the whole top in space: surfaces of critical values."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.cut import rotations, section
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.pictures.sections import SETS
from kowalevski_cas.motion.pictures.space import View, blank, triad
from kowalevski_cas.paper.closed_form import CriticalSets
from kowalevski_cas.pictures import INK, PlotMark, mark, new_figure

ABOUT = CriticalSets

CAPTION = (
    "The bifurcation diagram of the whole top in the space of $(h,g,\\sqrt{k})$: sections of the "
    "surfaces on which the three integrals are dependent, at equal steps of $h$. The lines across "
    "them are the values at rotations about the third axis."
)

LEVELS = 26


def draw(motion: Motion | MotionO4) -> Figure:
    """The surfaces for the fields of a motion."""
    fields = Fields(motion.parameters.a, motion.parameters.b)
    size = float(fields.a + fields.b)
    figure, view = new_figure(height=5.2), View(-62, 20)
    axes = figure.subplots()
    blank(axes)
    levels = np.linspace(-size, 2 * size, LEVELS + 1)[1:]
    across: tuple[list[list[float]], ...] = ([], [])
    for level in levels.tolist():
        for index, curves in enumerate(section(fields, level)):
            for number, (g, root, *_) in enumerate(curves):
                points = np.stack([np.full_like(g, level), g, root], axis=-1)
                label = SETS[index] if number == 0 and level == levels[-1] else None
                line(axes, view, points, mark((2, 0, 1)[index]), 0.8, label)
        for side, (at_g, at_root, _) in zip(across, rotations(fields, level), strict=False):
            side.append([level, at_g, at_root])
    for side in across:
        line(axes, view, np.array(side), PlotMark(INK, "", "-"), 1.6)
    triad(axes, view, ("$h$", "$g$", r"$\sqrt{k}$"), 2.2 * size)
    figure.legend(loc="outside lower center", ncols=3)
    return figure


def line(
    axes: Axes,
    view: View,
    points: Array,
    plot_mark: PlotMark,
    width: float,
    label: str | None = None,
) -> None:
    """Draw the curve through points (N, 3), what is nearer over what is farther."""
    flat, near = view(points)
    depth = float(np.nan_to_num(np.nanmean(near))) if np.isfinite(near).any() else 0.0
    order = 2 + depth / 100
    axes.plot(*flat.T, **plot_mark.line, lw=width, label=label, zorder=order)
