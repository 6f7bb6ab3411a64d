"""Weights of variables under which given polynomials are homogeneous."""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd

from flint import fmpz_mat

from kowalevski_cas.algebra.polynomials import Terms


def weights(polynomials: Sequence[Terms]) -> tuple[int, ...] | None:
    """The smallest positive integers that do it, if they are unique up to a factor.

    >>> from fractions import Fraction
    >>> one = Fraction(1)
    >>> weights([{(2, 0): one, (0, 1): one}])
    (1, 2)
    """
    rows = []
    for terms in polynomials:
        first, *others = terms
        rows += [[a - b for a, b in zip(first, other, strict=True)] for other in others]
    if not rows:
        return None
    space, nullity = fmpz_mat(rows).nullspace()
    if nullity != 1:
        return None
    found = [int(space[k, 0]) for k in range(len(rows[0]))]
    size = gcd(*found) * (1 if found[0] > 0 else -1)
    result = tuple(weight // size for weight in found)
    return result if all(weight > 0 for weight in result) else None
