"""Combinations with coefficients that are not negative, in rational numbers."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from flint import fmpq_mat

from kowalevski_cas.algebra.flint import to_flint, to_fraction

Vector = Sequence[Fraction]


def combination_in_cone(vectors: Sequence[Vector], target: Vector) -> list[Fraction] | None:
    """The coefficients of a vector as a combination of others, none negative; or no list.

    That combination is the nearest one (Lawson and Hanson, Solving Least Squares Problems, 1974,
    chapter 23).

    >>> one, zero = Fraction(1), Fraction(0)
    >>> combination_in_cone([(one, zero), (one, one)], (2 * one, one))
    [Fraction(1, 1), Fraction(1, 1)]
    >>> combination_in_cone([(one, zero), (one, one)], (zero, one))
    """
    weights, used = [Fraction(0)] * len(vectors), list[int]()
    while True:
        rest = [*target]
        for k in used:
            rest = [one - weights[k] * other for one, other in zip(rest, vectors[k], strict=True)]
        if not any(rest):
            return weights
        gains = {k: _dot(vector, rest) for k, vector in enumerate(vectors) if k not in used}
        best = max(gains, key=gains.__getitem__, default=None)
        if best is None or gains[best] <= 0:
            return None
        used.append(best)
        while True:
            own = [vectors[k] for k in used]
            gram = fmpq_mat([[to_flint(_dot(one, other)) for other in own] for one in own])
            column = gram.solve(fmpq_mat([[to_flint(_dot(one, target))] for one in own]))
            nearest = [to_fraction(column[k, 0]) for k in range(len(used))]
            wrong = [(k, value) for k, value in zip(used, nearest, strict=True) if value <= 0]
            step = min((weights[k] / (weights[k] - v) for k, v in wrong), default=Fraction(1))
            for k, value in zip(used, nearest, strict=True):
                weights[k] += step * (value - weights[k])
            if not wrong:
                break
            used = [k for k in used if weights[k] > 0]


def _dot(one: Vector, other: Vector) -> Fraction:
    return sum((a * b for a, b in zip(one, other, strict=True)), Fraction(0))
