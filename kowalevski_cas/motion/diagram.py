r"""The bifurcation diagram of the whole top: the critical values of H, K, G, and where motions are.

It is the image of M⁴, N⁴, O⁴ and of the rotations about the third axis under (H, K, G). The
values come from the formulas of the derivations, the tori from the regimes. The image of all
states has a part of the diagram as its boundary: so a piece between its curves is filled with
motions if there is one in it.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array, Integers, Mask
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.regimes import RegimeO4, regime_of
from kowalevski_cas.motion.parameters import Inadmissible
from kowalevski_cas.paper.closed_form import CriticalSets, HyperellipticForm, LevelsOnM4

NEAR = 1e-7
"""How far beside a separating curve motions are looked for."""

POINTS = 1500
"""Values of s between two where regimes meet."""


@dataclass(frozen=True)
class Fields:
    """Fields of lengths a > b > 0 at right angles; the critical values in them."""

    a: Fraction
    b: Fraction

    def __post_init__(self) -> None:
        """Refuse a single field, for which the regimes of O⁴ are not known."""
        if self.b == 0:
            raise Inadmissible("b = 0: the diagrams of the whole top are those of two fields")

    @cached_property
    def _pr(self) -> tuple[float, float]:
        """The constants p and r."""
        a, b = float(self.a), float(self.b)
        return float(np.hypot(a, b)), float(np.sqrt(a * a - b * b))

    def on_M4(self, h: Array, j: Array) -> tuple[Array, Array]:
        """The values of K and G on M⁴ at the energy h, where J₃ = j."""
        k, gap = formulas.values_of_offer("M4_values", CriticalSets)(j)
        return k + 0 * h, (self._pr[0] ** 2 * h - gap) / 2

    def tori_on_M4(self, h: Array, j: Array) -> Integers:
        """The number of tori on M⁴ at the energy h where J₃ = j; zero where there is no motion.

        Each two negative roots of the polynomial in ξ double the number, and there are no motions
        where it has a positive one.
        """
        p, r = self._pr
        places = np.arange(-2.0, 3.0)
        polynomial = formulas.values_of_offer("polynomial", LevelsOnM4)
        (values,) = polynomial(p * places[:, None], h.ravel(), j.ravel(), p, r)
        first, *rest = np.linalg.solve(np.vander(places), values)
        companion = np.zeros((h.size, 4, 4))
        companion[:, 0], companion[:, [1, 2, 3], [0, 1, 2]] = -np.array(rest / first).T, 1.0
        roots = np.linalg.eigvals(companion)
        real, negative = roots.imag == 0, roots.real < 0
        doubled = np.sum(real & negative, axis=1) // 2
        found: Integers = np.where(np.any(real & ~negative, axis=1), 0, 2**doubled)
        return found.reshape(h.shape)

    def on_N4(self, h: Array, m: Array) -> tuple[Array, Array]:
        """The values of K and G on N⁴ at the energy h."""
        p, r = self._pr
        k, gap = formulas.values_of_offer("N4_values", CriticalSets)(m, r)
        return k, (p**2 * h + gap) / 2

    def on_O4(self, s: Array, tau: Array) -> tuple[Array, Array, Array]:
        """The values of H, K and G on O⁴."""
        with np.errstate(divide="ignore", invalid="ignore"):
            h, k, g = formulas.values_of_offer("integrals", HyperellipticForm)(s, tau, *self._pr)
        return h, k, g

    def hyperbolic_on_O4(self, s: Array, tau: Array) -> Mask:
        """Whether the tori of O⁴ are hyperbolic."""
        with np.errstate(divide="ignore", invalid="ignore"):
            (second,) = formulas.values_of_offer("curvature", HyperellipticForm)(s, tau, *self._pr)
            found: Mask = s * tau * second > 0
        return found

    def tau(self, s: Array, h: Array) -> Array:
        """The τ₃ on O⁴ at the energy h, which is linear in it."""
        start, end = self.on_O4(s, 0 * s)[0], self.on_O4(s, 0 * s + 1)[0]
        with np.errstate(invalid="ignore"):
            return (h - start) / (end - start)

    def squares(self, s: Array, tau: Array) -> tuple[Array, Array]:
        """The constants σ and κ² = 4s²k on O⁴."""
        sigma = 4 * (self.on_O4(1 + 0 * s, tau)[1] - tau)
        return sigma, sigma + 4 * s**2 * tau

    def regimes(self, s: Array, tau: Array) -> tuple[Integers, list[RegimeO4]]:
        """The regime of O⁴ at each s and τ₃, by its place in a list; −1 where there is no motion.

        The regimes meet where these expressions vanish, and the roots are in one order where all
        have the same signs: so one place of each kind tells it for all.
        """
        a, b, r_square = float(self.a), float(self.b), self._pr[1] ** 2
        signs = np.sign([
            s, tau, *self.squares(s, tau), s**2 - a**2, s**2 - b**2, tau - r_square, tau + r_square,
        ]).reshape(8, -1)  # fmt: skip
        signs[~np.isfinite(signs)] = 0
        _, places, which = np.unique(signs, axis=1, return_index=True, return_inverse=True)
        known: list[RegimeO4] = []
        numbers = []
        for place in places:
            regime = self._regime(s.flat[place], tau.flat[place]) if signs[:, place].all() else None
            if regime is not None and regime not in known:
                known.append(regime)
            numbers.append(-1 if regime is None else known.index(regime))
        found: Integers = np.array(numbers)[which].reshape(s.shape)
        return found, known

    def _regime(self, s: float, tau: float) -> RegimeO4 | None:
        try:
            return regime_of(ParametersO4(self.a, self.b, Fraction(s), Fraction(tau)))
        except Inadmissible:
            return None

    def where_k_vanishes(self, s: Array) -> list[Array]:
        """The two τ₃ for which κ = 0, where O⁴ has common points with M⁴, for each s.

        The equation is quadratic in τ₃; not a number where it has no real roots.
        """
        below, constant, above = (self.squares(s, 0 * s + tau)[1] for tau in (-1, 0, 1))
        return _roots((above - below) / 2, constant)

    def where_type_changes(self, s: Array) -> Array:
        """The τ₃, beside zero, at which tori of O⁴ turn from elliptic to hyperbolic, for each s.

        The curvature is linear in τ₃.
        """
        curvature = formulas.values_of_offer("curvature", HyperellipticForm)
        (start,), (end,) = (curvature(s, tau, *self._pr) for tau in (0.0, 1.0))
        found: Array = start / (start - end)
        return found

    def where_sigma_vanishes(self) -> list[float]:
        """The two τ₃ for which σ = 0."""
        below, constant, above = (self.squares(np.zeros(1), np.array([t]))[0] for t in (-1.0, 0, 1))
        return [float(root[0]) for root in _roots((above - below) / 2, constant)]

    def is_real(self, s: Array, tau: Array) -> Mask:
        """Whether there are motions on O⁴ as near as can be to values on a separating curve."""
        found = np.zeros(np.shape(s), dtype=bool)
        for step_s in (-NEAR, NEAR):
            for step_tau in (-NEAR, NEAR):
                beside = s * (1 + step_s) + step_s, tau * (1 + step_tau) + step_tau
                found |= self.regimes(*beside)[0] >= 0
        return found

    def j(self, h: Array, g: Array) -> Array:
        """The absolute value of J₃ on M⁴ by those of H and G."""
        _, unit = formulas.values_of_offer("M4_values", CriticalSets)(1.0)
        with np.errstate(invalid="ignore"):
            square = np.array(self._pr[0] ** 2 * h - 2 * g) / unit
            square[abs(square) < 1e-12 * (1 + abs(g))] = 0.0
            found: Array = np.sqrt(square)
        return found

    def M4_and_O4(self) -> list[tuple[Array, Array]]:
        """The curves (|J₃|, H) of the common points of M⁴ and O⁴."""
        found = []
        for s in self.parts():
            for tau in self.where_k_vanishes(s):
                h, _, g = self.on_O4(s, np.where(self.is_real(s, tau), tau, np.nan))
                found.append((self.j(h, g), h))
        return found

    def parts(self, reach: float = 30.0) -> list[Array]:
        """Values of s between those where regimes meet, denser towards these."""
        a, b = float(self.a), float(self.b)
        ends = np.array([-reach * a, -a, -b, 0, b, a, reach * a])
        share = (1 - np.cos(np.linspace(0, np.pi, POINTS))) / 2
        return [low + (high - low) * share for low, high in pairwise(ends)]

    def states(self, count: int) -> Array:
        """So many directions of the fields by chance, as states (N, 9) at rest."""
        random = np.random.default_rng(1)
        first, second = random.normal(size=(2, count, 3))
        first /= np.linalg.norm(first, axis=1)[:, None]
        second -= np.sum(first * second, axis=1)[:, None] * first
        second /= np.linalg.norm(second, axis=1)[:, None]
        return np.hstack([0 * first, float(self.a) * first, float(self.b) * second])

    def at_energy(self, h: float, count: int) -> Array:
        """Up to so many states (N, 9) by chance with the energy h."""
        states = self.states(count)
        rest = formulas.values_of_offer("integrals")(*states.T)[0]
        states, rest = states[rest < h], rest[rest < h]
        directions = np.random.default_rng(3).normal(size=(len(states), 3))
        directions *= np.sqrt((h - rest) / np.sum(directions**2, axis=1))[:, None]
        states[:, :3] = directions * (1, 1, np.sqrt(2))
        found: Array = states
        return found


def _roots(linear: Array, constant: Array) -> list[Array]:
    """The roots of x² + linear·x + constant, not a number where they are not real."""
    half = linear / 2
    square = half**2 - constant
    square[abs(square) < 1e-12 * half**2] = 0.0  # a double root, but for rounding
    with np.errstate(invalid="ignore"):
        return [-half + sign * np.sqrt(square) for sign in (1, -1)]
