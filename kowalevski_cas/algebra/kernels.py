"""Ranks and kernels of large sparse matrices over the rationals, by those modulo a large prime."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any

from flint import nmod_mat

from kowalevski_cas.pool import HERE, Pool

PRIME = 2**61 - 1

LARGEST = 40_000_000
"""The largest number of entries of a matrix: it takes about a gigabyte."""

Column = Mapping[Any, Fraction]


class TooLarge(ValueError):
    """A matrix that would take too much memory; the message says how large it is."""


def residue(value: Fraction) -> int:
    """The residue of a number; raises ``ZeroDivisionError`` if it has none."""
    if value.denominator % PRIME == 0:
        raise ZeroDivisionError("the prime divides a denominator")
    return value.numerator * pow(value.denominator, -1, PRIME) % PRIME


def rank(columns: Sequence[Mapping[Any, int]], pool: Pool = HERE) -> int:
    """The rank of columns of residues."""
    blocks = ([columns[k] for k in block] for block in _blocks(columns))
    return sum(pool.map(_rank, blocks))


def kernel(columns: Sequence[Column]) -> list[list[Fraction]]:
    """A basis of the combinations of columns that vanish, as far as it can be lifted.

    The rank is that modulo a prime of 61 bits, which is at most the true one; what is lifted is
    checked over the rationals, so that every vector is right and at most as many are missing
    as the prime has made too many.
    """
    found = []
    for block in _blocks(columns):
        own = [columns[k] for k in block]
        for part in _kernel(own):
            vector = [Fraction(0)] * len(columns)
            for k, value in zip(block, part, strict=True):
                vector[k] = value
            found.append(vector)
    return found


def _blocks(columns: Sequence[Mapping[Any, object]]) -> list[list[int]]:
    """The places of columns, in groups of which no two have a row in common."""
    root: dict[Hashable, Hashable] = {}

    def top(one: Hashable) -> Hashable:
        while root[one] != one:
            root[one] = one = root[root[one]]
        return one

    for k, column in enumerate(columns):
        own = ("column", k)
        root[own] = own
        for row in column:
            root[top(root.setdefault(row, row))] = top(own)
    groups: dict[Hashable, list[int]] = {}
    for k in range(len(columns)):
        groups.setdefault(top(("column", k)), []).append(k)
    return [*groups.values()]


def _matrix(columns: Sequence[Mapping[Any, int]]) -> nmod_mat:
    places: dict[Any, int] = {}
    for column in columns:
        for key in column:
            places.setdefault(key, len(places))
    width, height = len(columns), max(1, len(places))
    if height * width > LARGEST:
        raise TooLarge(f"a matrix has {height} rows and {width} columns")
    entries = [0] * (height * width)
    for k, column in enumerate(columns):
        for key, value in column.items():
            entries[places[key] * width + k] = value
    return nmod_mat(height, width, entries, PRIME)


def _rank(columns: Sequence[Mapping[Any, int]]) -> int:
    return int(_matrix(columns).rank())


def _kernel(columns: Sequence[Column]) -> list[list[Fraction]]:
    width = len(columns)
    reduced, rank = _matrix([{k: residue(v) for k, v in c.items()} for c in columns]).rref()
    pivots = _pivots(reduced, int(rank))
    found = []
    for free in (k for k in range(width) if k not in pivots):
        vector = [Fraction(0)] * width
        vector[free] = Fraction(1)
        lifted = [
            _rational_reconstruction(-int(reduced[row, free]) % PRIME) for row in range(len(pivots))
        ]
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
        column += 1
    return pivots


def _rational_reconstruction(residue: int) -> Fraction:
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
