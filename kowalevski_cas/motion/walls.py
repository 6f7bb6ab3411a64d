r"""The curves of N⁴ and O⁴ at an energy, cut where anything on them can change.

The cuts are zeros of polynomials with rational coefficients, in s on O⁴ and in m on N⁴: where roots
coincide, where the type changes, where curves meet or end. Between two of them a curve is a graph
over :math:`\sqrt k` in the plane of :math:`(g,\sqrt k)`, with as many tori everywhere, of one type.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import pairwise
from math import sqrt
from typing import Any

import numpy as np
from flint import fmpq, fmpq_mat, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly, fmpz_poly

from kowalevski_cas.algebra.flint import to_flint, to_fraction
from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.o4 import transverse
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.regimes import regime_of as regime_on_O4
from kowalevski_cas.motion.parameters import Inadmissible, Lengths, Parameters, precision
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.regimes import regime_of
from kowalevski_cas.paper.closed_form import CriticalSets, HyperellipticForm, LevelsOnM4

BITS = 192
"""The precision of the cuts."""

_SYMBOLS = fmpq_mpoly_ctx.get(("x", "p", "r", "j"), "lex").gens()
"""The symbols in which formulas are made polynomials, of which only the squares are rational."""

NOISE = Fraction(1, 2**90)
"""Meetings with the curve of O⁴ that differ by less from a cut of N⁴ are the same."""


@dataclass(frozen=True)
class Wall:
    """A piece of a critical curve: its g over √k, from ``low`` to ``high``, and its tori."""

    name: str
    low: float
    high: float
    g: Callable[[float], float]
    tori: int
    elliptic: bool


def walls(fields: Fields, h: Fraction) -> list[Wall]:
    """The pieces of the curves of N⁴ and O⁴ at an energy on which there are motions."""
    third = CurveO4(fields, h)
    return [*third.walls(), *_on_N4(fields, h, third.meets_N4)]


class CurveO4:
    """The curve of O⁴ at an energy: τ₃, s²k and sg as polynomials in s."""

    def __init__(self, fields: Fields, h: Fraction) -> None:
        self._fields, self._h = fields, h
        places = [fmpq(x) for x in range(1, 6)]
        tau = [self._tau(s) for s in places]
        values = [_integrals(fields, s, t) for s, t in zip(places, tau, strict=True)]
        self._T, self._K, self._G = (
            _through(places, some)
            for some in (
                tau,
                [k * s * s for s, (_, k, _) in zip(places, values, strict=True)],
                [g * s for s, (_, _, g) in zip(places, values, strict=True)],
            )
        )

    def _tau(self, s: fmpq) -> fmpq:
        """The τ₃ at the energy, which is linear in it."""
        start, end = (_integrals(self._fields, s, fmpq(tau))[0] for tau in (0, 1))
        return (to_flint(self._h) - start) / (end - start)

    @property
    def meets_N4(self) -> list[Fraction]:
        """The constants m of N⁴ where the curves meet."""
        p_square, r_square = _squares(self._fields)
        found = []
        for s in _real_roots([self._on_N4]):
            gap = 2 * to_fraction(self._G(to_flint(s))) / s - p_square * self._h
            found.append(gap / r_square**2)
        return found

    @property
    def _on_N4(self) -> fmpq_poly:
        """Zero where (2g − p²h)² = r⁴k."""
        p_square, r_square = (to_flint(x) for x in _squares(self._fields))
        gap = 2 * self._G - p_square * to_flint(self._h) * fmpq_poly([0, 1])
        return gap**2 - r_square**2 * self._K

    def walls(self) -> Iterator[Wall]:
        """Its pieces on which there are motions."""
        a, b = self._fields.a, self._fields.b
        for low, high in pairwise(_real_roots(self._cuts())):
            s = _between(low, high)
            try:
                known = ParametersO4(a, b, s, to_fraction(self._T(to_flint(s))))
                tori = regime_on_O4(known).tori
            except Inadmissible:
                continue
            elliptic = transverse.kind(known) == "elliptic"
            ends = self._root(low), self._root(high)
            g = self._graph((float(low), float(high)), ends)
            yield Wall("O4", min(ends), max(ends), g, tori, elliptic)

    def _cuts(self) -> Iterator[fmpq_poly]:
        """The polynomials at whose zeros it is cut."""
        s, T, K = fmpq_poly([0, 1]), self._T, self._K
        p_square, r_square = (to_flint(x) for x in _squares(self._fields))
        yield from (s, K, self._on_N4, T, T - r_square, T + r_square)
        yield T**2 - 2 * p_square * T + r_square**2  # σ
        yield s * K.derivative() - 2 * K  # cusps, where the type changes: k is extreme
        for length in (self._fields.a, self._fields.b):
            yield s**2 - to_flint(length) ** 2
        for sign in (1, -1):  # where it meets itself, at rotations about the third axis
            yield K - to_flint(self._fields.a + sign * self._fields.b) ** 2 * s**2

    def _root(self, s: Fraction) -> float:
        """√k at s; zero where k is zero but for the rounding of s."""
        return sqrt(max(to_fraction(self._K(to_flint(s))) / s**2, Fraction(0)))

    def _graph(
        self, places: tuple[float, float], ends: tuple[float, float]
    ) -> Callable[[float], float]:
        """The value of g by √k, which is monotone between these s and is there at its ends."""
        from scipy.optimize import brentq

        low, high = places

        @cache
        def g(root: float) -> float:
            square = _rational(root) ** 2

            def above(s: float) -> float:
                return float(self._K(_rational(s)) - square * _rational(s) ** 2)

            if above(low) * above(high) < 0:
                s = brentq(above, low, high, xtol=1e-300, rtol=4 * np.finfo(float).eps)
            else:
                s = low if abs(root - ends[0]) <= abs(root - ends[1]) else high
            return float(self._G(_rational(s))) / float(s)

        return g


def _on_N4(fields: Fields, h: Fraction, meetings: Iterable[Fraction]) -> Iterator[Wall]:
    """The pieces of N⁴: its curve is two lines, on which √k = r²|m|."""
    p_square, r_square = _squares(fields)
    m = fmpq_poly([0, 1])
    ell_square = 2 * to_flint(p_square) * m**2 + 2 * to_flint(h) * m + 1
    ends = [2 * to_flint(length) * m + sign for length in (fields.a, fields.b) for sign in (1, -1)]
    exact = _real_roots([m, ell_square, *(ell_square - end**2 for end in ends)])
    others = [m for m in meetings if all(abs(m - one) > NOISE * abs(one) for one in exact)]
    for low, high in pairwise(sorted([*exact, *others])):
        middle = _between(low, high)
        try:
            tori = regime_of(Parameters.at_energy(fields.a, fields.b, middle, h)).tori
        except Inadmissible:
            continue
        sign = 1 if middle > 0 else -1

        def g(root: float, sign: int = sign) -> float:
            m = np.array(sign * root / float(r_square))
            return float(fields.on_N4(np.array(float(h)), m)[1])

        roots = [abs(float(r_square * one)) for one in (low, high)]
        yield Wall("N4", min(roots), max(roots), g, tori, sign > 0)


def _rational(number: float) -> fmpq:
    return fmpq(*number.as_integer_ratio())


def _squares(fields: Fields) -> tuple[Fraction, Fraction]:
    lengths = Lengths(fields.a, fields.b)
    return lengths.p_square, lengths.r_square


def _integrals(fields: Fields, s: fmpq, tau: fmpq) -> list[fmpq]:
    """The values of H, K, G on O⁴, exactly."""
    values = formulas.values_of_offer("integrals", HyperellipticForm)
    return [_by_squares(x, _squares(fields))[0] for x in values(s, tau, *_SYMBOLS[1:3])]


def _by_squares(value: fmpq_mpoly, squares: Sequence[Fraction]) -> fmpq_poly:
    """A polynomial in x and the squares of other symbols, of which the values are given."""
    found, known = fmpq_poly(), [to_flint(x) for x in squares]
    for (power, *others), coefficient in (_SYMBOLS[0] * 0 + value).terms():
        for square, other in zip(known, others, strict=False):
            coefficient *= square ** (other // 2)
        found += coefficient * fmpq_poly([0, 1]) ** power
    return found


def tori_on_M4(fields: Fields, h: Fraction, g: Fraction) -> int:
    """The number of tori on M⁴ at an energy where G has this value, for both signs of J₃.

    By the real roots of a polynomial, as :meth:`Fields.tori_on_M4` does in floating point.
    """
    p_square, r_square = _squares(fields)
    _, unit = formulas.values_of_offer("M4_values", CriticalSets)(fmpq(1))
    squares = (p_square, r_square, (p_square * h - 2 * g) / to_fraction(unit))
    x, p, r, j = _SYMBOLS
    (polynomial,) = formulas.values_of_offer("polynomial", LevelsOnM4)(x, to_flint(h), j, p, r)
    roots = _real_roots([_by_squares(polynomial, squares)])
    return 0 if any(root > 0 for root in roots) else 2 * 2 ** (len(roots) // 2)


def _through(places: Sequence[fmpq], values: Sequence[fmpq]) -> fmpq_poly:
    """The polynomial of lowest degree through these values."""
    count = len(places)
    matrix = fmpq_mat(count, count, [x**k for x in places for k in range(count)])
    return fmpq_poly(matrix.solve(fmpq_mat(count, 1, list(values))).entries())


def _between(low: Fraction, high: Fraction) -> Fraction:
    """A number between two, if possible one of few digits."""
    middle = (low + high) / 2
    short = Fraction(float(middle))
    return short if low < short < high else middle


def _real_roots(polynomials: Iterable[fmpq_poly]) -> list[Fraction]:
    """The real zeros of any of these, each once, in their order."""
    with precision(BITS):
        factors = {
            tuple(factor.coeffs())
            for polynomial in polynomials
            for factor, _ in polynomial.numer().factor()[1]
        }
        # The stub of python-flint leaves out that a root comes with its multiplicity.
        roots: Any = [pair for factor in factors for pair in fmpz_poly([*factor]).complex_roots()]
        return sorted(as_fraction(root.real) for root, _ in roots if root.imag == 0)
