"""Homogeneous linear equations in whole numbers, as weights of variables obey them."""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd


def whole_solutions(rows: Sequence[Sequence[int]], width: int) -> list[tuple[int, ...]]:
    """A basis of the whole solutions of homogeneous linear equations, as short as can be."""
    if not rows:
        return [tuple(int(j == k) for j in range(width)) for k in range(width)]
    from flint import fmpz_mat  # claims are read without a library

    matrix = fmpz_mat([list(row) for row in rows])
    basis, rank = matrix.nullspace()
    columns = [[int(basis[i, j]) for i in range(width)] for j in range(int(rank))]
    if not columns:
        return []
    whole = fmpz_mat([[v // gcd(*column) for v in column] for column in columns])
    return [tuple(int(v) for v in row) for row in whole.lll().tolist()]
