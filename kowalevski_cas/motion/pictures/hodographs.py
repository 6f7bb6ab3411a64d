"""The hodographs of the angular velocity, in the body and in space."""

from __future__ import annotations

from matplotlib.figure import Figure

from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.pictures.orbit import in_space, orbit
from kowalevski_cas.motion.pictures.space import View, curve, reach, sheets, triad
from kowalevski_cas.pictures import mark

CAPTION = (
    "Hodographs of the angular velocity, in the body and in space, where the axes are those of the "
    "two fields; they have the length that is told. The fields fix the orientation of the body, so "
    "nothing else had to be integrated."
)

TURNS, POINTS = 14, 4000


def draw(motion: Motion | MotionO4) -> Figure:
    """Both hodographs of a motion, to one scale."""
    states = orbit(motion, TURNS, POINTS)
    omega, view = states[:, :3], View()
    length = reach(omega, 0.75)
    told = f"axes {length:g}"
    figure, axes = sheets(f"in the body; {told}", f"in space; {told}")
    curves = (omega, in_space(states))
    labels = (
        (r"$\omega_1$", r"$\omega_2$", r"$\omega_3$"),
        (r"$\alpha$", r"$\beta$", r"$\alpha\times\beta$"),
    )
    for index, panel in enumerate(axes):
        triad(panel, view, labels[index], length)
        curve(panel, view, curves[index], mark(index).colour)
    return figure
