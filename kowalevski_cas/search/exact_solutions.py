"""Systems of which several solutions are rational, found among points with small coordinates."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product

from flint import fmpq, fmpq_poly

from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.search.eliminants import Eliminant

LARGEST = 4
"""The largest coordinate of the points that are tried."""

Values = tuple[Fraction, ...]


def value(terms: Mapping[tuple[int, ...], Fraction], at: Sequence[Fraction | int]) -> Fraction:
    """The value of a polynomial."""
    total = Fraction(0)
    for exponents, coefficient in terms.items():
        for x, exponent in zip(at, exponents, strict=True):
            if exponent:
                coefficient *= x**exponent
        total += coefficient
    return total


def small_points(levels: Sequence[Terms], size: int) -> Iterator[tuple[Values, Values]]:
    """Points with small integer coordinates, and what the levels are there; small ones first."""
    numbers = [Fraction(n) for n in range(-LARGEST, LARGEST + 1)]
    grid = product(numbers, repeat=size)
    for point in sorted(grid, key=lambda p: (max(map(abs, p)), sum(map(abs, p)))):
        yield point, tuple(value(level, point) for level in levels)


def many(
    levels: Sequence[Terms], size: int, count: int, usable: Callable[[Values], bool]
) -> list[Values] | None:
    """``count`` points with the same usable values of the levels."""
    groups: dict[Values, list[Values]] = {}
    for point, values in small_points(levels, size):
        if usable(values):
            group = groups.setdefault(values, [])
            group.append(point)
            if len(group) == count:
                return group
    return None


def all_solutions(
    found: Eliminant, levels: Sequence[Terms], usable: Callable[[Values], bool]
) -> list[Values] | None:
    """All solutions for values of the levels for which the roots are rational and distinct."""
    size = max(key[0] for key in found.equation)
    for _, values in small_points(levels, len(found.form)):
        if not usable(values):
            continue
        below = [value(terms, (0, *values)) for terms in found.denominators]
        if 0 in below:
            continue
        coefficients = [Fraction(0)] * (size + 1)
        for (power, *others), coefficient in found.equation.items():
            coefficients[power] += value({tuple(others): coefficient}, values)
        polynomial = fmpq_poly([fmpq(c.numerator, c.denominator) for c in coefficients])
        roots = [-Fraction(int(f[0].p), int(f[0].q)) / Fraction(int(f[1].p), int(f[1].q))
                 for f, _ in polynomial.factor()[1] if f.degree() == 1]  # fmt: skip
        if len(roots) == size:
            return [
                tuple(
                    value(terms, (root, *values)) / d
                    for terms, d in zip(found.numerators, below, strict=True)
                )
                for root in sorted(roots)
            ]
    return None
