"""Whether a number vanishes to the last digit of what it is computed from."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

import numpy as np

SHARES = [way * Fraction(1, 2**bits) for bits in (0, 10, 20, 30) for way in (1, -1)]
"""The shares of a step that are tried one after the other: a whole one may lead out of a regime."""

Function = Callable[[Sequence[Fraction]], float | None]
"""A number by some given ones, or None where there is none to compare."""


def last_digits(given: Sequence[Fraction]) -> list[Fraction]:
    """By how much the floats beside these numbers differ from them."""
    return [Fraction(float(np.spacing(abs(float(x))))) for x in given]


def vanishes(function: Function, given: Sequence[Fraction], steps: Sequence[Fraction]) -> bool:
    """Whether the number is not more than all that it changes by, a step in each of the given.

    So it is zero for given numbers that differ by no more than their rounding, to first order.

    >>> def line(at): return float(at[0] - at[1] / 3)
    >>> given = [Fraction(1 / 3), Fraction(1)]
    >>> vanishes(line, given, last_digits(given))
    True
    >>> vanishes(line, [Fraction(1 / 3 + 1e-14), Fraction(1)], last_digits(given))
    False
    """
    here, change = function(given), 0.0
    if here is None:
        return False
    for place, step in enumerate(steps):
        for share in SHARES:
            there = function([x + (k == place) * share * step for k, x in enumerate(given)])
            if there is not None:
                change += abs((there - here) / float(share))
                break
    return abs(here) <= change
