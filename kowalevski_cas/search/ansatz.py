"""Cofactors by linear algebra, for what no division finds: all monomials that can occur.

A combination of the generators has to cancel every monomial that is not in the target. So the
monomials of the cofactors are sought from those of the target: each is brought in by a term of
a generator, and brings in the others of that generator. If weights of the variables make all of
them homogeneous this ends; otherwise there may soon be too many, and only those are taken that
lead to no higher degree.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import polynomial_of, terms_of
from kowalevski_cas.algebra.kernels import kernel
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.weights import gradings

Monomial = tuple[int, ...]
Column = tuple[int, Monomial]
"""A generator, and a monomial of its cofactor."""

Combination = tuple[fmpq_mpoly, list[fmpq_mpoly]]
"""A polynomial u and cofactors c: u times the target is the sum of c[k] times generator k."""


MOST = 600
"""How many unknown coefficients are solved for."""


def combination(target: fmpq_mpoly, generators: Sequence[fmpq_mpoly]) -> list[fmpq_mpoly] | None:
    """Polynomials c with ``target`` = sum of c[k] ``generators[k]``; ``None`` if none is found."""
    found = multiple(target, generators, 0)
    return None if found is None else [c / found[0].leading_coefficient() for c in found[1]]


def multiple(
    target: fmpq_mpoly, generators: Sequence[fmpq_mpoly], degree: int
) -> Combination | None:
    """The multiple of the target by a polynomial u that is a combination of generators.

    The degree of u is the least for which one is found, and at most ``degree``. No u is itself
    a combination of the generators: it would vanish wherever these do.
    """
    polynomials = [terms for one in (target, *generators) if (terms := terms_of(one))]
    weights = gradings(polynomials)
    context = target.context()
    places = [k for k in range(context.nvars()) if any(m[k] for p in polynomials for m in p)]
    blocks: dict[tuple[int, ...], list[Monomial]] = {}
    for size in range(degree + 1):
        for chosen in combinations_with_replacement(places, size):
            monomial = tuple(map(chosen.count, range(context.nvars())))
            grade = tuple(sum(w * e for w, e in zip(one, monomial, strict=True)) for one in weights)
            blocks.setdefault(grade, []).append(monomial)
        for block in blocks.values():
            if sum(block[-1]) < size:
                continue
            for unit, cofactors in _combinations(target, generators, block):
                if not size or combination(unit, generators) is None:
                    return unit, cofactors
    return None


def _combinations(
    target: fmpq_mpoly, generators: Sequence[fmpq_mpoly], block: Sequence[Monomial]
) -> Iterator[Combination]:
    """Those in which the target is multiplied by terms with monomials of a block."""
    goal, terms = terms_of(target), [terms_of(generator) for generator in generators]
    multiples = [_multiple(goal, monomial) for monomial in block]
    start = list(dict.fromkeys(monomial for one in multiples for monomial in one))
    columns = _columns(start, terms) or _columns(start, terms, max(map(sum, start)))
    if columns is None:
        return
    context, size = target.context(), len(columns)
    for solution in _relations([_multiple(terms[k], m) for k, m in columns], multiples):
        unit = polynomial_of(context, dict(zip(block, solution[size:], strict=True)))
        parts: list[Terms] = [{} for _ in generators]
        for (k, monomial), value in zip(columns, solution[:size], strict=True):
            parts[k][monomial] = -value
        yield unit, [polynomial_of(context, part) for part in parts]


def _columns(
    start: Sequence[Monomial], generators: Sequence[Terms], degree: int | None = None
) -> list[Column] | None:
    """The unknowns, for terms up to a degree if one is given; ``None`` if there are too many."""
    columns: dict[Column, None] = {}
    waiting, seen = [*start], {*start}
    while waiting:
        row = waiting.pop(0)
        for k, generator in enumerate(generators):
            for term in generator:
                monomial = tuple(a - b for a, b in zip(row, term, strict=True))
                if min(monomial) < 0 or (k, monomial) in columns:
                    continue
                more = [_times(monomial, other) for other in generator]
                if degree is not None and max(map(sum, more)) > degree:
                    continue
                columns[k, monomial] = None
                if len(columns) > MOST:
                    return None
                waiting += [m for m in more if m not in seen]
                seen.update(more)
    return [*columns]


def _relations(known: Sequence[Terms], new: Sequence[Terms]) -> list[list[Fraction]]:
    """Each of the new polynomials that depends on those before it, as a relation of all of them.

    It is given by the coefficients of all polynomials, the new ones after the known ones.
    """
    found = (one for one in kernel([*known, *new]) if any(one[len(known) :]))
    return sorted(found, key=lambda one: max(place for place, value in enumerate(one) if value))


def _multiple(terms: Terms, by: Monomial) -> Terms:
    return {_times(by, monomial): value for monomial, value in terms.items()}


def _times(one: Monomial, other: Monomial) -> Monomial:
    return tuple(a + b for a, b in zip(one, other, strict=True))
