"""The plane of (m, ℓ) in the fields of a motion on N⁴: the regime at each of its points."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from kowalevski_cas.motion.arrays import Array, Integers
from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.regimes import FIELD_1, FIELD_2, PHI, all_regimes, coordinates


def ell_at(parameters: Parameters, m: Array, h: Array) -> Array:
    """The ℓ ≥ 0 at an energy; not a number where there is none."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.sqrt(2 * float(parameters.p_square) * m**2 + 2 * h * m + 1))


def regime_at(parameters: Parameters, m: Array, ell: Array) -> Integers:
    """The place among all regimes of each (m, ℓ) in the fields of a motion; −1 if there is none."""
    roots = {}
    for root in (*FIELD_1, *FIELD_2, *PHI):
        slope, constant = line(parameters, m, root)
        with np.errstate(invalid="ignore"):  # at m = 0 there are no roots, and no regime
            roots[root] = slope * ell + constant
    found = np.full(m.shape, -1)
    for number, regime in enumerate(all_regimes()):
        inside = np.sign(m) == regime.sign
        for low, high in pairwise(regime.order):
            inside &= roots[low] < roots[high]
        found[inside] = number
    return found


def line(parameters: Parameters, m: Array, root: str) -> tuple[Array, Array]:
    """A root as a linear expression in ℓ, for each m; those of φ are proportional to 1/m."""
    unit = Parameters.of(parameters.a, parameters.b, 1, 0)
    slope, constant = (float(value) for value in coordinates(unit, root))
    with np.errstate(divide="ignore"):
        scale = 1 / m if root in PHI else np.ones_like(m)
    return slope * scale, constant * scale
