"""Combinations of elements by Gröbner bases, and what they divide by."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, combinations_with_replacement
from math import prod
from typing import TypeVar

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.flat import Flat
from kowalevski_cas.algebra.flint import terms_of, to_flint
from kowalevski_cas.algebra.ideals import remainder
from kowalevski_cas.algebra.kernels import kernel
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.search.cofactors import cofactors
from kowalevski_cas.search.groebner import Basis

POWERS = 3
"""The largest power of a unit by which a target is multiplied."""

LARGEST_DEGREE = 2
"""The largest degree of what is divided by where nothing else is found."""

Row = TypeVar("Row")


class Combinations:
    """Rows of elements that combine targets from generators; a basis is made of these once.

    Where there are ``unknowns``, all are linear in them. Each row divides by powers of the
    ``units``, and by as few of the ``conditions`` as possible.
    """

    def __init__(
        self,
        targets: Sequence[Element],
        generators: Sequence[Element],
        unknowns: Sequence[str] = (),
        units: Sequence[Element] = (),
        conditions: Sequence[Element] = (),
    ) -> None:
        self.generators = generators
        self.units, self.conditions = units, conditions
        self.ring = ring = targets[0].ring
        self.flat = flat = Flat(ring)
        self.context = fmpq_mpoly_ctx.get(flat.context.names(), Ordering.deglex)
        known = [*map(self._grade, generators)]
        divisors = [*map(self._grade, (*units, *conditions))]
        units_at = {
            k for unit in divisors[: len(units)] if len(unit) == 1 for k in _variables(unit)
        }
        for place, radicand in zip(reversed(range(flat.roots)), ring.radicands, strict=True):
            if len(shown := self._grade(radicand)) == 1 and units_at.issuperset(_variables(shown)):
                units_at.add(place)
        self.kept = [k for k, polynomial in enumerate(known) if not polynomial.is_zero()]
        self.contents = [_content(known[k], units_at) for k in self.kept]
        polynomials = (*known, *divisors, *map(self._grade, targets))
        used = {k for polynomial in polynomials for k in _variables(polynomial)}
        relations = [
            _in(self.context, relation)
            for place, relation in zip(range(flat.roots), flat.relations(), strict=True)
            if place in used
        ]
        primitive = [known[k] / c for k, c in zip(self.kept, self.contents, strict=True)]
        self.basis = Basis([*primitive, *relations], flat.indices(unknowns)) if primitive else None

    def rows(self, targets: Sequence[Element], power: int = 1) -> list[list[Element]] | None:
        """The rows for powers of targets, or ``None`` if one is not found."""
        return complete(self.row(target**power) for target in targets)

    def reduced_basis(self) -> list[Element]:
        """The elements of the reduced basis."""
        found = [] if self.basis is None else self.basis.interreduce()
        return [self.flat.element(_in(self.flat.context, row)) for row in found]

    def row(self, target: Element) -> list[Element] | None:
        """The row for an element."""
        if self.basis is None:
            return None
        flat, one = self.flat, self.ring.one
        for factors in _multiples(self.units, self.conditions):
            whole = prod((target, *factors), start=one)  # a unit may be a fraction, too
            row = self.basis.cofactors(self._grade(whole))
            if row is not None:
                over = (factor.inverse() for factor in factors)
                return self._entries(row, prod(over, start=flat.inverse_denominator(whole)))
        return None

    def division_row(self, target: Element) -> list[Element] | None:
        """The row that divides by a polynomial of the least degree for which there is one.

        It is no combination of the generators, for that would vanish wherever these do; so a number
        has no such row.
        """
        own, flat = self._grade(target), self.flat
        if self.basis is None or own.is_constant():
            return None
        basis, one = self.basis.minimal_elements, self.context.constant(1)
        used = {k for polynomial in (*basis, own) for k in _variables(polynomial)}
        names = [one, *(self.context.gens()[k] for k in sorted(used))]
        for degree in range(1, LARGEST_DEGREE + 1):
            monomials = [prod(some) for some in combinations_with_replacement(names, degree)]
            for vector in kernel([terms_of(remainder(m * own, basis)) for m in monomials]):
                unit = self.context.constant(0)
                for value, monomial in zip(vector, monomials, strict=True):
                    unit += monomial * to_flint(value)
                row = self.basis.cofactors(unit * own) if remainder(unit, basis) else None
                if row is not None:
                    over = flat.inverse(_in(flat.context, unit))
                    return self._entries(row, over * flat.inverse_denominator(target))
        return None

    def _entries(self, row: Sequence[fmpq_mpoly], below: Element) -> list[Element]:
        """The elements of a row of polynomials, which is divided by something."""
        flat, entries = self.flat, [self.ring.zero] * len(self.generators)
        for place, content, polynomial in zip(self.kept, self.contents, row, strict=False):
            over = flat.inverse_denominator(self.generators[place]) * flat.element(
                _in(flat.context, content)
            )
            entry = flat.element(_in(flat.context, polynomial))
            entries[place] = entry * below * over.inverse()
        return entries

    def _grade(self, element: Element) -> fmpq_mpoly:
        """A numerator, with the roots as variables."""
        return _in(self.context, self.flat.polynomial(element))


def complete(rows: Iterable[Row | None]) -> list[Row] | None:
    """All rows; ``None`` as soon as one is missing."""
    found = []
    for row in rows:
        if row is None:
            return None
        found.append(row)
    return found


def cofactors_for(
    target: Element, generators: Sequence[Element], main: Sequence[tuple[str, ...]] = ()
) -> list[Element] | None:
    """Cofactors of a target without a condition, or in main variables, or with the least one."""
    if (row := cofactors(target, generators)) is not None or len(generators) == 1:
        return row or cofactors(target, generators, main)
    made = combinations_of([target], generators)
    return made.row(target) or cofactors(target, generators, main) or made.division_row(target)


def combinations_of(targets: Sequence[Element], generators: Sequence[Element]) -> Combinations:
    """Combinations whose units are denominators, and roots that are factors of a generator."""
    ring = targets[0].ring
    contents = (Flat(ring).without_roots(generator)[0] for generator in generators)
    roots = [content for content in contents if content.parts.keys() != {0}]
    units = [*roots, *ring.divisors_of([*targets, *generators])]
    return Combinations(targets, generators, units=units)


def _content(polynomial: fmpq_mpoly, places: set[int]) -> fmpq_mpoly:
    """The largest monomial in the variables at some places that divides a polynomial."""
    least = map(min, zip(*polynomial.monoms(), strict=True))
    exponents = tuple(int(e) if k in places else 0 for k, e in enumerate(least))
    return polynomial.context().from_dict({exponents: 1})


def _multiples(
    units: Sequence[Element], conditions: Sequence[Element]
) -> Iterator[tuple[Element, ...]]:
    """What targets are multiplied by, in turn: few conditions first, then low powers."""
    for size in range(len(conditions) + 1):
        for chosen in combinations(conditions, size):
            for power in range(POWERS + 1 if units or chosen else 1):
                if power or not chosen:
                    yield (*units, *chosen) * power


def _variables(polynomial: fmpq_mpoly) -> Iterator[int]:
    """The places of the variables that occur."""
    return (place for place, degree in enumerate(polynomial.degrees()) if degree)


def _in(context: fmpq_mpoly_ctx, polynomial: fmpq_mpoly) -> fmpq_mpoly:
    return context.from_dict(polynomial.to_dict())
