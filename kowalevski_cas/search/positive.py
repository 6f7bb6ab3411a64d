"""Rational points at which polynomials are not negative, by small steps towards them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from math import prod

from flint import fmpq, fmpq_mpoly

from kowalevski_cas.algebra.flint import to_flint, to_fraction
from kowalevski_cas.search.points import Assignment, small_numbers

STARTS = 40
"""From how many points steps are taken."""

VALUES = tuple(fmpq(k) for k in (1, 2, 3, 4, 5, 6, -1, -2, -3, -4, 0))
"""What a coordinate is changed to."""


def positive_points(
    radicands: Sequence[fmpq_mpoly], size: int, avoid: Sequence[fmpq_mpoly] = ()
) -> Iterator[Assignment]:
    """Points where no radicand is negative, and nothing vanishes that is to be avoided.

    ``size`` is the number of coordinates. A step changes the one with which the fewest conditions
    are left that fail.
    """
    signs = _Signs([*radicands, *avoid], len(radicands))
    for sequence in islice(small_numbers(), STARTS):
        values = [to_flint(next(sequence)) for _ in range(size)]
        left = signs.failing(values)
        while left:
            steps = [(place, value) for place in range(size) for value in VALUES]
            tried = [[*values[:k], value, *values[k + 1 :]] for k, value in steps]
            best = min(tried, key=signs.failing)
            if signs.failing(best) >= left:
                break
            values, left = best, signs.failing(best)
        if not left:
            yield {place: to_fraction(value) for place, value in enumerate(values)}


class _Signs:
    """The signs of polynomials by those of their factors, each of which is looked at once.

    Some are not to be negative, and all others not to vanish.
    """

    def __init__(self, polynomials: Sequence[fmpq_mpoly], positive: int) -> None:
        self.positive, places = positive, dict[str, int]()
        self.factors: list[fmpq_mpoly] = []
        self.products: list[tuple[int, list[tuple[int, int]]]] = []
        for polynomial in polynomials:
            number, found = polynomial.factor()
            powers = []
            for factor, exponent in found:
                place = places.setdefault(str(factor), len(places))
                self.factors += [factor] if place == len(self.factors) else []
                powers.append((place, 2 - int(exponent) % 2))
            self.products.append((1 if number > 0 else -1, powers))

    def failing(self, values: list[fmpq]) -> int:
        """How many conditions fail at a point."""
        more = [fmpq(0)] * (self.factors[0].context().nvars() - len(values)) if self.factors else []
        found = [factor(*values, *more) for factor in self.factors]
        signs = [(value > 0) - (value < 0) for value in found]
        whole = [n * prod(signs[k] ** e for k, e in powers) for n, powers in self.products]
        negative = [sign for sign in whole[: self.positive] if sign < 0]
        return len(negative) + whole[self.positive :].count(0)
