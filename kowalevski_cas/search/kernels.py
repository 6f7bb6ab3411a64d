"""Kernels of large sparse matrices over the rationals, by one modulo a large prime."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any

from flint import nmod_mat

PRIME = 2**61 - 1

Column = Mapping[Any, Fraction]


def kernel(columns: Sequence[Column]) -> list[list[Fraction]]:
    """A basis of the combinations of columns that vanish, as far as it can be lifted.

    The rank is that modulo a prime of 61 bits, which is at most the true one; what is lifted is
    checked over the rationals, so that every vector is right and at most as many are missing
    as the prime has made too many.
    """
    if not columns:
        return []
    places: dict[Any, int] = {}
    for column in columns:
        for key in column:
            places.setdefault(key, len(places))
    width = len(columns)
    entries = [0] * (max(len(places), 1) * width)
    for k, column in enumerate(columns):
        for key, value in column.items():
            residue = value.numerator * pow(value.denominator, -1, PRIME) % PRIME
            entries[places[key] * width + k] = residue
    reduced, rank = nmod_mat(max(len(places), 1), width, entries, PRIME).rref()
    pivots = _pivots(reduced, int(rank))
    found = []
    for free in (k for k in range(width) if k not in pivots):
        vector = [Fraction(0)] * width
        vector[free] = Fraction(1)
        lifted = [_lifted(-int(reduced[row, free]) % PRIME) for row in range(len(pivots))]
        for pivot, value in zip(pivots, lifted, strict=True):
            vector[pivot] = value
        if _vanishes(vector, columns):
            found.append(vector)
    return found


def _pivots(reduced: nmod_mat, rank: int) -> list[int]:
    pivots: list[int] = []
    column = 0
    for row in range(rank):
        while int(reduced[row, column]) == 0:
            column += 1
        pivots.append(column)
    return pivots


def _lifted(residue: int) -> Fraction:
    """The rational number with small numerator and denominator that has this residue."""
    bound = isqrt(PRIME // 2)
    a, b, u, v = PRIME, residue, 0, 1
    while b > bound:
        quotient = a // b
        a, b, u, v = b, a - quotient * b, v, u - quotient * v
    return Fraction(b, v)


def _vanishes(vector: Sequence[Fraction], columns: Sequence[Column]) -> bool:
    total: dict[Any, Fraction] = {}
    for factor, column in zip(vector, columns, strict=True):
        if factor:
            for key, value in column.items():
                total[key] = total.get(key, Fraction(0)) + factor * value
    return not any(total.values())
