"""The traces of the field vectors on their spheres in the body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.pictures.orbit import orbit
from kowalevski_cas.motion.pictures.space import View, blank, sphere, trace
from kowalevski_cas.pictures import mark, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CAPTION = (
    "Traces of the field vectors $\\alpha$ and $\\beta$ in the body, on the spheres of radii $a$ "
    "and $b$, to one scale. What a sphere hides is thin and pale."
)

TURNS, POINTS = 14, 6000


def draw(motion: Motion) -> Figure:
    """Both traces of a motion."""
    states = orbit(motion, TURNS, POINTS)
    figure = new_figure(height=3.6)
    view = View()
    axes = figure.subplots(1, 2, sharex=True, sharey=True)
    lengths = (float(motion.parameters.a), float(motion.parameters.b))
    for index, (one, letter, length) in enumerate(
        zip(axes, (r"\alpha", r"\beta"), lengths, strict=True)
    ):
        blank(one)
        one.set_title(rf"${letter}$, $|{letter}|={'ab'[index]}$")
        labels = tuple(rf"${letter}_{k}$" for k in (1, 2, 3))
        sphere(one, view, length, labels, length + 0.3 * lengths[0])
        trace(one, view, states[:, 3 + 3 * index : 6 + 3 * index], mark(index).colour)
    return figure
