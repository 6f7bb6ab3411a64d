"""Levels of the three integrals: their tori of dimension three, counted by following motions.

A level is a union of tori, and almost every motion fills its torus. So two motions on one torus
come as near to each other as their states are dense, and two on different tori do not: the tori
are the clusters of motions, and nothing is used of what is known about the top.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.diagram import Fields

MOTIONS = 24
"""How many motions are followed on a level: that one of four equal tori is missed is a chance of
four in a thousand."""

TRIED = 3 * MOTIONS
"""From how many states by chance a level is looked for."""

UNTIL, STATES = 120.0, 1200
"""For how long each is followed, where the longer field is 1, and how many of its states are
compared."""

GAP = 1.6
"""Where the distances at which clusters join grow by this factor, they have become other tori."""

STEPS, STRIDE = 60, 0.3
"""Newton steps to a level, and the largest of them as a share of the state's size."""


def count_tori(fields: Fields, levels: Sequence[tuple[float, float, float]]) -> list[int]:
    """How many tori each level (h, k, g) has, away from critical values; zero where none is met."""
    unit, a = Fields(Fraction(1), fields.b / fields.a), float(fields.a)
    found = [on_level(unit, h / a, k / a**2, g / a**3) for h, k, g in levels]
    followed = _follow(np.concatenate(found))
    ends = np.cumsum([len(states) for states in found])[:-1]
    return [_clusters(orbits) for orbits in np.split(followed, ends)]


def on_level(fields: Fields, h: float, k: float, g: float) -> Array:
    """Up to so many states (N, 9) on a level, by Newton's method from states by chance."""
    target = np.array([h, k, float(fields.a) ** 2, float(fields.b) ** 2, 0.0, g])
    states, above = fields.states(TRIED), abs(h) + float(fields.a + fields.b)
    states[:, :3] = np.random.default_rng(3).normal(size=(TRIED, 3)) * np.sqrt(above)
    size = np.max(np.abs(states), axis=1, keepdims=True)
    for _ in range(STEPS):
        step = np.einsum("nij,nj->ni", np.linalg.pinv(_slopes(states)), _values(states) - target)
        length = np.linalg.norm(step, axis=1, keepdims=True)
        states = states - step * np.minimum(1.0, STRIDE * size / np.maximum(length, 1e-300))
    off = np.abs(_values(states) - target) <= 1e-9 * (1 + np.abs(target))
    return states[np.all(off, axis=1)][:MOTIONS]


def _values(states: Array) -> Array:
    """The values (N, 6) of H, K, a², b², c, G."""
    found: Array = np.array(formulas.values_of_offer("integrals")(*states.T)[:6]).T
    return found


def _slopes(states: Array) -> Array:
    """Their derivatives (N, 6, 9); a step in the imaginary direction subtracts nothing."""
    step = 1e-30
    columns = [_values(states + 1j * step * e).imag / step for e in np.eye(9)]
    return np.stack(columns, axis=-1)


def _follow(starts: Array) -> Array:
    """The states (M, N, 9) of the motions from these starts (M, 9), all in one integration."""
    from scipy.integrate import solve_ivp

    if not len(starts):
        return np.empty((0, STATES, 9))
    rates = formulas.values_of_offer("equations")
    solution = solve_ivp(
        lambda _, y: np.ravel(rates(*y.reshape(9, -1))), (0.0, UNTIL), starts.T.ravel(),
        method="DOP853", rtol=1e-6, atol=1e-6, t_eval=np.linspace(0.0, UNTIL, STATES),
    )  # fmt: skip
    found: Array = solution.y.reshape(9, -1, STATES).transpose(1, 2, 0)
    return found


def _clusters(orbits: Array) -> int:
    """How many clusters these orbits (M, N, 9) are, by the least distances of their states."""
    from scipy.cluster.hierarchy import linkage
    from scipy.spatial import cKDTree

    if len(orbits) < 2:
        return len(orbits)
    trees = [cKDTree(orbit) for orbit in orbits]
    distances = [
        float(np.min(tree.query(orbit[::2])[0]))
        for (tree, _), (_, orbit) in combinations(zip(trees, orbits, strict=True), 2)
    ]
    joined = linkage(distances, "single")[:, 2]
    half = len(joined) // 2
    growth = joined[half + 1 :] / joined[half:-1]
    last = int(np.argmax(growth))
    return int(len(growth) - last + 1) if growth[last] > GAP else 1
