"""Curves in space on paper: parallel projection, the near dark and the far pale."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyArrowPatch
from matplotlib.patheffects import withStroke

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.pictures import FAINT, INK, new_figure

LABEL = 9.0
"""How far the label of an axis is from its tip, in points."""

FAR = 0.25
"""How much of its colour a line keeps where it is farthest away."""


@dataclass(frozen=True)
class View:
    """A direction of view, in degrees: ``azimuth`` about the third axis, ``elevation`` above."""

    azimuth: float = 35.0
    elevation: float = 22.0

    def __call__(self, points: Array) -> tuple[Array, Array]:
        """The places on paper (…, 2) of points (…, 3), and how near they are (…)."""
        turn, rise = np.radians((self.azimuth, self.elevation))
        right = np.array((-np.sin(turn), np.cos(turn), 0.0))
        near = np.array((np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)))
        up = np.cross(near, right)
        return points @ np.stack((right, up), axis=1), points @ near


def sheets(*titles: str) -> tuple[Figure, list[Axes]]:
    """A figure with blank sheets side by side, all to one scale."""
    figure = new_figure(height=3.6)
    found = list(figure.subplots(1, len(titles), sharex=True, sharey=True))
    for axes, title in zip(found, titles, strict=True):
        blank(axes)
        axes.set_title(title)
    return figure, found


def blank(axes: Axes) -> None:
    """Make paper of axes: equal scales, no frame, no ticks."""
    axes.set_aspect("equal")
    axes.set_axis_off()


def curve(
    axes: Axes, view: View, points: Array, colour: str, width: float = 0.9, order: float = 2.0
) -> None:
    """Draw the curve through points (N, 3), its far parts paler and under the near ones."""
    flat, near = view(points)
    middle = (near[:-1] + near[1:]) / 2
    low, high = middle.min(), middle.max()
    share = FAR + (1 - FAR) * (middle - low) / max(high - low, 1e-9)
    colours = 1 - share[:, None] * (1 - np.array(to_rgb(colour)))
    sorted_ = np.argsort(middle, kind="stable")
    segments = np.stack((flat[:-1], flat[1:]), axis=1)
    lines = LineCollection(
        list(segments[sorted_]),
        colors=list(colours[sorted_]),
        linewidths=list(width * share[sorted_]),
        capstyle="round",
        zorder=order,
    )
    axes.add_collection(lines)
    axes.autoscale_view()


def reach(points: Array, share: float = 0.5) -> float:
    """The length that axes have beside points (N, 3): a share of the largest coordinate, round."""
    return float(f"{share * np.max(np.abs(points)):.1g}") or 1.0


def triad(
    axes: Axes,
    view: View,
    labels: tuple[str, ...],
    length: float,
    start: float = 0.0,
    at: tuple[float, float] = (0.0, 0.0),
) -> None:
    """Draw three axes of this length, labelled at their ends, from the origin or beyond it.

    ``at`` is the place of the origin in the picture.
    """
    clear = [withStroke(linewidth=2.5, foreground="white")]
    tips, near = view(length * np.eye(3))
    for label, tip, depth in zip(labels, tips, near, strict=True):
        arrow = FancyArrowPatch(
            tuple(at + start / length * tip), tuple(at + tip), arrowstyle="-|>", mutation_scale=7,
            shrinkA=0, shrinkB=0, color=INK, lw=0.7, clip_on=False,
            zorder=1.5 if depth < 0 else 3.0,
        )  # fmt: skip
        axes.add_patch(arrow)
        along = tip / max(float(np.hypot(*tip)), 1e-9)
        axes.annotate(
            label, at + tip, tuple(LABEL * along), textcoords="offset points", ha="center",
            va="center", zorder=4.0, path_effects=clear, annotation_clip=False,
        )  # fmt: skip
        axes.update_datalim((at + tip + 0.1 * length * along,))
    axes.autoscale_view()


def sphere(axes: Axes, view: View, radius: float, labels: tuple[str, ...], length: float) -> None:
    """Draw a sphere about the origin with parallels and meridians, and axes that come out of it."""
    axes.add_patch(Circle((0, 0), radius, fill=False, ec=FAINT, lw=0.7, zorder=1))
    turn = np.linspace(0, 2 * np.pi, 181)
    round_, up = np.stack((np.cos(turn), np.sin(turn), 0 * turn), axis=-1), np.array((0, 0, 1))
    circles = [
        np.cos(latitude) * round_ + np.sin(latitude) * up
        for latitude in np.radians((-60, -30, 0, 30, 60))
    ]
    for longitude in np.radians((0, 30, 60, 90, 120, 150)):
        out = np.array((np.cos(longitude), np.sin(longitude), 0))
        circles.append(np.outer(np.cos(turn), out) + np.outer(np.sin(turn), up))
    for circle in circles:
        flat, near = view(radius * circle)
        flat[near < 0] = np.nan
        axes.plot(*flat.T, color="#d4d4d4", lw=0.5, zorder=1)
    axes.update_datalim(((-radius, -radius), (radius, radius)))
    triad(axes, view, labels, length, radius)


def trace(axes: Axes, view: View, points: Array, colour: str) -> None:
    """Draw a curve on a sphere: what the sphere hides is thin and pale."""
    flat, near = view(points)
    for hidden in (True, False):
        shown = flat.copy()
        shown[(near < 0) != hidden] = np.nan
        axes.plot(
            *shown.T,
            color=colour,
            lw=0.405 if hidden else 0.9,
            alpha=0.35 if hidden else 1.0,
            zorder=0.5 if hidden else 2.0,
        )
    axes.autoscale_view()
