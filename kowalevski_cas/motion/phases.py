r"""Phases at any time: w = rate·(t − origin) modulo 4, to the last bit for every float t.

The rate is a sum of floats, as many as the largest time needs; each product with t is split
into two floats without error (Dekker), and whole periods are taken off exactly. So the error
of the phase does not grow with t.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TypeVar

import numpy as np
from flint import arb

from kowalevski_cas.motion.arrays import Array

Split = TypeVar("Split", float, Array)

GUARD = 60
"""Bits of the phase behind the point."""

LARGEST = 1e290
"""Beyond it the splitting of t overflows."""


def parts_needed(rate: float, largest: float) -> int:
    """How many floats the rate must consist of, for times up to ``largest``."""
    turns = max(rate * max(largest, 1.0), 1.0)
    return int(np.ceil((np.log2(turns) + GUARD) / 53))


def expansion(rest: Fraction, parts: int) -> list[float]:
    """A number as a sum of so many floats, the largest first."""
    found = []
    for _ in range(parts):
        part = float(rest)
        found.append(part)
        rest -= Fraction(part)
    return found


def as_fraction(value: arb) -> Fraction:
    """The middle of a ball, exactly."""
    mantissa, exponent = (int(part) for part in value.mid().man_exp())
    return Fraction(mantissa << exponent) if exponent >= 0 else Fraction(mantissa, 1 << -exponent)


class Phase:
    """The phase in quarters of a period: the nearest quarter, and what is left."""

    def __init__(self, rate: arb, offset: arb, parts: int) -> None:
        self._rate = [(part, *_halves(part)) for part in expansion(as_fraction(rate), parts)]
        whole = as_fraction(offset)
        whole -= 4 * round(whole / 4)
        self._offset = expansion(whole, 2)

    def __call__(self, t: Array) -> tuple[Array, Array]:
        """For times t: j in {−2, …, 2} and y in [−½, ½] with w = j + y modulo 4."""
        t_high, t_low = _halves(t)
        total = np.full_like(t, self._offset[0])
        low = np.full_like(t, self._offset[1])
        for part, high_half, low_half in self._rate:
            product = t * part
            error = t_high * high_half - product
            error += t_high * low_half
            error += t_low * high_half
            error += t_low * low_half
            product -= 4.0 * np.rint(product * 0.25)
            error -= 4.0 * np.rint(error * 0.25)
            before = total
            total = before + product
            other = total - before
            low += ((before - (total - other)) + (product - other)) + error
        total -= 4.0 * np.rint(total * 0.25)
        quarter = np.rint(total + low)
        total -= quarter
        total += low
        quarter -= 4.0 * np.rint(quarter * 0.25)
        return quarter, total


def _halves(x: Split) -> tuple[Split, Split]:
    """A float, or an array of them, as the sum of two with 26 bits each (Veltkamp)."""
    shifted = 134217729.0 * x
    high = shifted - (shifted - x)
    return high, x - high
