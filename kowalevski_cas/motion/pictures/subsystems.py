"""The bifurcation diagrams of the other two critical subsystems, O⁴ and M⁴."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.pictures.regions import hatch, mesh, shade
from kowalevski_cas.paper.closed_form import CriticalSets
from kowalevski_cas.pictures import mark, new_figure

ABOUT = CriticalSets

CAPTION = (
    "Bifurcation diagrams of $O^4$ in the planes of $(s,\\tau_3)$ and of $(s,h)$, and of $M^4$ in "
    "the plane of $(J_3,h)$, where the other sign of $J_3$ gives the same. Numbers count the tori "
    "of a region, and there is no motion where the ground is bare. The tori of $O^4$ are "
    "hyperbolic where it is hatched, and elliptic elsewhere. On the curves of $M^4$ the motions "
    "are on $O^4$ as well."
)


def draw(motion: Motion | MotionO4) -> Figure:
    """The three diagrams for the fields of a motion."""
    fields = Fields(motion.parameters.a, motion.parameters.b)
    a, b = float(fields.a), float(fields.b)
    figure = new_figure(height=3.2)
    by_tau, by_h, on_M4 = figure.subplots(1, 3)
    high = max(fields.where_sigma_vanishes())
    by_tau.set(xlim=(-1.5 * a, 2.2 * a), ylim=(-0.8 * high, 1.7 * high), xlabel="$s$")
    by_h.set(xlim=(-1.5 * a, 2.2 * a), ylim=(-1.3 * (a + b), 1.9 * (a + b)), xlabel="$s$")
    on_M4.set(xlim=(0, 2.3 * (a + b)), ylim=by_h.get_ylim(), xlabel="$J_3$")
    for axes, unit in ((by_tau, r"$\tau_3$"), (by_h, "$h$"), (on_M4, "$h$")):
        axes.set_ylabel(unit, rotation=0)
        axes.grid(False)
    for axes in (by_tau, by_h):
        s, y = mesh(axes)
        tau = y if axes is by_tau else fields.tau(s, y)
        kinds, regimes = fields.regimes(s, tau)
        hatch(axes, (kinds >= 0) & fields.hyperbolic_on_O4(s, tau))
        shade(axes, kinds, [regime.tori for regime in regimes], least=0.018)
        _curves(axes, fields, energies=axes is by_h)
    _first(on_M4, fields)
    figure.legend(*by_tau.get_legend_handles_labels(), loc="outside lower center", ncols=5)
    return figure


def _curves(axes: Axes, fields: Fields, energies: bool) -> None:
    """Draw where regimes of O⁴ meet, and where motions end."""
    for words, style, s, tau in separating_curves(fields, axes.get_ylim()):
        real = np.where(fields.is_real(s, tau), tau, np.nan)
        y = fields.on_O4(s, real)[0] if energies else real
        axes.plot(s, y, **mark(style).line, lw=1.2, zorder=2, label=words)


def separating_curves(
    fields: Fields, reach: tuple[float, float]
) -> Iterator[tuple[str | None, int, Array, Array]]:
    """The curves (s, τ₃) on which regimes of O⁴ meet, with words and a style for each."""
    parts = fields.parts(4)
    tall = np.linspace(-1, 1, 4 * len(parts[0])) ** 3 * 20 * max(map(abs, reach))
    for style, (words, length) in enumerate((("$s=\\pm a$", fields.a), ("$s=\\pm b$", fields.b))):
        for sign in (1, -1):
            yield words if sign > 0 else None, style, np.full_like(tall, sign * length), tall
    for index, s in enumerate(parts):
        for number, root in enumerate(fields.where_sigma_vanishes()):
            yield None if index or number else r"$\sigma=0$", 2, s, np.full_like(s, root)
        for number, tau in enumerate(fields.where_k_vanishes(s)):
            yield None if index or number else "$k=0$", 3, s, tau
        yield None if index else r"$\tau_3=0$", 6, s, np.zeros_like(s)


def _first(axes: Axes, fields: Fields) -> None:
    """Draw the diagram of M⁴."""
    j, h = mesh(axes)
    tori = fields.tori_on_M4(h, j)
    shade(axes, np.where(tori > 0, np.log2(np.maximum(tori, 1)), -1).astype(int), (1, 2, 4))
    for j, h in fields.M4_and_O4():
        axes.plot(j, h, **mark(3).line, lw=1.2)
