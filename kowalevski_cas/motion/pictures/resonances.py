"""Maps of the rotation number over the diagrams of N⁴ and O⁴, with low resonances."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.figure import Figure

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.frequencies import shift_basis, turn_rates
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.parameters import Inadmissible, MethodError, precision
from kowalevski_cas.pictures import INK, new_figure

CAPTION = (
    "Rotation numbers: of the two frequencies of a torus the smaller one over the larger one, on "
    "$N^4$ over the plane of $(m,\\ell)$ and on $O^4$ over that of $(s,\\tau_3)$, in the fields "
    "of the motion. On the lines they are in the ratio of small whole numbers, which is written "
    "there. There is no motion where the ground is bare."
)

POINTS = 64
"""Points of a map along each axis."""

BITS = 64
"""The precision of the rates in a map."""

RATIOS = [Fraction(1, 4), Fraction(1, 3), Fraction(1, 2), Fraction(2, 3), Fraction(3, 4)]
"""The resonances that are drawn."""


def draw(motion: Motion | MotionO4) -> Figure:
    """Both maps for the fields of a motion."""
    a, b = motion.parameters.a, motion.parameters.b
    size = float(a)
    high = float((a + b) ** 2)
    figure = new_figure(height=3.6)
    left, right = figure.subplots(1, 2)
    left.set(xlim=(-1.5 / size, 1.5 / size), ylim=(0, 3.5), xlabel="$m$")
    right.set(xlim=(-1.5 * size, 2.2 * size), ylim=(-0.8 * high, 1.7 * high), xlabel="$s$")
    left.set_ylabel(r"$\ell$", rotation=0)
    right.set_ylabel(r"$\tau_3$", rotation=0)
    _map(left, lambda m, ell: Motion.of(a, b, m, ell=ell))
    last = _map(right, lambda s, tau: MotionO4.of(a, b, s, tau))
    figure.colorbar(last, ax=(left, right), label="rotation number", shrink=0.8)
    return figure


def _map(axes: Axes, make: Callable[[float, float], Motion | MotionO4]) -> QuadMesh:
    """The map of one diagram, shaded, with its resonances."""
    axes.grid(False)
    x, y = (
        low + (np.arange(POINTS) + 0.5) / POINTS * (high - low)
        for low, high in (axes.get_xlim(), axes.get_ylim())
    )
    numbers, kinds = rotation_numbers(make, x, y)
    mesh = axes.pcolormesh(x, y, numbers, cmap="viridis", vmin=0, vmax=1, shading="nearest")
    for kind in range(int(np.max(kinds, initial=-1)) + 1):
        here = np.where(kinds == kind, numbers, np.nan)
        if min(np.sum(np.isfinite(here).any(axis=axis)) for axis in (0, 1)) < 2:
            continue
        levels = [float(q) for q in RATIOS if np.nanmin(here) < q < np.nanmax(here)]
        if levels:
            lines = axes.contour(x, y, here, levels, colors=INK, linewidths=0.7)
            names = {float(q): f"{q.numerator}:{q.denominator}" for q in RATIOS}
            axes.clabel(lines, fmt=names, fontsize=6)
    return mesh


def rotation_numbers(
    make: Callable[[float, float], Motion | MotionO4], x: Array, y: Array
) -> tuple[Array, Array]:
    """The smaller frequency over the larger one, and the number of the regime, on a grid.

    Not a number, and −1, where there is no torus.
    """
    numbers, kinds = np.full((len(y), len(x)), np.nan), np.full((len(y), len(x)), -1)
    inverses: dict[str, Array] = {}
    for row, column in np.ndindex(numbers.shape):
        try:
            motion = make(float(x[column]), float(y[row]))
            regime = str(motion.regime)
            if regime not in inverses:
                inverses[regime] = np.array(np.linalg.inv(shift_basis(motion)), dtype=float)
            with precision(BITS):
                rates = np.abs(inverses[regime] @ turn_rates(motion))
        except (Inadmissible, MethodError):
            continue
        numbers[row, column] = np.min(rates) / np.max(rates)
        kinds[row, column] = list(inverses).index(regime)
    return numbers, kinds
