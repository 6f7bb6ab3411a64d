r"""How far a state is from M⁴, N⁴ and O⁴, the sets on which H, K, G are dependent.

The left sides of their equations are homogeneous in ω, of weight 1, and the fields, of weight 2.
Each is divided by a product of sizes of the state with the same weight, so that the residual is
the same for (νω, ν²α, ν²β), the same motion in another unit of time: it is zero on the set, of
the order of 1 for states by chance, and near the set about as large as the relative change of
the state that would bring it there.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array, Complex
from kowalevski_cas.paper.closed_form import CriticalSets

Number = Any
"""A fraction or an array."""

SETS = ("M4", "N4", "O4")

TOLERANCE = Fraction(1, 10**8)
"""The largest residual of a state that counts as one on the set."""

LEAST_THETA = 1e-12
"""The least x1x2 over r⁴/p², that is p²/(s1 − s2)², for which s1 is finite: the root is what
s2 loses in accuracy."""

LARGEST_S = 1e100
"""The largest |s| that is tried, for a state of the size one; its square is a float."""


def residuals(states: Array) -> dict[str, Array]:
    """The residuals (…) of states (…, 9), by the names in :data:`SETS`."""
    omega, fields = (np.max(np.abs(part), axis=-1) for part in (states[..., :3], states[..., 3:]))
    unit = np.hypot(omega, np.sqrt(fields))
    unit[unit == 0] = 1.0
    known = formulas.values_of_offer("complex_variables")(
        *np.moveaxis(states[..., :3] / unit[..., None], -1, 0),
        *np.moveaxis(states[..., 3:] / unit[..., None] / unit[..., None], -1, 0),
        1j,
    )
    largest = fields / unit / unit
    found = (_on_M4(known, largest), _on_N4(known, largest), _on_O4(known, largest))
    return dict(zip(SETS, found, strict=True))


def on(residuals: dict[str, float]) -> list[str]:
    """The sets on which a state with these residuals lies."""
    return [name for name, residual in residuals.items() if residual <= TOLERANCE]


def bounds(theta: Number, r_fourth: Number, fields: Number, size: Number) -> tuple[Number, Number]:
    """The squares of what the two left sides of (16) are compared with, for states of this size."""
    return theta * fields**2 * size, r_fourth * theta**2 * size**2


def _on_M4(known: tuple[Complex, ...], largest: Array) -> Array:
    first, _ = formulas.values_of_offer("M4", CriticalSets)(*known)
    return _quotient(abs(first), abs(known[6]) ** 2 + largest)


def _on_N4(known: tuple[Complex, ...], largest: Array) -> Array:
    """Not a number where x1x2 = 0 as good as exactly: there the equations say nothing."""
    functions = formulas.values_of_offer("N4", CriticalSets)(*known)
    x1, x2, _, y2, z1, *_ = known
    theta, r_fourth = abs(x1 * x2), abs(z1**2 + x1 * y2) ** 2
    squares = bounds(theta, r_fourth, largest, np.ones_like(theta))
    found = [
        _quotient(abs(value), np.sqrt(square))
        for value, square in zip(functions, squares, strict=True)
    ]
    return np.where(theta * largest**2 <= LEAST_THETA * r_fourth, np.nan, np.maximum(*found))


def _on_O4(known: tuple[Complex, ...], largest: Array) -> Array:
    """The least residual for any of the values of s that one of the equations gives."""
    O4 = formulas.values_of_offer("O4", CriticalSets)
    below, here, above = (np.array(O4(*known, float(s))) for s in (-1, 0, 1))
    slope, square = (above - below) / 2, (above + below) / 2 - here
    omega3 = abs(known[8])
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        root = np.sqrt((slope[2] ** 2 - 4 * square[2] * here[2]).real)
        candidates = np.array([
            *(-(here[k] / slope[k]).real for k in (0, 3)),
            *((-slope[2].real + sign * root) / (2 * square[2].real) for sign in (1, -1)),
        ])  # fmt: skip
    least = np.full_like(largest, np.inf)
    for s in np.where(abs(candidates) < LARGEST_S, candidates, 0.0):
        size = largest + 2 * abs(s)
        E = abs(here + slope * s + square * s**2)
        found = np.max(
            [
                _quotient(E[0], size),
                _quotient(E[2], size**2 + 2 * abs(s) * omega3**2),
                _quotient(E[3], size * largest + 2 * abs(s) * omega3),
            ],
            axis=0,
        )
        least = np.fmin(least, found)
    return least


def _quotient(value: Array, bound: Array) -> Array:
    """Their quotient; zero where both are zero."""
    return np.divide(value, bound, out=np.zeros_like(value), where=bound != 0)
