"""The hodographs of the angular velocity, in the body and in space."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.pictures.orbit import in_space, orbit
from kowalevski_cas.motion.pictures.space import View, blank, curve, reach, triad
from kowalevski_cas.pictures import mark, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CAPTION = (
    "Hodographs of the angular velocity, in the body and in space, where the axes are those of the "
    "two fields. The fields fix the orientation of the body, so nothing else had to be integrated."
)

TURNS, POINTS = 14, 4000


def draw(motion: Motion) -> Figure:
    """Both hodographs of a motion, to one scale."""
    states = orbit(motion, TURNS, POINTS)
    figure = new_figure(height=3.6)
    view = View()
    axes = figure.subplots(1, 2, sharex=True, sharey=True)
    length = 1.5 * reach(states[:, :3])
    for index, (one, title, points, labels) in enumerate(
        (
            (axes[0], "in the body", states[:, :3], (r"$\omega_1$", r"$\omega_2$", r"$\omega_3$")),
            (
                axes[1],
                "in space",
                in_space(states),
                (r"$\alpha$", r"$\beta$", r"$\alpha\times\beta$"),
            ),
        )
    ):
        blank(one)
        one.set_title(title)
        triad(one, view, labels, length)
        curve(one, view, points, mark(index).colour)
    return figure
