"""Regions of a diagram: shaded by the number of tori, and found between curves."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke
from scipy.ndimage import binary_closing, binary_dilation, distance_transform_edt, label

from kowalevski_cas.motion.arrays import Array, Integers, Mask
from kowalevski_cas.pictures import FAINT

GREYS = {1: "#efefef", 2: "#d6d6d6", 4: "#b0b0b0"}
"""The shade of a region, by its number of tori."""

GRID = 501
"""Points of the grid on which regions are found, along each axis."""


def mesh(axes: Axes) -> tuple[Array, Array]:
    """The points of the grid in the frame of a diagram, none of them at the middle."""
    x, y = np.meshgrid(np.linspace(*axes.get_xlim(), GRID + 1), np.linspace(*axes.get_ylim(), GRID))
    return x, y


def shade(
    axes: Axes,
    kinds: Integers,
    tori: Sequence[int],
    taken: tuple[float, float] | None = None,
    least: float = 0.008,
) -> None:
    """Shade the regions of a grid, and write the number of tori into each, away from a place.

    A region gets no number that is nowhere so deep, beside the frame.

    A region is of the kind that the grid tells, −1 where there is none.
    """
    x, y = mesh(axes)
    near = np.zeros(x.shape, dtype=bool)
    if taken is not None:
        across, up = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
        near = np.hypot((x - taken[0]) / across, (y - taken[1]) / up) < 0.03
    for kind, count in enumerate(tori):
        here = kinds == kind
        if not here.any():
            continue
        axes.contourf(x, y, here, levels=(0.5, 1.5), colors=[GREYS[count]], zorder=0)
        pieces, number = label(here)
        for piece in range(1, number + 1):
            free = np.pad((pieces == piece) & ~near, 1)
            depth = distance_transform_edt(free)[1:-1, 1:-1]
            place = np.unravel_index(np.argmax(depth), depth.shape)
            if depth[place] < least * GRID:
                continue
            small = depth[place] < 0.03 * GRID
            axes.text(
                x[place], y[place], str(count),
                ha="center", va="center", size=6 if small else 9, zorder=4,
                path_effects=[withStroke(linewidth=2, foreground=GREYS[count])],
            )  # fmt: skip


def hatch(axes: Axes, here: Mask) -> None:
    """Hatch a part of a grid."""
    x, y = mesh(axes)
    if here.any():
        with rc_context({"hatch.linewidth": 0.4}):
            lines = axes.contourf(
                x, y, here, (0.5, 1.5), colors="none", hatches=["///"], zorder=0.5
            )
        lines.set_edgecolor(FAINT)
        lines.set_linewidth(0.0)


def fill_regions(
    axes: Axes, curves: Iterable[tuple[Array, Array]], points: tuple[Array, Array]
) -> Mask:
    """The pieces of the grid between curves in which there is one of the points, at least."""
    walls, here = np.zeros((GRID, GRID + 1), dtype=bool), np.zeros((GRID, GRID + 1), dtype=bool)
    for x, y in curves:
        column, row = _places(axes, x, y)
        steps = np.maximum(abs(np.diff(column)), abs(np.diff(row)))
        for k in np.flatnonzero(np.isfinite(steps) & (steps < GRID)):
            count = int(4 * steps[k]) + 2
            _mark(walls, np.linspace(column[k], column[k + 1], count),
                  np.linspace(row[k], row[k + 1], count))  # fmt: skip
    _mark(here, *_places(axes, *points))
    pieces, _ = label(~walls)
    sure = here & ~binary_dilation(walls, iterations=2)  # a wall may cut off a corner of a place
    found = np.isin(pieces, np.unique(pieces[sure])) & ~walls
    closed: Mask = binary_closing(np.pad(found, 2, mode="edge"), iterations=2)[2:-2, 2:-2]
    return closed


def _places(axes: Axes, x: Array, y: Array) -> tuple[Array, Array]:
    """The columns and rows of points in the grid, not rounded."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    return (x - left) / (right - left) * GRID, (y - low) / (high - low) * (GRID - 1)


def _mark(grid: Mask, column: Array, row: Array) -> None:
    inside = (column >= 0) & (column <= GRID) & (row >= 0) & (row <= GRID - 1)
    grid[np.rint(row[inside]).astype(int), np.rint(column[inside]).astype(int)] = True
