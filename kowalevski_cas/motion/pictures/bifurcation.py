r"""The bifurcation diagrams of N⁴, in the planes of (m, h) and of (m, ℓ).

The regions are those of the regimes, and the separating curves are found where roots coincide.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.pictures.regions import GRID, hatch, mesh, shade
from kowalevski_cas.motion.plane import ell_at, line, regime_at
from kowalevski_cas.motion.regimes import FIELD_1, FIELD_2, PHI, Regime, all_regimes
from kowalevski_cas.motion.transverse import degenerate
from kowalevski_cas.pictures import FAINT, INK, mark, new_figure

Map = Callable[[Array, Array], Array]

CAPTION = (
    "Bifurcation diagrams of $N^4$ in the planes of $(m,h)$ and of $(m,\\ell)$; $\\ell$ and "
    "$-\\ell$ are the same motions. Numbers count the tori of a region; there is no motion where "
    "the ground is bare. A separating curve is thick where it parts two regimes, and faint where "
    "it does not. Tori with $m>0$ are elliptic; those with $m<0$, hatched, are hyperbolic, except "
    "where $\\lambda=0$: on the dotted curve, and on $\\ell=0$. "
    "The cross is the motion of the other pictures."
)

STEPS = 60
"""Values of m for which λ = 0 is solved."""


def draw(motion: Motion) -> Figure:
    """Both diagrams for the fields of a motion, which is marked in them."""
    parameters = motion.parameters
    square, m, ell, h = (
        float(value)
        for value in (parameters.p_square, parameters.m, abs(parameters.ell), parameters.h)
    )
    a, b = float(parameters.a), float(parameters.b)

    def energy(m: Array, ell: Array) -> Array:
        return (ell**2 - 1 - 2 * square * m**2) / (2 * m)

    def second(_: Array, ell: Array) -> Array:
        return ell

    reach = 1.25 * max(abs(m), 1 / (2 * b) if b > a / 4 else 2 / a)
    top = 2 * a + (a * a - b * b) * reach
    curves = degenerate_curves(parameters, reach)
    of_energy = partial(ell_at, parameters)
    figure = new_figure(height=3.9)
    left, right = figure.subplots(1, 2)
    for axes, unit, bottom, height, ell_of, ordinate, here in (
        (left, "$h$", -0.9 * max(top, abs(h)), 1.1 * max(top, abs(h)), of_energy, energy, h),
        (right, r"$\ell$", -0.03 * a, 1.2 * max(2 * a * reach, ell), second, second, ell),
    ):
        axes.set(xlim=(-reach, reach), ylim=(bottom, height), xlabel="$m$")
        axes.set_ylabel(unit, rotation=0)
        axes.grid(False)
        mesh_m, mesh_y = mesh(axes)
        kinds = regime_at(parameters, mesh_m, ell_of(mesh_m, mesh_y))
        hatch(axes, (kinds >= 0) & (mesh_m < 0))
        shade(axes, kinds, [regime.tori for regime in all_regimes()], (m, here))
        _curves(axes, parameters, ordinate)
        for place, ell_there in curves:
            y = ordinate(place, ell_there)
            axes.plot(place, y, **mark(3).line, lw=1.3, zorder=2, label=r"$\lambda=0$")
        axes.plot(m, here, "x", color=INK, ms=6, mew=1.4, zorder=5)
    handles, labels = left.get_legend_handles_labels()
    shown = dict(zip(labels, handles, strict=True))
    figure.legend(shown.values(), shown.keys(), loc="outside lower center", ncols=5)
    return figure


def _curves(axes: Axes, parameters: Parameters, ordinate: Map) -> None:
    """Draw the separating curves, thick where the regimes on their two sides differ."""
    m = np.linspace(*axes.get_xlim(), 4 * GRID)
    m = m[m != 0]
    low, high = axes.get_ylim()
    gap = 1e-6 * (high - low)
    drawn: set[str] = set()
    for words, style, ell in separating_curves(parameters, m):
        sides = [regime_at(parameters, m, np.abs(ell + shift)) for shift in (gap, -gap)]
        parts = sides[0] != sides[1] if ell.any() else sides[0] >= 0
        y = ordinate(m, np.abs(ell))
        y[np.abs(y) > 3 * (high - low)] = np.nan
        thick = np.where(parts, y, np.nan)
        for side in (m < 0, m > 0):  # no line across m = 0
            axes.plot(m[side], y[side], color=FAINT, lw=0.5, zorder=1)
            label = words if words not in drawn else None
            axes.plot(m[side], thick[side], **mark(style).line, lw=1.3, zorder=2, label=label)
            drawn.add(words)
    axes.axvline(0, color=INK, lw=0.9, zorder=2, label="$m=0$")


def degenerate_curves(parameters: Parameters, reach: float) -> list[tuple[Array, Array]]:
    """The curves (m, ℓ) on which λ = 0 inside a regime, for −reach ≤ m < 0: one in each of two."""
    found: dict[Regime, list[tuple[float, float]]] = {}
    for m in np.linspace(-reach, 0.0, STEPS, endpoint=False):
        for regime, ell in degenerate(parameters.a, parameters.b, m):
            found.setdefault(regime, []).append((m, ell))
    curves = [np.array(points).T for points in found.values()]
    return [(m, ell) for m, ell in curves]


def separating_curves(parameters: Parameters, m: Array) -> Iterator[tuple[str, int, Array]]:
    """The separating curves as ℓ(m), with words and a style for each: which roots coincide."""
    for style, (words, ends) in enumerate(
        ((r"$\ell=\pm 2am\pm 1$", FIELD_1), (r"$\ell=\pm 2bm\pm 1$", FIELD_2))
    ):
        for end in ends:
            for root in PHI:
                slope, constant = line(parameters, m, root)
                yield words, style, (line(parameters, m, end)[1] - constant) / slope
    yield r"$\ell=0$", 2, np.zeros_like(m)
