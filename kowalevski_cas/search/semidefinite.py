"""Positive matrices whose entries obey linear equations, in floats, by Clarabel."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isqrt
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Matrix = NDArray[np.float64]

SINGULAR, SIMPLE = 1e-3, 1e-2
"""What is taken for a zero, and for a small rational number."""

LARGEST = 12
"""The largest denominator of a vector on which a matrix vanishes."""

Row = dict[int, Fraction]
Vectors = list[list[Fraction]]


class SemidefiniteProgram(NamedTuple):
    """Linear equations for unknowns, of which some are the entries of positive matrices.

    ``entries`` has the unknowns of each matrix, by columns of its upper triangle.
    """

    unknowns: int
    rows: Sequence[Row]
    right: Sequence[Fraction]
    entries: Sequence[Sequence[int]]

    def solve(self, zeros: Sequence[Vectors]) -> tuple[list[float], float] | None:
        """The unknowns, where the matrices are as positive as can be off the vectors of zeros.

        The number says how positive: if it is negative, there is no solution.
        """
        import clarabel
        import numpy as np
        from scipy import sparse

        margin, height = self.unknowns, len(self.rows)
        data = [(k, own, float(v)) for k, row in enumerate(self.rows) for own, v in row.items()]
        free = [*map(float, self.right)]
        cones: list[Any] = [clarabel.ZeroConeT(height), clarabel.NonnegativeConeT(1)]
        data.append((height, margin, 1.0))
        free.append(1.0)
        for entries, vectors in zip(self.entries, zeros, strict=True):
            size = _size(entries)
            away = _projector(size, vectors)
            places = ((i, j) for j in range(size) for i in range(j + 1))
            for (i, j), unknown in zip(places, entries, strict=True):
                scale = 1.0 if i == j else 2**0.5  # Clarabel's inner product is that of matrices
                data.append((len(free), unknown, -scale))
                data.append((len(free), margin, scale * away[i, j]))
                free.append(0.0)
            cones.append(clarabel.PSDTriangleConeT(size))
        at, by, values = zip(*data, strict=True)
        matrix = sparse.csc_matrix((values, (at, by)), shape=(len(free), margin + 1))
        cost = np.zeros(margin + 1)
        cost[margin] = -1
        settings = clarabel.DefaultSettings()
        settings.verbose = False
        settings.max_threads = 1  # its threads would not survive a fork, and be waited for
        nothing = sparse.csc_matrix((margin + 1, margin + 1))
        solver = clarabel.DefaultSolver(nothing, cost, matrix, np.array(free), cones, settings)
        try:
            solution = solver.solve()
        except BaseException as error:  # a panic of Clarabel, where an eigenvalue does not converge
            if type(error).__name__ != "PanicException":
                raise
            return None
        if str(solution.status) not in ("Solved", "AlmostSolved"):
            return None
        return solution.x[:margin], solution.x[margin]

    def zeros(self, values: Sequence[float], known: Sequence[Vectors]) -> list[Vectors]:
        """The vectors on which each matrix vanishes, where there are more than are known."""
        import numpy as np

        matrices = []
        for entries in self.entries:
            size = _size(entries)
            matrix = np.zeros((size, size))
            above = [(i, j) for j in range(size) for i in range(j + 1)]
            for (i, j), unknown in zip(above, entries, strict=True):
                matrix[i, j] = matrix[j, i] = values[unknown]
            matrices.append(matrix)
        largest = max((np.abs(one).max(initial=0) for one in matrices), default=1.0)
        found = []
        for matrix, before in zip(matrices, known, strict=True):
            own, vectors = np.linalg.eigh(matrix)
            new = [*_rational_rows(vectors[:, own < SINGULAR * largest].T)]
            found.append(new if len(new) > len(before) else [*before])
        return found


def _size(entries: Sequence[int]) -> int:
    """The size of a matrix by the number of entries above its diagonal and on it."""
    return (isqrt(8 * len(entries) + 1) - 1) // 2


def _projector(size: int, vectors: Vectors) -> Matrix:
    """The orthogonal projection along vectors."""
    import numpy as np

    if not vectors:
        return np.eye(size)
    basis, _ = np.linalg.qr(np.array([[float(v) for v in one] for one in vectors]).T)
    projector: Matrix = np.eye(size) - basis @ basis.T
    return projector


def _rational_rows(rows: Matrix) -> Iterator[list[Fraction]]:
    """The reduced echelon form of a matrix, in small rational numbers; none if it is not near."""
    import numpy as np

    rows = rows.copy()
    done: list[int] = []
    for k in range(len(rows)):
        free = [j for j in range(rows.shape[1]) if j not in done]
        place = max(free, key=lambda j: float(np.abs(rows[k:, j]).max()))
        best = k + int(np.abs(rows[k:, place]).argmax())
        rows[[k, best]] = rows[[best, k]]
        rows[k] /= rows[k, place]
        for other in range(len(rows)):
            if other != k:
                rows[other] -= rows[other, place] * rows[k]
        done.append(place)
    small = [[Fraction(float(v)).limit_denominator(LARGEST) for v in row] for row in rows]
    pairs = (
        (a, b) for row, own in zip(small, rows, strict=True) for a, b in zip(row, own, strict=True)
    )
    if all(abs(float(a) - b) < SIMPLE for a, b in pairs):
        yield from small
