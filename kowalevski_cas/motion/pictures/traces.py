"""The traces of the field vectors on their spheres in the body."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.pictures.orbit import orbit
from kowalevski_cas.motion.pictures.space import View, sheets, sphere, trace
from kowalevski_cas.motion.units import in_unit
from kowalevski_cas.pictures import mark

CAPTION = (
    "Traces of the field vectors $\\alpha$ and $\\beta$ in the body, on the spheres of radii $a$ "
    "and $b$, to one scale. What a sphere hides is thin and pale."
)

TURNS, POINTS = 14, 6000


def draw(motion: Motion | MotionO4) -> Figure:
    """Both traces of a motion."""
    states = orbit(motion, TURNS, POINTS)
    view, letters = View(), (r"\alpha", r"\beta")
    known = motion.constants_in_unit
    states, lengths = in_unit(states, np.array(motion.parameters.unit)), (known["a"], known["b"])
    figure, axes = sheets(r"$\alpha$, $|\alpha|=a$", r"$\beta$, $|\beta|=b$")
    for index, (panel, letter, length) in enumerate(zip(axes, letters, lengths, strict=True)):
        labels = tuple(rf"${letter}_{k}$" for k in (1, 2, 3))
        sphere(panel, view, length, labels, length + 0.3 * lengths[0])
        trace(panel, view, states[:, 3 + 3 * index : 6 + 3 * index], mark(index).colour)
    return figure
