"""Rational points at which polynomials are not negative, by small steps towards them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import islice

from flint import fmpq_mpoly

from kowalevski_cas.search.points import Assignment, constant, small_numbers

STARTS = 40
"""From how many points steps are taken."""

VALUES = tuple(Fraction(k) for k in (1, 2, 3, 4, 5, 6, -1, -2, -3, -4))
"""What a coordinate is changed to."""


def positive_points(
    radicands: Sequence[fmpq_mpoly], variables: Sequence[int], avoid: Sequence[fmpq_mpoly] = ()
) -> Iterator[Assignment]:
    """Points where no radicand is negative, and nothing vanishes that is to be avoided.

    A step changes the one coordinate with which the fewest conditions are left that fail.
    """

    def failing(values: Assignment) -> int:
        negative = sum(constant(one, values) < 0 for one in radicands)
        return negative + sum(constant(one, values) == 0 for one in avoid)

    for sequence in islice(small_numbers(), STARTS):
        values = {place: next(sequence) for place in variables}
        left = failing(values)
        while left:
            steps = ({**values, place: value} for place in variables for value in VALUES)
            best = min(((failing(one), k, one) for k, one in enumerate(steps)), key=lambda s: s[:2])
            if best[0] >= left:
                break
            left, values = best[0], best[2]
        if not left:
            yield values
