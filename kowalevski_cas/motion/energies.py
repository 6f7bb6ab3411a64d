"""The energies at which the diagram of the whole top changes, for any two fields.

The diagram at an energy is made of the curves of M⁴, N⁴ and O⁴. What happens on them changes where
the energy is extreme along a separating curve of O⁴, or where two of these meet: there M⁴
and N⁴ change too. Of these energies those separate on whose sides the curves differ, in their
numbers of tori or in their types, or the chambers between them.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise

import numpy as np

from kowalevski_cas.motion.arrays import Array, Integers
from kowalevski_cas.motion.chambers import Strips
from kowalevski_cas.motion.cut import Curve, section
from kowalevski_cas.motion.diagram import Fields

NARROW = 4
"""Parts of a curve of fewer points are passed over."""

SAME, LARGEST = 1e-5, 1e3
"""Energies nearer to each other, in units of a + b, are one; beyond so many none separates."""

ROUNDING = 1e-12
"""Values along a curve that differ by less than this share are the same."""


def separating_energies(fields: Fields) -> list[float]:
    """The energies at which the diagram changes, from the least one of all motions upwards."""
    unit, a = Fields(Fraction(1), fields.b / fields.a), float(fields.a)
    size = float(unit.a + unit.b)
    found = [-size]
    with np.errstate(invalid="ignore", divide="ignore"):
        for energy in sorted(candidates(unit)):
            if found[-1] + SAME * size < energy < LARGEST * size:
                found.append(energy)
    between = [(low + high) / 2 for low, high in pairwise([*found, found[-1] + size])]
    kinds = pairwise(
        [(kind(unit, energy), Strips(unit, Fraction(energy)).type()) for energy in between]
    )
    changes = [e for e, (u, v) in zip(found[1:], kinds, strict=True) if u != v]
    return [a * energy for energy in (-size, *changes)]


def representatives(fields: Fields) -> list[float]:
    """An energy between each two that separate, and one above them all."""
    found = separating_energies(fields)
    return [(low + high) / 2 for low, high in pairwise([*found, 1.5 * found[-1]])]


def candidates(fields: Fields) -> Iterator[float]:
    """The energies that are extreme on a curve of O⁴'s diagram, or belong to a point of two."""
    for s in fields.parts(4):
        inner = s[1:-1]
        curves = [np.full_like(inner, tau) for tau in (0.0, *fields.where_sigma_vanishes())]
        curves += [*fields.where_k_vanishes(inner), fields.where_type_changes(inner)]
        for tau in curves:
            yield from _extremes(fields.on_O4(inner, tau)[0])
        for one, other in combinations(curves, 2):
            gap = one - other
            for k in np.flatnonzero(gap[:-1] * gap[1:] < 0):
                share = gap[k] / (gap[k] - gap[k + 1])
                at, tau = (x[k] + share * (x[k + 1] - x[k]) for x in (inner, one))
                yield float(fields.on_O4(np.array(at), np.array(tau))[0])
    for end in (float(fields.a), float(fields.b)):
        for s in (np.array([end]), np.array([-end])):
            beside = (*fields.where_k_vanishes(s), fields.where_type_changes(s))
            for tau in (0.0, *fields.where_sigma_vanishes(), *np.ravel(beside)):
                if np.isfinite(tau):
                    yield float(fields.on_O4(s, np.array([tau]))[0][0])


def _extremes(values: Array) -> Iterator[float]:
    """The extreme values inside a curve, by parabolas through three of its points."""
    here, before, after = values[1:-1], values[1:-1] - values[:-2], values[1:-1] - values[2:]
    above = before * after > (ROUNDING * here) ** 2  # and no rounding of a constant
    for k in np.flatnonzero(above):
        yield float(here[k] + (before[k] - after[k]) ** 2 / (8 * (before[k] + after[k])))


def kind(fields: Fields, h: float) -> tuple[tuple[int, ...], ...]:
    """The numbers and types of tori along the curves of M⁴, N⁴ and O⁴ at an energy."""
    return tuple(_along(curve) for curves in section(fields, h) for curve in curves)


def _along(curve: Curve) -> tuple[int, ...]:
    """The numbers of tori along a curve, negative for hyperbolic ones, each part once."""
    signed: Integers = np.where(np.isfinite(curve.g), curve.tori, 0) * np.where(
        curve.hyperbolic, -1, 1
    )
    found: list[int] = []
    for part in np.split(signed, np.flatnonzero(np.diff(signed)) + 1):
        if len(part) >= NARROW and (not found or found[-1] != part[0]):
            found.append(int(part[0]))
    return tuple(found)
