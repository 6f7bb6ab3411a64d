"""The bifurcation diagram of the whole top, cut at energies: the planes of (g, √k)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array, Integers
from kowalevski_cas.motion.critical import TOLERANCE, residuals
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.pictures.bifurcation import ell_at, regime_at
from kowalevski_cas.motion.pictures.regions import GREYS, fill_regions, mesh
from kowalevski_cas.motion.regimes import all_regimes
from kowalevski_cas.paper.closed_form import CriticalSets
from kowalevski_cas.pictures import INK, mark, new_figure


class Curve(NamedTuple):
    """Values of G and √K, and on how many tori of the critical set they are taken."""

    g: Array
    root: Array
    tori: Integers


ABOUT = CriticalSets

CAPTION = (
    "The bifurcation diagram of the whole top, in the planes of $(g,\\sqrt{k})$ at six energies: "
    "the values at which the three integrals are dependent, on $M^4$, $N^4$, $O^4$, and at "
    "rotations about the third axis (dots, hollow where they are on none of the three). Numbers "
    "count the tori of $M^4$, $N^4$ and $O^4$ with these values. Motions fill the shaded regions."
)

SETS = ("$M^4$", "$N^4$", "$O^4$")

POINTS = 6000
"""Values of J₃ on M⁴, of which the largest is not reached."""

SHARES = np.linspace(0, 1, POINTS)[1:] ** 3
"""Values of |m| on N⁴, as shares of the largest."""

STATES = 60_000


def draw(motion: Motion | MotionO4) -> Figure:
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
        curves, dots = section(fields, h), rotations(fields, h)
        here = fill_regions(axes, [curve[:2] for some in curves for curve in some], (g, root))
        axes.contourf(*mesh(axes), here, levels=(0.5, 1.5), colors=[GREYS[1]], zorder=0)
        for index, (name, some) in enumerate(zip(SETS, curves, strict=True)):
            for number, curve in enumerate(some):
                numbers(axes, curve, [(x, y) for x, y, _ in dots])
                label = name if number == 0 else None
                axes.plot(*curve[:2], **mark((2, 0, 1)[index]).line, lw=1.2, label=label)
        for x, y, alone in dots:
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
    second = []
    for m in (reach * SHARES, -reach * SHARES):
        kinds = regime_at(known, m, ell_at(known, m, np.full_like(m, h)))
        k, g = fields.on_N4(np.full_like(m, h), np.where(kinds >= 0, m, np.nan))
        tori = np.array([*(regime.tori for regime in all_regimes()), 0])[kinds]
        second.append(Curve(g, np.sqrt(k), tori))
    return [first(fields, h)], second, [third(fields, h, s) for s in fields.parts()]


def third(fields: Fields, h: float, s: Array) -> Curve:
    """The curve of O⁴ at an energy, for these s; it goes as far as k = 0."""
    tau = fields.tau(s, np.full_like(s, h))
    kinds, regimes = fields.regimes(s, tau)
    real, tori = kinds >= 0, np.array([*(regime.tori for regime in regimes), 0])[kinds]
    _, k, g = fields.on_O4(s, tau)
    found_g, found_k = np.where(real, g, np.nan), np.where(real, k, np.nan)
    for inside, outside in ((np.s_[:-1], np.s_[1:]), (np.s_[1:], np.s_[:-1])):
        last = real[inside] & (k[outside] < 0)
        share = (k[inside] / (k[inside] - k[outside]))[last]
        found_k[outside][last] = 0.0
        found_g[outside][last] = g[inside][last] + share * (g[outside] - g[inside])[last]
    return Curve(found_g, np.sqrt(found_k), tori)


def first(fields: Fields, h: float) -> Curve:
    """The segment of M⁴ at an energy, with the tori of both signs of J₃."""
    size = float(fields.a + fields.b)
    # |J₃| is so large at most, for |w1|² ≤ a + b on M⁴.
    reach = size * np.sqrt(2 * (h + size)) + 2 * size**1.5
    j = np.linspace(0, reach, POINTS)[1:]
    tori = fields.tori_on_M4(np.full_like(j, h), j)
    k, g = fields.on_M4(np.full_like(j, h), np.where(tori > 0, j, np.nan))
    return Curve(g, np.sqrt(k), 2 * tori)


def numbers(axes: Axes, curve: Curve, taken: Sequence[tuple[float, float]]) -> None:
    """Write the number of tori onto each part of a curve that is long enough, off what is taken."""
    across, up = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
    for part in np.split(np.arange(len(curve.g)), np.flatnonzero(np.diff(curve.tori)) + 1):
        x, y = curve.g[part], curve.root[part]
        along = np.append(0.0, np.nancumsum(np.hypot(np.diff(x) / across, np.diff(y) / up)))
        if not curve.tori[part[0]] or along[-1] < 0.12:
            continue
        for share in (0.5, 0.35, 0.65):
            place = np.searchsorted(along, share * along[-1])
            at = x[place], y[place]
            if all(np.hypot((at[0] - u) / across, (at[1] - v) / up) > 0.06 for u, v in taken):
                axes.text(
                    *at, str(curve.tori[part[0]]), size=6, ha="center", va="center",
                    zorder=4, path_effects=[withStroke(linewidth=2.5, foreground="white")],
                )  # fmt: skip
                break


def values(fields: Fields, h: float) -> tuple[Array, Array]:
    """The values of G and √K at states of an energy by chance."""
    states = fields.states(STATES)
    rest = formulas.values_of_offer("integrals")(*states.T)[0]
    states, rest = states[rest < h], rest[rest < h]
    directions = np.random.default_rng(3).normal(size=(len(states), 3))
    directions *= np.sqrt((h - rest) / np.sum(directions**2, axis=1))[:, None]
    states[:, :3] = directions * (1, 1, np.sqrt(2))
    _, k, _, _, _, g, *_ = formulas.values_of_offer("integrals")(*states.T)
    return g, np.sqrt(k)


def rotations(fields: Fields, h: float) -> list[tuple[float, float, bool]]:
    """The values (G, √K) of rotations about the third axis, and whether these are not on O⁴."""
    found = []
    for sign in (1.0, -1.0):
        state = np.array([0, 0, 0, float(fields.a), 0, 0, 0, sign * float(fields.b), 0])
        rest = formulas.values_of_offer("integrals")(*state)[0]
        if rest <= h:
            state[2] = np.sqrt(2 * (h - rest))
            _, k, _, _, _, g, *_ = formulas.values_of_offer("integrals")(*state)
            found.append((g, np.sqrt(k), bool(residuals(state[None])["O4"][0] > TOLERANCE)))
    return found
