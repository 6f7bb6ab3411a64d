"""The rectangle of the separated variables, with the curve that the motion draws in it."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.methods.closed import Closed
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.pictures.orbit import times
from kowalevski_cas.pictures import INK, mark, new_figure

CAPTION = (
    "The separated variables $s_1$ and $s_2$ move between roots, independently of each other. "
    "Where $s_1$ passes infinity, that is where $x_1x_2=0$, its inverse is shown. On the left "
    "the curve that the motion draws in their rectangle, on the right each of them against time."
)

TURNS, POINTS = 8, 3000


def draw(motion: Motion) -> Figure:
    """The curve of a motion in the plane of s1 and s2."""
    figure = new_figure(height=3.0)
    plane, first, second = figure.subplot_mosaic("ab;ac", width_ratios=(1, 1.25)).values()
    t = times(motion, TURNS, POINTS)
    shown: list[Array] = []
    names: list[str] = []
    for variable, oscillation in zip(
        Closed(motion, float(np.max(np.abs(t)))).variables(t, t), motion.oscillations(), strict=True
    ):
        inverse = oscillation.arc.infinite
        shown.append(variable.weight / variable.s if inverse else variable.s / variable.weight)
        names.append(f"$1/s_{len(names) + 1}$" if inverse else f"$s_{len(names) + 1}$")
    plane.plot(*shown, color=mark(0).colour, lw=0.7)
    early = t <= t[-1] / 2 if t[0] == 0 else np.full_like(t, True, dtype=bool)
    for axes, values, index in ((first, shown[0], 0), (second, shown[1], 1)):
        axes.plot(t[early], values[early], color=mark(index).colour, lw=1.0)
        axes.set_ylabel(names[index], rotation=0, labelpad=12)
    first.tick_params(labelbottom=False)
    second.set_xlabel("$t$")

    edges = []
    for index, oscillation in enumerate(motion.oscillations()):
        ends, labels = _ends(oscillation)
        edges.append(ends)
        (plane.set_xticks, plane.set_yticks)[index](ends, labels)
        (first, second)[index].set_yticks(ends, labels)
    (left, right), (low, high) = edges
    plane.add_patch(Rectangle((left, low), right - left, high - low, fill=False, ec=INK, lw=1.0))
    plane.set_xlabel(names[0])
    plane.set_ylabel(names[1], rotation=0, labelpad=12)
    plane.grid(False)
    for side in ("left", "bottom"):
        plane.spines[side].set_visible(False)
    return figure


def _ends(oscillation: Oscillation) -> tuple[list[float], list[str]]:
    """The ends of an arc, or their inverses where it passes infinity, and their names."""
    roots = oscillation.arc.ends
    values = [float(oscillation.root(root)) for root in roots]
    if not oscillation.arc.infinite:
        return values, [f"${root}$" for root in roots]
    names = [f"$-1/{root[1:]}$" if root.startswith("-") else f"$1/{root}$" for root in roots]
    return [1 / value for value in values], names
