"""Hermite's count of real roots, from power sums and a Hankel matrix."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.algebra.linear import determinant
from kowalevski_cas.algebra.tower import Element


def hermite_minors(coefficients: Sequence[Element]) -> list[Element]:
    r"""The leading principal minors of the matrix of power sums :math:`(s_{i+j})`.

    ``coefficients`` are those of a monic polynomial of degree n, the constant one
    first, without the leading one. All n roots are real and distinct exactly if
    all n minors are positive (Hermite; the last minor is the discriminant).
    """
    ring = coefficients[0].ring
    size = len(coefficients)
    sums = [ring.number(size)]
    # Newton's identities
    for k in range(1, 2 * size - 1):
        total = ring.number(-k) * coefficients[size - k] if k <= size else ring.zero
        for j in range(max(1, k - size), k):
            total = total - coefficients[size - k + j] * sums[j]
        sums.append(total)
    matrix = [[sums[i + j] for j in range(size)] for i in range(size)]
    return [determinant([row[:k] for row in matrix[:k]]) for k in range(1, size + 1)]
