"""Combinations by Gröbner bases: each element remembers how it was made (Buchberger).

Where there are unknowns, the generators are of degree 0 or 1 in them, and so is what is combined
from them. So pairs whose S-polynomial would be of degree 2 are left out: this is a basis of a
module. Other programs are a few times faster (the study has a chart) and do not tell how an element
was made, which is the evidence.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from heapq import heapify, heappop, heappush
from itertools import combinations, combinations_with_replacement
from math import prod
from operator import sub
from typing import Any, TypeVar

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx, fmpz_mpoly_ctx, fmpz_mpoly_vec

from kowalevski_cas.algebra.flat import Flat
from kowalevski_cas.algebra.flint import terms_of, to_flint
from kowalevski_cas.algebra.kernels import TooLarge, kernel
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.polynomial_fields import primitive
from kowalevski_cas.search.cofactors import cofactors

LONGEST = 500_000
"""How many terms are reduced to make a basis, before it is given up."""

LIMITS = (500, 10_000, 50_000)
"""Elements, terms of one and bits of a number with which a basis is given up that nobody made."""

POWERS = 3
"""The largest power of a unit by which a target is multiplied."""

LARGEST_DEGREE = 2
"""The largest degree of what is divided by where nothing else is found."""

Monomial = tuple[int, ...]
Made = dict[int, fmpq_mpoly]
"""How a polynomial is combined from elements of a basis, by their places."""

Row = TypeVar("Row")


class Basis:
    """A Gröbner basis of polynomials that are linear in the variables at some places."""

    def __init__(self, generators: Sequence[fmpq_mpoly], linear: Sequence[int]) -> None:
        self.context = generators[0].context()
        self.linear = linear
        self.count = len(generators)
        self.elements: list[fmpq_mpoly] = []
        self.leads: list[Monomial] = []
        self.made: list[Made] = []
        self._kept: list[int] = []
        """The places of elements whose leads no later one divides."""
        self._pairs: list[tuple[int, int, int, Monomial]] = []
        for k, generator in enumerate(generators):
            self._enter(generator, {k: self.context.constant(1)})
        self._steps = 0
        """The terms that were reduced so far."""
        while self._pairs and self._steps <= LONGEST:
            _, i, j, _ = heappop(self._pairs)
            rest, made = self._reduced(*self._pair(i, j))
            if not rest.is_zero():
                self._enter(rest, made)

    def cofactors(self, target: fmpq_mpoly) -> list[fmpq_mpoly] | None:
        """The combination of the generators that a polynomial is, if it is one."""
        rest, made = self._reduced(target, {})
        if not rest.is_zero():
            return None
        zero = self.context.constant(0)
        row = [-made.get(k, zero) for k in range(len(self.elements))]
        for k in reversed(range(self.count, len(self.elements))):
            for place, factor in self.made[k].items():
                row[place] += row[k] * factor
        return row[: self.count]

    @property
    def kept(self) -> list[fmpq_mpoly]:
        """The elements whose leading monomials no later one divides."""
        return [self.elements[k] for k in self._kept]

    def reduced(self) -> list[fmpq_mpoly]:
        """A basis in which no monomial is divisible by the leading one of another element."""
        found = self.kept
        for k, own in enumerate(found):
            found[k] = remainder(own, (*found[:k], *found[k + 1 :]))
        return [one for one in found if one]

    def _enter(self, polynomial: fmpq_mpoly, made: Made) -> None:
        """Add an element, with the pairs that are needed (Gebauer and Möller)."""
        place, lead = len(self.elements), _lead(polynomial)
        self.elements.append(polynomial)
        self.leads.append(lead)
        self.made.append(made)
        known = [(k, _lcm(lead, self.leads[k])) for k in self._kept]
        new = [(k, lcm) for k, lcm in known if sum(lcm[n] for n in self.linear) < 2]
        reached = dict(known)
        self._pairs = [
            (degree, i, j, lcm)
            for degree, i, j, lcm in self._pairs
            if not _divides(lead, lcm)
            or lcm in (_lcm(lead, self.leads[i]), _lcm(lead, self.leads[j]))
        ]
        heapify(self._pairs)
        least: dict[Monomial, int] = {}
        for k, lcm in sorted(new, key=lambda pair: sum(pair[1])):
            if lcm in least:
                if self._apart(lead, k):
                    least[lcm] = k
            elif not any(_divides(other, lcm) for other in least):
                least[lcm] = k
        for lcm, k in least.items():
            if not self._apart(lead, k):
                heappush(self._pairs, (sum(lcm), k, place, lcm))
        self._kept = [k for k in self._kept if reached[k] != self.leads[k]] + [place]

    def _apart(self, lead: Monomial, k: int) -> bool:
        """Whether a lead has no variable in common with that of an element."""
        return not any(a and b for a, b in zip(lead, self.leads[k], strict=True))

    def _pair(self, i: int, j: int) -> tuple[fmpq_mpoly, Made]:
        """The S-polynomial of two elements, and how it is made."""
        common = _lcm(self.leads[i], self.leads[j])
        first, second = (
            self.context.from_dict({tuple(map(sub, common, self.leads[k])): 1})
            / self.elements[k].leading_coefficient()
            for k in (i, j)
        )
        return first * self.elements[i] - second * self.elements[j], {i: first, j: -second}

    def _reduced(self, rest: fmpq_mpoly, made: Made) -> tuple[fmpq_mpoly, Made]:
        """What is left of a polynomial when leading terms are reduced, and how it is made."""
        made = dict(made)
        while not rest.is_zero():
            lead = _lead(rest)
            place = next((k for k in self._kept if _divides(self.leads[k], lead)), None)
            if place is None:
                break
            factor, rest = divmod(rest, self.elements[place])
            self._steps += len(factor) * len(self.elements[place]) + len(rest)
            made[place] = made.get(place, self.context.constant(0)) - factor
        return rest, made


def reduced_basis(polynomials: Sequence[fmpq_mpoly]) -> list[fmpq_mpoly]:
    """The reduced Gröbner basis of polynomials, where nobody asks how it is made.

    Raises:
        TooLarge: there are too many elements or terms on the way, or too large numbers.
    """
    context = polynomials[0].context()
    whole = fmpz_mpoly_ctx.get(context.names(), context.ordering())
    given = (primitive(terms_of(one)) for one in polynomials if one)
    own = [whole.from_dict({e: int(value) for e, value in terms.items()}) for terms in given]
    answer: Any = fmpz_mpoly_vec(own, whole).buchberger_naive(LIMITS)  # its type leaves limits out
    found, complete = answer
    if not complete:
        raise TooLarge("a Gröbner basis has over {} elements, {} terms or {} bits".format(*LIMITS))
    rational = (context.from_dict(one.to_dict()) for one in found.autoreduction(groebner=True))
    return [one / one.leading_coefficient() for one in rational]


def remainder(polynomial: fmpq_mpoly, divisors: Sequence[fmpq_mpoly]) -> fmpq_mpoly:
    """What is left of a polynomial when no leading monomial of a divisor divides one of it."""
    before = None
    while before != polynomial:
        before = polynomial
        for divisor in filter(None, divisors):
            polynomial = divmod(polynomial, divisor)[1]
    return polynomial


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
        known = [*map(self._graded, generators)]
        divisors = [*map(self._graded, (*units, *conditions))]
        units_at = {
            k for unit in divisors[: len(units)] if len(unit) == 1 for k in _variables(unit)
        }
        for place, radicand in zip(reversed(range(flat.roots)), ring.radicands, strict=True):
            if len(shown := self._graded(radicand)) == 1 and units_at.issuperset(_variables(shown)):
                units_at.add(place)
        self.kept = [k for k, polynomial in enumerate(known) if not polynomial.is_zero()]
        self.contents = [_content(known[k], units_at) for k in self.kept]
        polynomials = (*known, *divisors, *map(self._graded, targets))
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

    def reduced(self) -> list[Element]:
        """The elements of the reduced basis."""
        found = [] if self.basis is None else self.basis.reduced()
        return [self.flat.element(_in(self.flat.context, one)) for one in found]

    def row(self, target: Element) -> list[Element] | None:
        """The row for an element."""
        if self.basis is None:
            return None
        flat, one = self.flat, self.ring.one
        for factors in _multiples(self.units, self.conditions):
            row = self.basis.cofactors(self._graded(prod((target, *factors), start=one)))
            if row is not None:
                over = (factor.inverse() for factor in factors)
                return self._entries(row, prod(over, start=flat.below(target)))
        return None

    def divided(self, target: Element) -> list[Element] | None:
        """The row that divides by a polynomial of the least degree for which there is one.

        It is no combination of the generators, for that would vanish wherever these do; so a number
        has no such row.
        """
        own, flat = self._graded(target), self.flat
        if self.basis is None or own.is_constant():
            return None
        basis, one = self.basis.kept, self.context.constant(1)
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
                    return self._entries(row, over * flat.below(target))
        return None

    def _entries(self, row: Sequence[fmpq_mpoly], below: Element) -> list[Element]:
        """The elements of a row of polynomials, which is divided by something."""
        flat, entries = self.flat, [self.ring.zero] * len(self.generators)
        for place, content, polynomial in zip(self.kept, self.contents, row, strict=False):
            over = flat.below(self.generators[place]) * flat.element(_in(flat.context, content))
            entry = flat.element(_in(flat.context, polynomial))
            entries[place] = entry * below * over.inverse()
        return entries

    def _graded(self, element: Element) -> fmpq_mpoly:
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


def expressed(
    target: Element, generators: Sequence[Element], main: Sequence[tuple[str, ...]] = ()
) -> list[Element] | None:
    """Cofactors of a target without a condition, or in main variables, or with the least one."""
    if (row := cofactors(target, generators)) is not None or len(generators) == 1:
        return row or cofactors(target, generators, main)
    made = combinations_of([target], generators)
    return made.row(target) or cofactors(target, generators, main) or made.divided(target)


def combinations_of(targets: Sequence[Element], generators: Sequence[Element]) -> Combinations:
    """Combinations whose units are denominators, and roots that are factors of a generator."""
    ring = targets[0].ring
    contents = (Flat(ring).without_roots(one)[0] for one in generators)
    roots = [content for content in contents if content.parts.keys() != {0}]
    units = [*roots, *ring.divided_by([*targets, *generators])]
    return Combinations(targets, generators, units=units)


def vanish_on(elements: Sequence[Element], known: Sequence[Element]) -> list[bool]:
    """Which elements are combinations of known ones, without a condition."""
    given = [one for one in known if not one.is_zero]
    if not elements or not given:
        return [element.is_zero for element in elements]
    flat = Flat(given[0].ring)
    context = fmpq_mpoly_ctx.get(flat.context.names(), Ordering.deglex)
    relations = (*map(flat.polynomial, given), *flat.relations())
    try:
        basis = reduced_basis([_in(context, one) for one in relations])
    except TooLarge:
        return [False] * len(elements)
    dividends = (_in(context, flat.polynomial(element)) for element in elements)
    return [remainder(dividend, basis).is_zero() for dividend in dividends]


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


def _lead(polynomial: fmpq_mpoly) -> Monomial:
    return tuple(map(int, polynomial.monomial(0)))


def _lcm(one: Monomial, other: Monomial) -> Monomial:
    return tuple(map(max, one, other))


def _divides(one: Monomial, other: Monomial) -> bool:
    return all(a <= b for a, b in zip(one, other, strict=True))
