"""Sums of squares: a polynomial that is nowhere negative, and vanishes only where each square does.

For p the Gram matrix is taken on the monomials whose squares occur in p with
positive coefficients; it is brought to squares one variable after another (the
reduction of Lagrange). There are sums of squares that this does not find.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import isqrt

from kowalevski_cas.algebra.polynomials import Terms

Squares = tuple[tuple[Fraction, Terms], ...]
"""Positive factors, and what is squared."""

SMALL = 1000
"""Up to where numbers are made of four squares (Lagrange); others lose the largest one first."""

Monomial = tuple[int, ...]


def sum_of_squares(terms: Terms) -> Squares | None:
    """A polynomial as a sum of squares with positive factors, or ``None``.

    >>> x, y = (1, 0), (0, 1)
    >>> one = Fraction(1)
    >>> sum_of_squares({(2, 0): one, (1, 1): 2 * one, (0, 2): one}) == ((1, {x: one, y: one}),)
    True
    """
    gram = _gram(terms)
    return None if gram is None else reduce_gram(gram)


def _gram(terms: Terms) -> dict[Monomial, dict[Monomial, Fraction]] | None:
    """A symmetric matrix of the polynomial on its half monomials."""
    halves = [
        tuple(e // 2 for e in exponents)
        for exponents, value in terms.items()
        if value > 0 and not any(e % 2 for e in exponents)
    ]
    known = set(halves)
    gram: dict[Monomial, dict[Monomial, Fraction]] = {m: {} for m in halves}
    for exponents, value in terms.items():
        middle = tuple(e // 2 for e in exponents)
        if middle in known and not any(e % 2 for e in exponents):
            gram[middle][middle] = value
            continue
        pairs = [
            (m, other)
            for m in halves
            if (other := tuple(a - b for a, b in zip(exponents, m, strict=True))) in known
        ]
        if not pairs:
            return None
        for m, other in pairs:
            gram[m][other] = value / len(pairs)
    return gram


def reduce_gram(gram: dict[Monomial, dict[Monomial, Fraction]]) -> Squares | None:
    """The squares of a symmetric matrix; ``None`` if it is not positive. The matrix is used up."""
    squares: list[tuple[Fraction, Terms]] = []
    while gram:
        m, row = next(iter(gram.items()))
        factor = row.get(m, Fraction(0))
        del gram[m]
        if factor == 0 and not any(row.values()):
            continue
        if factor <= 0:
            return None
        base = {other: value / factor for other, value in row.items() if value}
        squares.append((factor, base))
        for column in gram:
            for other in gram:
                change = factor * base.get(column, Fraction(0)) * base.get(other, Fraction(0))
                if change:
                    gram[column][other] = gram[column].get(other, Fraction(0)) - change
            gram[column].pop(m, None)
    return tuple(squares)


def few_squares(number: Fraction) -> tuple[Fraction, ...]:
    """Rational numbers, the squares of which add up to a positive number: four, if it is small.

    >>> few_squares(Fraction(7, 3))
    (Fraction(4, 3), Fraction(2, 3), Fraction(1, 3), Fraction(0, 1))
    >>> sum(part**2 for part in few_squares(Fraction(10**12 + 39, 7)))
    Fraction(1000000000039, 7)
    """
    whole, parts = number.numerator * number.denominator, list[int]()
    while whole > SMALL:
        parts.append(isqrt(whole))
        whole -= parts[-1] ** 2
    top = isqrt(whole)
    for a, b, c in product(range(top, -1, -1), repeat=3):
        rest = whole - a * a - b * b - c * c
        if rest >= 0 and isqrt(rest) ** 2 == rest:
            parts += (a, b, c, isqrt(rest))
            return tuple(Fraction(part, number.denominator) for part in parts)
    raise AssertionError("every natural number is a sum of four squares")
