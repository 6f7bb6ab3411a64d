"""Kernels of sparse matrices over the rational numbers, by those modulo a large prime."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any, TypeVar

from flint import fmpq_mat

from kowalevski_cas.algebra.elimination import PRIME, Echelon, relations
from kowalevski_cas.algebra.flint import to_flint, to_fraction

Column = Mapping[Any, Fraction]
Key = TypeVar("Key")


def residue(value: Fraction) -> int:
    """The residue of a number; raises ``ZeroDivisionError`` if it has none."""
    if value.denominator % PRIME == 0:
        raise ZeroDivisionError("the prime divides a denominator")
    return value.numerator * pow(value.denominator, -1, PRIME) % PRIME


def kernel(columns: Sequence[Column]) -> list[list[Fraction]]:
    """A basis of the combinations of columns that vanish, as far as it can be lifted.

    The rank is that modulo a prime of 61 bits, which is at most the true one; what is lifted is
    checked over the rationals, so that every vector is right and at most as many are missing
    as the prime has made too many.
    """
    vectors = []
    for relation in relations([{k: residue(v) for k, v in c.items()} for c in columns]):
        lifted = lift(relation)
        if _vanishes(lifted, columns):
            vectors.append([lifted.get(k, Fraction(0)) for k in range(len(columns))])
    return vectors


def rank(vectors: Iterable[Column]) -> int:
    """The rank modulo the prime, which is at most the true one."""
    found = Echelon()
    for vector in vectors:
        found.extend({key: residue(value) for key, value in vector.items()})
    return len(found)


def coordinates(vectors: Sequence[Column], keys: Sequence[Key]) -> list[dict[Key, Fraction]]:
    """Linear forms f_j in entries, with v = Σ f_j(v) v_j for each v that is a sum of the vectors.

    A vector that is a sum of others may have no form.
    """
    size = len(vectors)
    rows = [
        [*(to_flint(v.get(key, 0)) for key in keys), *(to_flint(int(j == k)) for k in range(size))]
        for j, v in enumerate(vectors)
    ]
    reduced, _ = fmpq_mat(rows).rref()
    forms: list[dict[Key, Fraction]] = [{} for _ in vectors]
    for row in range(size):
        for pivot in (key for k, key in enumerate(keys) if reduced[row, k]):
            for j, form in enumerate(forms):
                if value := to_fraction(reduced[row, len(keys) + j]):
                    form[pivot] = value
            break
    return forms


def lift(relation: Mapping[Key, int]) -> dict[Key, Fraction]:
    """The rational numbers of the smallest height that have these residues."""
    return {k: _rational_reconstruction(value) for k, value in relation.items()}


def _rational_reconstruction(residue: int) -> Fraction:
    """The rational number with small numerator and denominator that has this residue."""
    # with numerator and denominator below this there is one such number at most (P. S. Wang, 1981)
    bound = isqrt(PRIME // 2)
    a, b, u, v = PRIME, residue, 0, 1
    while b > bound:
        quotient = a // b
        a, b, u, v = b, a - quotient * b, v, u - quotient * v
    return Fraction(b, v)


def _vanishes(combination: Mapping[int, Fraction], columns: Sequence[Column]) -> bool:
    total: dict[Any, Fraction] = {}
    for k, factor in combination.items():
        for key, value in columns[k].items():
            total[key] = total.get(key, Fraction(0)) + factor * value
    return not any(total.values())
