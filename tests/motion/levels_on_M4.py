"""Real states of M⁴ for the tests of this folder, by chance or with given values of H and J3."""

import numpy as np
from scipy.optimize import least_squares
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from kowalevski_cas.motion.formulas import values_of_offer
from tests.motion.test_critical import state_of

STEPS, STEP = 1500, 0.02
"""Steps of Runge and Kutta, and their length."""


def by_chance(fields, count):
    """States of M⁴, with their values of J3 and H."""
    states = fields.states(count)
    random = np.random.default_rng(2)
    x1 = states[:, 3] - states[:, 7] + 1j * (states[:, 4] + states[:, 6])
    w1 = np.sqrt(-x1) * random.choice([-1, 1], count)
    states[:, :3] = np.stack([w1.real, w1.imag, 2 * random.normal(size=count)], axis=1)
    omega, alpha, beta = states[:, :3], states[:, 3:6], states[:, 6:]
    energy = np.sum(omega**2 * (1, 1, 0.5), axis=1) - alpha[:, 0] - beta[:, 1]
    turning = abs(w1) ** 2 * omega[:, 2]
    return states, turning + 2 * (omega[:, 0] * alpha[:, 2] + omega[:, 1] * beta[:, 2]), energy


def at_level(fields, h, j, count=4000, finely=400):
    """States of M⁴ with these values.

    For given ω1, ω2 the level of H is a circle in the plane of (α3, β3); on it the equation
    |α|² + |β|² = p² is solved.
    """
    p_square, r_square = float(fields.a**2 + fields.b**2), float(fields.a**2 - fields.b**2)
    random = np.random.default_rng(4)
    W = float(fields.a + fields.b) * random.uniform(size=(count, 1))
    w = np.sqrt(W) * np.exp(2j * np.pi * random.uniform(size=(count, 1)))
    square = (j**2 + 2 * h * W**2 - 2 * W**3 - 2 * r_square * (w**2).real) / (2 * W)
    real = square[:, 0] > 0
    W, w, square = W[real], w[real], square[real]

    def around(angle):
        z = j * w / W + np.sqrt(square) * np.exp(1j * angle)
        sum_of_squares = abs(z) ** 2 + (W**2 + abs((z**2 - r_square) / W) ** 2) / 2
        return z, sum_of_squares - p_square

    angles = np.linspace(0, 2 * np.pi, finely + 1)
    above = around(angles[None])[1] > 0
    row, column = np.nonzero(above[:, 1:] != above[:, :-1])
    W, w, square = W[row], w[row], square[row]
    low, high = angles[column][:, None], angles[column + 1][:, None]
    first = above[row, column][:, None]
    for _ in range(50):
        middle = (low + high) / 2
        same = (around(middle)[1] > 0) == first
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    z = around(low)[0][:, 0]
    W, w = W[:, 0], w[:, 0]
    omega3 = (j - 2 * (w * z.conj()).real) / W
    return state_of(-(w**2), ((z**2 - r_square) / w**2).conj(), z, w, omega3).T


def critical_levels(fields, starts):
    """Values of H and J3 at points of M⁴ where they are dependent: Newton's method at random.

    The points are (ω1, ω2, α3, β3, ω3), on which |α|² + |β|² = p² besides; multipliers are found
    with them.
    """
    p_square, r_square = float(fields.a**2 + fields.b**2), float(fields.a**2 - fields.b**2)
    random = np.random.default_rng(8)

    def values(x):
        w, z, omega3 = complex(x[0], x[1]), complex(x[2], x[3]), x[4]
        W, y = abs(w) ** 2, (z**2 - r_square) / w**2
        return np.array([
            W + omega3**2 / 2 - y.real,
            W * omega3 + 2 * (w * z.conjugate()).real,
            (W**2 + abs(y) ** 2) / 2 + abs(z) ** 2 - p_square,
        ])  # fmt: skip

    def missing(x):
        step = 1e-6 * np.eye(5)
        slopes = np.array([values(x[:5] + s) - values(x[:5] - s) for s in step]) / 2e-6
        return [*(slopes @ x[5:]), x[5:] @ x[5:] - 1, values(x)[2]]

    for _ in range(starts):
        found = least_squares(missing, random.normal(size=8), max_nfev=60)
        if found.cost < 1e-16 and np.hypot(*found.x[:2]) > 1e-2:
            yield values(found.x)[:2]


def followed(states):
    """The states (STEPS / 5, N, 9) along the motions through states (N, 9)."""

    def rates(values):
        return np.array(values_of_offer("equations")(*values))

    here, found = states.T, []
    for step in range(STEPS):
        if step % 5 == 0:
            found.append(here.T)
        one = rates(here)
        two = rates(here + STEP / 2 * one)
        three = rates(here + STEP / 2 * two)
        four = rates(here + STEP * three)
        here = here + STEP / 6 * (one + 2 * two + 2 * three + four)
    return np.array(found)


def pieces(fields, h, j, most=150, near=0.03):
    """The number of pieces of a level: motions are in one that come near each other."""
    states = at_level(fields, h, j)
    if not len(states):
        return 0
    orbits = followed(np.random.default_rng(5).permutation(states)[:most])
    points = orbits.reshape(-1, 9)
    owner = np.tile(np.arange(orbits.shape[1]), len(orbits))
    size = np.sqrt(points.var(axis=0).sum())
    left, right = owner[cKDTree(points / size).query_pairs(near, output_type="ndarray").T]
    graph = coo_array((np.ones(len(left)), (left, right)), shape=(orbits.shape[1],) * 2)
    return connected_components(graph, directed=False)[0]
