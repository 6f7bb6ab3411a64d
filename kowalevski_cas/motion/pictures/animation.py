"""The body as it moves, seen from space, as an animated GIF."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.animation import PillowWriter
from matplotlib.patches import Polygon

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.attitude import frames
from kowalevski_cas.motion.general import AnyMotion, General
from kowalevski_cas.motion.methods import load
from kowalevski_cas.motion.pictures.orbit import in_space, periods, times
from kowalevski_cas.motion.pictures.space import View, blank, triad
from kowalevski_cas.motion.units import unit_of
from kowalevski_cas.pictures import INK, mark, new_figure, style

TURNS, FRAMES, RATE = 2.0, 160, 20
"""How often the slower angle turns, in how many frames, of which so many pass in a second."""

SMOOTH = 40
"""Frames that a turn of the quicker angle has at least: if there are too few, less is shown."""

LONG = 40.0
"""How long a motion without angles is followed, for a state of size 1."""

TRAIL = 60
"""How many past places of the end of ω are shown."""

SIZE, DOTS = 4.2, 100

LETTER = 14
"""The height of letters in dots, so that they can be read however small the picture is."""


def write(motion: AnyMotion, path: Path, count: int | None = None, dots: int = DOTS) -> None:
    """Write the animation of a motion to a file, in so many frames, of so many dots to an inch.

    The disc is the plane of e1 and e2, on which the fields act, the rod the axis of symmetry.
    """
    count = count or FRAMES
    states = _states(motion, count)
    body, omega = frames(states), in_space(states)
    view = View(40, 20)
    turn = np.linspace(0, 2 * np.pi, 61)
    disc = np.stack((np.cos(turn), np.sin(turn), 0 * turn), axis=-1)
    tips = np.array([[1.0, 0, 0], [0, 1.0, 0], [0, 0, 0.7], [0, 0, -0.7]])
    scale = 1.5 / max(float(np.max(np.linalg.norm(omega, axis=1))), 1e-9)
    with style(), rc_context({"font.size": LETTER * 72 / dots}):
        figure = new_figure(SIZE, SIZE)
        figure.set_layout_engine("none")
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        blank(axes)
        axes.set(xlim=(-1.75, 1.75), ylim=(-1.75, 1.75))
        axes.set_autoscale_on(False)
        triad(axes, view, (r"$\alpha$", r"$\beta$", r"$\alpha\times\beta$"), 1.5)
        plate = Polygon(view(disc)[0], fc=mark(5).colour, ec=INK, lw=0.8, alpha=0.7, zorder=2)
        axes.add_patch(plate)
        lines = [axes.plot([], [], color=INK, lw=w)[0] for w in (1.2, 1.2, 3.0, 3.0)]
        names = [axes.text(0, 0, f"$e_{k}$", ha="center", va="center") for k in (1, 2)]
        trail = axes.plot([], [], color=mark(1).colour, lw=0.8, alpha=0.6)[0]
        arrow = axes.plot([], [], color=mark(1).colour, lw=2.0)[0]
        label = axes.text(0, 0, r"$\omega$", color=mark(1).colour, ha="center", va="center")
        writer = PillowWriter(fps=RATE)
        with writer.saving(figure, path, dots):
            for now in range(count):
                plate.set_xy(view(disc @ body[now].T)[0])
                places, near = view(tips @ body[now].T)
                for line, (x, y), depth in zip(lines, places, near, strict=True):
                    line.set_data([0, x], [0, y])
                    line.set_zorder(2.5 if depth > 0 or line in lines[:2] else 1.5)
                for name, place in zip(names, places, strict=False):
                    name.set_position(tuple(1.15 * place))
                ends = view(scale * omega[max(0, now - TRAIL) : now + 1])[0]
                trail.set_data(*ends.T)
                arrow.set_data([0, ends[-1, 0]], [0, ends[-1, 1]])
                label.set_position(tuple(1.1 * ends[-1]))
                writer.grab_frame()


def _states(motion: AnyMotion, count: int) -> Array:
    """The states of the frames, by the closed form or, where there is none, by an integrator."""
    if not isinstance(motion, General):
        whole = times(motion, TURNS, count)
        quicker = min((period for period in periods(motion) if period), default=np.inf)
        share = min(1.0, count / SMOOTH * quicker / (whole[-1] - whole[0]))
        return load("closed")(motion, share * whole)
    last = LONG * 2.0 ** -float(unit_of(np.array(motion.point)))
    return load("dop853")(motion, np.linspace(0.0, last, count))
