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

from flint import fmpq_mpoly, fmpq_mpoly_ctx

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
    context, polynomials = target.context(), (target, *generators)
    degrees = [one.degrees() for one in polynomials]
    places = [k for k in range(context.nvars()) if any(own[k] for own in degrees)]
    goal, *terms = (
        {tuple(m[k] for k in places): value for m, value in terms_of(one).items()}
        for one in polynomials
    )
    weights = gradings([one for one in (goal, *terms) if one])
    blocks: dict[tuple[int, ...], list[Monomial]] = {}
    for size in range(degree + 1):
        for chosen in combinations_with_replacement(range(len(places)), size):
            monomial = tuple(map(chosen.count, range(len(places))))
            grade = tuple(sum(w * e for w, e in zip(one, monomial, strict=True)) for one in weights)
            blocks.setdefault(grade, []).append(monomial)
        for block in blocks.values():
            if sum(block[-1]) < size:
                continue
            for found in _combinations(goal, terms, block):
                unit, *cofactors = (_spread(context, places, one) for one in found)
                if not size or combination(unit, generators) is None:
                    return unit, cofactors
    return None


def _spread(context: fmpq_mpoly_ctx, places: Sequence[int], terms: Terms) -> fmpq_mpoly:
    """A polynomial by its terms in the variables at some places."""
    where = {k: n for n, k in enumerate(places)}
    own = {
        tuple(m[where[k]] if k in where else 0 for k in range(context.nvars())): value
        for m, value in terms.items()
    }
    return polynomial_of(context, own)


def _combinations(
    goal: Terms, terms: Sequence[Terms], block: Sequence[Monomial]
) -> Iterator[list[Terms]]:
    """Units with monomials of a block, each with the cofactors of the multiple of the target."""
    multiples = [_multiple(goal, monomial) for monomial in block]
    start = list(dict.fromkeys(monomial for one in multiples for monomial in one))
    columns = _columns(start, terms) or _columns(start, terms, max(map(sum, start)))
    if columns is None:
        return
    size = len(columns)
    for solution in _relations([_multiple(terms[k], m) for k, m in columns], multiples):
        parts: list[Terms] = [{} for _ in terms]
        for (k, monomial), value in zip(columns, solution[:size], strict=True):
            parts[k][monomial] = -value
        yield [dict(zip(block, solution[size:], strict=True)), *parts]


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
