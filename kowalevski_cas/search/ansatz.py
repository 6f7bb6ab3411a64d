"""Cofactors by linear algebra, for what no division finds: all monomials that can occur.

A combination of the generators has to cancel every monomial that is not in the target. So the
monomials of the cofactors are sought from those of the target: each is brought in by a term of
a generator, and brings in the others of that generator. If weights of the variables make all of
them homogeneous this ends; otherwise there are soon too many.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from flint import fmpq, fmpq_mpoly, nmod_mat

from kowalevski_cas.algebra.polynomials import Terms

Monomial = tuple[int, ...]
Column = tuple[int, Monomial]
"""A generator, and a monomial of its cofactor."""

PRIME = 2**61 - 1

MOST = 600
"""How many unknown coefficients are solved for."""


def combination(target: fmpq_mpoly, generators: Sequence[fmpq_mpoly]) -> list[fmpq_mpoly] | None:
    """Polynomials c with ``target`` = sum of c[k] ``generators[k]``; ``None`` if none is found."""
    goal, terms = _terms(target), [_terms(generator) for generator in generators]
    columns = _columns(goal, terms)
    if columns is None:
        return None
    found: list[dict[Monomial, fmpq]] = [{} for _ in generators]
    for (k, monomial), value in _solved(goal, terms, columns):
        found[k][monomial] = fmpq(value.numerator, value.denominator)
    context = target.context()
    cofactors = [context.from_dict(part) for part in found]
    total = context.constant(0)
    for cofactor, generator in zip(cofactors, generators, strict=True):
        total += cofactor * generator
    return cofactors if total == target else None


def _columns(target: Terms, generators: Sequence[Terms]) -> list[Column] | None:
    """The unknowns; ``None`` if there are too many."""
    columns: dict[Column, None] = {}
    waiting, seen = [*target], {*target}
    while waiting:
        row = waiting.pop(0)
        for k, generator in enumerate(generators):
            for term in generator:
                monomial = tuple(a - b for a, b in zip(row, term, strict=True))
                if min(monomial) < 0 or (k, monomial) in columns:
                    continue
                columns[k, monomial] = None
                if len(columns) > MOST:
                    return None
                more = [_times(monomial, other) for other in generator]
                waiting += [m for m in more if m not in seen]
                seen.update(more)
    return [*columns]


def _solved(
    target: Terms, generators: Sequence[Terms], columns: Sequence[Column]
) -> Iterator[tuple[Column, Fraction]]:
    """The coefficients that are not zero, if there are any that fit modulo a prime."""
    rows: dict[Monomial, int] = {monomial: j for j, monomial in enumerate(target)}
    entries = []
    for place, (k, monomial) in enumerate(columns):
        for term, value in generators[k].items():
            row = rows.setdefault(_times(monomial, term), len(rows))
            entries.append((row, place, _residue(value)))
    last = len(columns)
    matrix = nmod_mat(len(rows), last + 1, PRIME)
    for row, place, residue in entries:
        matrix[row, place] = residue
    for monomial, value in target.items():
        matrix[rows[monomial], last] = _residue(value)
    reduced, rank = matrix.rref()
    pivot = 0
    for row in range(rank):
        while not int(reduced[row, pivot]):
            pivot += 1
        residue = int(reduced[row, last])
        if pivot < last and residue:
            yield columns[pivot], _rational(residue)


def _times(one: Monomial, other: Monomial) -> Monomial:
    return tuple(a + b for a, b in zip(one, other, strict=True))


def _terms(polynomial: fmpq_mpoly) -> Terms:
    return {
        tuple(map(int, exponents)): Fraction(int(value.p), int(value.q))
        for exponents, value in polynomial.to_dict().items()
    }


def _residue(value: Fraction) -> int:
    return value.numerator * pow(value.denominator, -1, PRIME) % PRIME


def _rational(residue: int) -> Fraction:
    """The fraction with small numerator and denominator that has this residue."""
    above, below, high, low = residue, 1, PRIME, 0
    while 2 * above * above > PRIME:
        quotient = high // above
        high, above, low, below = above, high - quotient * above, below, low - quotient * below
    return Fraction(above, below)
