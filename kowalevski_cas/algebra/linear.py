"""Linear systems and determinants over a tower of roots."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.algebra.tower import Element


class Singular(ArithmeticError):
    """A linear system without a unique solution."""


Matrix = Sequence[Sequence[Element]]


def solve(matrix: Matrix, right: Matrix) -> list[list[Element]]:
    """The X with A X = B for a square matrix A, by elimination; raises :class:`Singular`.

    What a zero was divided by is kept, as by any operation of the tower.
    """
    rows = [[*row, *values] for row, values in zip(matrix, right, strict=True)]
    for column in range(len(rows)):
        pivot = next((row for row in rows[column:] if not row[column].is_zero), None)
        if pivot is None:
            raise Singular("the linear system has no unique solution")
        rows.remove(pivot)
        factor = pivot[column].inverse()
        pivot = [entry * factor for entry in pivot]
        rows = [
            row
            if row[column].is_zero
            else [
                a if b.is_zero and not b.denominator else a - row[column] * b
                for a, b in zip(row, pivot, strict=True)
            ]
            for row in rows
        ]
        rows.insert(column, pivot)
    return [row[len(rows) :] for row in rows]


def inverse(matrix: Matrix) -> list[list[Element]]:
    """The inverse of a square matrix; raises :class:`Singular` if there is none."""
    zero, element, size = matrix[0][0].ring.zero, matrix[0][0].ring.one, range(len(matrix))
    return solve(matrix, [[element if j == k else zero for k in size] for j in size])


def determinant(matrix: Matrix) -> Element:
    """The determinant of a small matrix, by expansion along the first row."""
    # elimination would divide, and what is divided by becomes a condition
    first, *rest = matrix
    if not rest:
        return first[0]
    total = first[0].ring.zero
    if any(all((a - b).is_zero for a, b in zip(first, row, strict=True)) for row in rest):
        return total
    for column, entry in enumerate(first):
        if not entry.is_zero:
            minor = determinant([[*row[:column], *row[column + 1 :]] for row in rest])
            product = entry * minor
            total = total - product if column % 2 else total + product
    return total
