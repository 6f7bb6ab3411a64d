"""The bifurcation diagram of the whole top, cut at energies: the planes of (g, √k)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.critical import TOLERANCE, residuals
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.pictures.bifurcation import ell_at, regime_at
from kowalevski_cas.motion.pictures.regions import GREYS, filled, mesh
from kowalevski_cas.paper.closed_form import CriticalSets
from kowalevski_cas.pictures import INK, mark, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Curve = tuple[Array, Array]

ABOUT = CriticalSets

CAPTION = (
    "The bifurcation diagram of the whole top, in the planes of $(g,\\sqrt{k})$ at six energies: "
    "the values at which the three integrals are dependent, on $M^4$, $N^4$, $O^4$, and at "
    "rotations about the third axis (dots, hollow where they are on none of the three). Motions "
    "fill the shaded regions."
)

SETS = ("$M^4$", "$N^4$", "$O^4$")

POINTS = 12_000
"""Values of m on N⁴."""

STATES = 60_000


def draw(motion: Motion) -> Figure:
    """The sections for the fields of a motion."""
    fields = Fields(motion.parameters.a, motion.parameters.b)
    a, b = float(fields.a), float(fields.b)
    figure = new_figure(height=4.6)
    for axes, h in zip(
        figure.subplots(2, 3).flat,
        (-0.5 * (a + b), 0.0, (a + b) / 2, 0.95 * (a + b), 1.2 * (a + b), 2 * (a + b)),
        strict=True,
    ):
        g, root = values(fields, h)
        width, height = np.ptp(g), root.max()
        axes.set(xlim=(g.min() - 0.06 * width, g.max() + 0.06 * width))
        axes.set(ylim=(-0.04 * height, 1.08 * height), title=f"$h={h:.2f}$")
        axes.grid(False)
        curves = section(fields, h)
        here = filled(axes, [curve for some in curves for curve in some], (g, root))
        axes.contourf(*mesh(axes), here, levels=(0.5, 1.5), colors=[GREYS[1]], zorder=0)
        for index, (name, some) in enumerate(zip(SETS, curves, strict=True)):
            one = mark((2, 0, 1)[index])
            for number, curve in enumerate(some):
                axes.plot(
                    *curve, color=one.colour, ls=one.dashes, lw=1.2,
                    label=name if number == 0 else None,
                )  # fmt: skip
        for x, y, alone in rotations(fields, h):
            axes.plot(x, y, "o", ms=4, color=INK, mfc="white" if alone else INK, zorder=5)
    for axes in figure.axes[3:]:
        axes.set_xlabel("$g$")
    for axes in figure.axes[::3]:
        axes.set_ylabel(r"$\sqrt{k}$", rotation=0, labelpad=10)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


def section(fields: Fields, h: float) -> tuple[list[Curve], list[Curve], list[Curve]]:
    """The curves (G, √K) at an energy that belong to M⁴, N⁴ and O⁴."""
    known = Parameters.of(fields.a, fields.b, 1, 0)
    reach = 2 * (abs(h) + 2 * float(fields.a)) / float(known.r_square)  # beyond h = r²m − 2a
    m = np.linspace(-1, 1, POINTS) ** 3 * reach
    real = regime_at(known, m, ell_at(known, m, np.full_like(m, h))) >= 0
    k, g = fields.on_N4(np.full_like(m, h), np.where(real, m, np.nan))
    return [first(fields, h)], [(g, np.sqrt(k))], [third(fields, h, s) for s in fields.parts()]


def third(fields: Fields, h: float, s: Array) -> Curve:
    """The curve of O⁴ at an energy, for these s; it goes as far as k = 0."""
    tau = fields.tau(s, np.full_like(s, h))
    real = fields.regimes(s, tau)[0] >= 0
    _, k, g = fields.on_O4(s, tau)
    found_g, found_k = np.where(real, g, np.nan), np.where(real, k, np.nan)
    for inside, outside in ((np.s_[:-1], np.s_[1:]), (np.s_[1:], np.s_[:-1])):
        last = real[inside] & (k[outside] < 0)
        share = (k[inside] / (k[inside] - k[outside]))[last]
        found_k[outside][last] = 0.0
        found_g[outside][last] = g[inside][last] + share * (g[outside] - g[inside])[last]
    return found_g, np.sqrt(found_k)


def first(fields: Fields, h: float) -> Curve:
    """The segment of M⁴ at an energy: up to the largest |J₃| of its common points with O⁴."""
    reached: list[float] = []
    for j, energy in fields.M4_and_O4():
        above = energy - h
        here, there = above[:-1], above[1:]
        (last,) = np.nonzero(np.isfinite(here) & np.isfinite(there) & (here * there <= 0))
        share = here[last] / (here[last] - there[last])
        reached += (j[last] + share * (j[last + 1] - j[last])).tolist()
    j = np.linspace(0, max(reached, default=np.nan), 50)
    k, g = fields.on_M4(np.full_like(j, h), j)
    return g, np.sqrt(k)


def values(fields: Fields, h: float) -> Curve:
    """The values of G and √K at states of an energy by chance."""
    states = fields.states(STATES)
    rest = formulas.integrals()(*states.T)[0]
    states, rest = states[rest < h], rest[rest < h]
    directions = np.random.default_rng(3).normal(size=(len(states), 3))
    directions *= np.sqrt((h - rest) / np.sum(directions**2, axis=1))[:, None]
    states[:, :3] = directions * (1, 1, np.sqrt(2))
    _, k, _, _, _, g, *_ = formulas.integrals()(*states.T)
    return g, np.sqrt(k)


def rotations(fields: Fields, h: float) -> list[tuple[float, float, bool]]:
    """The values (G, √K) of rotations about the third axis, and whether these are not on O⁴."""
    found = []
    for sign in (1.0, -1.0):
        state = np.array([0, 0, 0, float(fields.a), 0, 0, 0, sign * float(fields.b), 0])
        rest = formulas.integrals()(*state)[0]
        if rest <= h:
            state[2] = np.sqrt(2 * (h - rest))
            _, k, _, _, _, g, *_ = formulas.integrals()(*state)
            found.append((g, np.sqrt(k), bool(residuals(state[None])["O4"][0] > TOLERANCE)))
    return found
