r"""The regimes of N⁴: the orders of the roots in which both radicands are non-negative.

With :math:`\varphi(s)=4m(s-A)(s-C)`, :math:`A=(\ell+1)/2m`, :math:`C=(\ell-1)/2m`, the
motion is real where

.. math:: s_1^2\ge a^2,\quad -\varphi(s_1)\ge 0,\qquad s_2^2\le b^2,\quad \varphi(s_2)\ge 0.

Each variable runs over an arc of the projective line between two neighbouring roots of its
quartic, or rests on one. All orders of :math:`\pm a,\pm b,A,C` are tried; those that leave an
arc to both variables are the regimes: three for m > 0, nine for m < 0 (and three more for
m > 0 that mirror the others by :math:`\sqrt{x_1x_2}\to-\sqrt{x_1x_2}`, that is ℓ, s1, s2 → −).
For m < 0 the variable s1 passes through infinity, where x1x2 = 0; the motion is regular there,
and (m, ℓ), (m, −ℓ) denote the same motions.

An arc whose ends are roots of the same radicand (both ±a, or both A and C) has two components,
on which the other root keeps its sign; an arc with mixed ends has one. A torus is a product of
components. On ℓ = 0 itself, m < 0, the mirror leads back to the same level: four tori stay where
A < −a, and are the same in pairs, two being left, elsewhere.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import pairwise

from kowalevski_cas.motion.parameters import (
    Inadmissible,
    Parameters,
    ball,
    energies,
    extreme_ell,
    round_towards,
)

FIELD_1, FIELD_2, PHI = ("-a", "a"), ("-b", "b"), ("C", "A")
"""The roots of the radicands S1², S2² and f²."""


NOISE = Fraction(1, 2**256)
"""What is smaller beside the rest after a turn by a rounded angle, is zero."""


@dataclass(frozen=True)
class Arc:
    """The arc of one variable: from the root ``roots[0]`` upwards to ``roots[1]``.

    The next root above these is ``roots[2]``, the next one below ``roots[3]``, in the cyclic order
    upwards along the projective line. ``infinite`` says whether the arc passes through infinity.
    """

    roots: tuple[str, str, str, str]
    infinite: bool

    @property
    def ends(self) -> tuple[str, str]:
        """The roots between which it is."""
        return self.roots[:2]

    @property
    def components(self) -> int:
        """The number of closed curves above an arc on N⁴: signs that never change."""
        return 2 if any({*self.ends} == {*pair} for pair in (FIELD_1, FIELD_2, PHI)) else 1

    def __str__(self) -> str:
        """The arc in the letters of the paper."""
        first, last = self.ends
        return f"[{first}, ∞] ∪ [-∞, {last}]" if self.infinite else f"[{first}, {last}]"


@dataclass(frozen=True)
class Regime:
    """An order of the six roots in which the motion is real, for one sign of m."""

    sign: int
    order: tuple[str, ...]
    s1: Arc
    s2: Arc

    @property
    def tori(self) -> int:
        """The number of two-dimensional tori on which m and ℓ ≠ 0 have given values."""
        return self.s1.components * self.s2.components

    def __str__(self) -> str:
        """The order as the paper writes it."""
        return f"m {'>' if self.sign > 0 else '<'} 0, " + " < ".join(self.order)


@cache
def all_regimes() -> tuple[Regime, ...]:
    """Every regime, found by trying all orders of the roots for both signs of m.

    >>> len(all_regimes())
    15
    """
    return tuple(
        Regime(sign, order, s1, s2)
        for sign in (1, -1)
        for order in _orders(sign)
        for s1 in _arcs(order, "a", sign)
        for s2 in _arcs(order, "b", sign)
    )


def regime_of(parameters: Parameters) -> Regime:
    """The regime of given constants; on a separating curve, one of those that meet there.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` if there is none.
    """
    sign = 1 if parameters.m > 0 else -1
    for regime in all_regimes():
        if regime.sign == sign and all(
            compare(parameters, low, high) <= 0 for low, high in pairwise(regime.order)
        ):
            return regime
    raise Inadmissible(_why_not(parameters))


def tori(parameters: Parameters) -> int:
    """The number of tori on which the constants have these values, also ℓ = 0.

    There the mirror, (s1, s2, S1, S2) → −(s1, s2, S1, S2), leads to the same level. Through
    infinity it is f1/s1 or S1/s1 that keeps its sign; the mirror changes the first, and so makes
    pairs of tori the same where s1 runs from a through ∞ to −a.
    """
    regime = regime_of(parameters)
    meeting = parameters.ell_sign == 0 and {*regime.s1.ends} == {*FIELD_1}
    return regime.tori // 2 if meeting else regime.tori


def coincidences(parameters: Parameters) -> list[str]:
    """Which roots coincide: the separating curves on which the constants lie."""
    found = [
        f"{root} = {end}"
        for root in PHI
        for end in (*FIELD_1, *FIELD_2)
        if compare(parameters, root, end) == 0
    ]
    return found + ["ℓ = 0"] * (parameters.ell_sign == 0)


def ells(parameters: Parameters, regime: Regime) -> tuple[float, float]:
    """Between which two values ℓ ≥ 0 is in a regime, whatever that of the constants; or none."""
    low, high = 0.0, math.inf
    for left, right in pairwise(regime.order):
        slope, constant = gap(parameters, right, left)
        if slope > 0:
            low = max(low, float(-constant / slope))
        elif slope < 0:
            high = min(high, float(-constant / slope))
        elif constant <= 0:
            return low, low
    return low, max(low, high)


def without_rounding(rounded: Parameters) -> Parameters:
    """The constants for which roots that differ by rounding are the same."""
    ends = {
        root: coordinates(rounded, end)[1]
        for root in PHI
        for end in (*FIELD_1, *FIELD_2)
        if abs(rounded.value(*gap(rounded, root, end))) < ball(NOISE * rounded.a)
    }
    if not ends:
        return rounded
    m = 1 / (ends["A"] - ends["C"]) if len(ends) == 2 else rounded.m
    ell = 2 * m * ends["A"] - 1 if "A" in ends else 2 * m * ends["C"] + 1
    return Parameters.of(rounded.a, rounded.b, m, ell)


def signs_of(parameters: Parameters, torus: int) -> tuple[int, int]:
    """The signs of S1 and S2 at the first roots on a torus, one of :func:`tori`, from 1."""
    regime = regime_of(parameters)
    check_torus(torus, tori(parameters))
    first, second = divmod(torus - 1, regime.s2.components)
    return 1 - 2 * first, 1 - 2 * second


def check_torus(torus: int, count: int) -> None:
    """Refuse the number of a torus that there is not."""
    if not 1 <= torus <= count:
        known = f"tori 1 to {count}" if count > 1 else "one torus"
        raise Inadmissible(f"there is no torus {torus}: these constants have {known}")


def coordinates(parameters: Parameters, root: str) -> tuple[Fraction, Fraction]:
    r"""The slope and the constant of a root as a linear expression in :math:`\ell`."""
    if root in PHI:
        half = 1 / (2 * parameters.m)
        return half, half if root == "A" else -half
    length = parameters.a if root.endswith("a") else parameters.b
    return Fraction(0), -length if root.startswith("-") else length


def compare(parameters: Parameters, left: str, right: str) -> int:
    """The sign of one root minus another, exactly."""
    return parameters.sign(*gap(parameters, left, right))


def gap(parameters: Parameters, left: str, right: str) -> tuple[Fraction, Fraction]:
    r"""One root minus another as a linear expression in :math:`\ell`: slope and constant."""
    (x, y), (z, w) = coordinates(parameters, left), coordinates(parameters, right)
    return x - z, y - w


def _orders(sign: int) -> Iterator[tuple[str, ...]]:
    """All orders of the six roots: A − C = 1/m has the sign of m."""
    low, high = PHI if sign > 0 else PHI[::-1]
    fixed = ("-a", "-b", "b", "a")
    for i in range(5):
        for j in range(i, 5):
            yield (*fixed[:i], low, *fixed[i:j], high, *fixed[j:])


def _arcs(order: tuple[str, ...], length: str, sign: int) -> Iterator[Arc]:
    """The arcs between neighbouring roots on which both radicands of a variable are positive."""
    ends = (f"-{length}", length)
    boundary = [root for root in order if root in (*ends, *PHI)]
    outer = 1 if length == "a" else -1  # the sign of S² outside its roots, and of −f²/m
    for k in range(4):
        roots = (boundary[k], boundary[(k + 1) % 4], boundary[(k + 2) % 4], boundary[(k + 3) % 4])
        between = {
            pair: sum(boundary.index(root) <= k for root in pair) == 1 for pair in (ends, PHI)
        }
        field = -outer if between[ends] else outer
        phi = -1 if between[PHI] else 1
        if field > 0 and -outer * sign * phi > 0:
            yield Arc(roots, infinite=k == 3)


def _why_not(parameters: Parameters) -> str:
    """Which radicand is negative, and what range of ℓ would do."""
    a, b, m = parameters.a, parameters.b, parameters.m
    ell = f"|ℓ| = {float(abs(parameters.ell)):.6g}"
    bound = extreme_ell(a, b, m)
    below_first = parameters.sign(Fraction(parameters.ell_sign), 1 - 2 * a * m) < 0
    if m > 0 and below_first:
        words = "f1² = −φ(s1) is negative for all |s1| ≥ a"
    else:
        words = "f2² = φ(s2) is negative for all |s2| ≤ b"
    sign = "≥" if m > 0 else "≤"
    return (
        f"{ell} with m = {float(m):.6g}: {words}; "
        f"|ℓ| {sign} {round_towards(bound, up=m > 0)}, that is {energies(a, b, m)}, would do"
    )
