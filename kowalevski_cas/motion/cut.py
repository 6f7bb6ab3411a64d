"""The bifurcation diagram of the whole top at an energy: curves in the plane of (g, √k)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array, Integers, Mask
from kowalevski_cas.motion.critical import TOLERANCE, residuals
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.plane import ell_at, regime_at
from kowalevski_cas.motion.regimes import all_regimes

POINTS = 6000
"""Values of J₃ on M⁴, of which the largest is not reached."""

SHARES = np.linspace(0, 1, POINTS)[1:] ** 3
"""Values of |m| on N⁴, as shares of the largest."""

STATES = 60_000
"""How many states tell where motions are."""


class Curve(NamedTuple):
    """Values of G and √K, and on how many tori of the critical set they are taken.

    ``hyperbolic`` says of which type these are; it is not known on M⁴.
    """

    g: Array
    root: Array
    tori: Integers
    hyperbolic: Mask


def section(fields: Fields, h: float) -> tuple[list[Curve], list[Curve], list[Curve]]:
    """The curves (G, √K) at an energy that belong to M⁴, N⁴ and O⁴."""
    known = Parameters.of(fields.a, fields.b, 1, 0)
    reach = 2 * (abs(h) + 2 * float(fields.a)) / float(known.r_square)  # beyond h = r²m − 2a
    second = []
    for m in (reach * SHARES, -reach * SHARES):
        kinds = regime_at(known, m, ell_at(known, m, np.full_like(m, h)))
        k, g = fields.on_N4(np.full_like(m, h), np.where(kinds >= 0, m, np.nan))
        tori = np.array([*(regime.tori for regime in all_regimes()), 0])[kinds]
        second.append(Curve(g, np.sqrt(k), tori, m < 0))
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
    return Curve(found_g, np.sqrt(found_k), tori, fields.hyperbolic_on_O4(s, tau))


def first(fields: Fields, h: float) -> Curve:
    """The segment of M⁴ at an energy, with the tori of both signs of J₃."""
    size = float(fields.a + fields.b)
    # |J₃| is so large at most, for |w1|² ≤ a + b on M⁴.
    reach = size * np.sqrt(2 * (h + size)) + 2 * size**1.5
    j = np.linspace(0, reach, POINTS)[1:]
    tori = fields.tori_on_M4(np.full_like(j, h), j)
    k, g = fields.on_M4(np.full_like(j, h), np.where(tori > 0, j, np.nan))
    return Curve(g, np.sqrt(k), 2 * tori, np.zeros(j.shape, dtype=bool))


def values(fields: Fields, h: float) -> tuple[Array, Array]:
    """The values of G and √K at states of an energy by chance."""
    states = fields.at_energy(h, STATES)
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
