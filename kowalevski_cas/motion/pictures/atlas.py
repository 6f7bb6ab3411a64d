"""All regimes of N⁴: the hodograph of the angular velocity in the body, one for each."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from scipy.ndimage import distance_transform_edt

from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.pictures.orbit import orbit
from kowalevski_cas.motion.pictures.space import View, blank, curve, triad
from kowalevski_cas.motion.plane import regime_at
from kowalevski_cas.motion.regimes import Regime, all_regimes
from kowalevski_cas.pictures import PlotMark, mark, new_figure

CAPTION = (
    "The hodograph of the angular velocity in the body, for one motion in each regime in these "
    "fields. A regime is an order of the roots; under it stand $m$, $\\ell$ and the number of "
    "tori. Beside each stand the axes of $\\omega_1$, $\\omega_2$, $\\omega_3$, of the length that "
    "is told; the farther a curve is, the paler it is."
)

KINDS = {1: "elliptic torus, $m>0$", -1: "hyperbolic torus, $m<0$"}

TURNS, POINTS, GRID, COLUMNS = 10, 2000, 241, 3


def draw(motion: Motion) -> Figure:
    """A hodograph for every regime, in the fields of a motion."""
    found = examples(motion.parameters)
    rows = -(-len(found) // COLUMNS)
    figure = new_figure(height=2.2 * rows)
    tiles = list(figure.subplots(rows, COLUMNS).flat)
    view = View()
    for axes in tiles:
        blank(axes)
    for axes, (regime, example) in zip(tiles, found, strict=False):
        omega = orbit(example, TURNS, POINTS)[:, :3]
        place, _ = view(omega)
        left, bottom = np.min(place, axis=0)
        length = float(f"{0.2 * np.max(np.ptp(place, axis=0)):.1g}")
        triad(
            axes,
            view,
            (r"$\omega_1$", r"$\omega_2$", r"$\omega_3$"),
            length,
            at=(left - 0.6 * length, bottom),
        )
        curve(axes, view, omega, _mark(regime.sign).colour, 0.6)
        order = "<".join(regime.order)
        m, ell = float(example.parameters.m), float(example.parameters.ell)
        tori = "1 torus" if regime.tori == 1 else f"{regime.tori} tori"
        words = f"${order}$\n$m={m:.2g}$, $\\ell={ell:.2g}$: {tori}; axes {length:g}"
        axes.set_title(words, size=7.5, loc="center")
    keys = [Line2D([], [], color=_mark(sign).colour, label=words) for sign, words in KINDS.items()]
    figure.legend(handles=keys, loc="outside lower center", ncols=len(keys))
    return figure


def _mark(sign: int) -> PlotMark:
    """How motions with this sign of m are drawn."""
    return mark(0 if sign > 0 else 1)


def examples(parameters: Parameters) -> list[tuple[Regime, Motion]]:
    """A motion from the middle of each regime's region, but for the mirrored ones.

    Coordinates are rounded to two digits.
    """
    a, b = parameters.a, parameters.b
    reach = 1.5 / float(2 * b) if b else 2 / float(a)
    m, ell = np.meshgrid(
        np.linspace(-reach, reach, 2 * GRID), np.linspace(0, 2 * float(a) * reach, GRID)
    )
    regime = regime_at(parameters, m, ell)
    found = []
    for number, kind in enumerate(all_regimes()):
        here = np.pad(regime == number, 1)
        if here.any():
            depth = distance_transform_edt(here)[1:-1, 1:-1]
            place = np.unravel_index(np.argmax(depth), depth.shape)
            one = Parameters.of(a, b, f"{m[place]:.3g}", f"{ell[place]:.3g}")
            found.append((kind, Motion(one)))
    return found
