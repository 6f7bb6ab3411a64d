"""Weights of variables under which given polynomials are homogeneous."""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd

from flint import fmpz_mat

from kowalevski_cas.algebra.polynomials import Terms


def gradings(polynomials: Sequence[Terms]) -> list[tuple[int, ...]]:
    """A basis of the weights, of any sign, for which all polynomials are homogeneous.

    >>> from fractions import Fraction
    >>> one = Fraction(1)
    >>> ((a, b),) = gradings([{(2, 0): one, (0, 1): one}])
    >>> b == 2 * a
    True
    """
    rows = []
    for terms in polynomials:
        first, *others = terms
        rows += [[a - b for a, b in zip(first, other, strict=True)] for other in others]
    return whole_solutions(rows, len(first))


def whole_solutions(rows: Sequence[Sequence[int]], width: int) -> list[tuple[int, ...]]:
    """A basis of the whole solutions of homogeneous linear equations, as short as can be."""
    if not rows:
        return [tuple(int(j == k) for j in range(width)) for k in range(width)]
    matrix = fmpz_mat([list(row) for row in rows])
    basis, rank = matrix.nullspace()
    columns = [[int(basis[i, j]) for i in range(width)] for j in range(int(rank))]
    if not columns:
        return []
    whole = fmpz_mat([[v // gcd(*column) for v in column] for column in columns])
    return [tuple(int(v) for v in row) for row in whole.lll().tolist()]
