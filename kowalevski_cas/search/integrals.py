"""Polynomial first integrals of a polynomial vector field, up to a degree or a weight."""

from __future__ import annotations

from bisect import bisect
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import chain, islice, takewhile
from operator import mul
from random import Random

from kowalevski_cas.algebra.elimination import PRIME, Echelon, relations
from kowalevski_cas.algebra.kernels import lift
from kowalevski_cas.algebra.polynomials import TooLarge, primitive
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.kernel import LARGEST
from kowalevski_cas.problem.polynomial_fields import (
    Exponents,
    PolynomialField,
    Terms,
    derivative,
    monomials,
    number_of_monomials,
    weight_of,
)
from kowalevski_cas.problem.residues import (
    ResidueField,
    Residues,
    Weighted,
    pack,
    products,
    remember_dimension,
)

CONSTANTS = 6
"""The largest degree of coefficients in the constants."""

GROWTH = 4
"""So many times as many monomials has a stage of the search as the one before."""


def first_integrals(
    at: Evaluation,
    weight: int,
    weights: Sequence[int] = (),
    pool: Pool = HERE,
    cofactor: Element | None = None,
    integrals: Sequence[Element] = (),
) -> Iterator[Element]:
    """Polynomials in the variables that do not move, the lightest first.

    Those that are polynomials in the ones before them, with coefficients that depend on the
    constants, are left out. If there is a ``cofactor`` K, they are the polynomials F with F′ = KF
    instead, without the combinations of those before by polynomials in the ``integrals``.

    Args:
        at: the evaluation of a space, with FLINT.
        weight: the largest weight of a polynomial.
        weights: the positive weights of the variables; all are 1, and the weight is the degree,
            if none are given.
        pool: where the linear algebra is done, block by block.
        cofactor: K.
        integrals: first integrals, for the combinations that are left out.

    Raises:
        Meaningless: if a root stands in the equations of motion.
        TooLarge: if what comes next takes too much memory.
    """
    field = PolynomialField(at, cofactor)
    search = _IntegralSearch(field, weights or (1,) * len(at.setting.variables), pool)
    if cofactor is not None:
        search.factors = [field.polynomial(integral) for integral in integrals]
    for terms in search.up_to(weight, first=int(cofactor is None)):
        yield search.field.element(terms)


class _IntegralSearch:
    """Integrals found so far, in a field."""

    def __init__(self, field: PolynomialField, weights: Sequence[int], pool: Pool) -> None:
        self.field, self.weights, self.pool = field, weights, pool
        self.known: list[Terms] = []
        self.factors = self.known
        """What known ones are multiplied by: integrals by each other."""
        self.others = len(field.names) - field.size
        random = Random(1)
        values = [random.randrange(PRIME) for _ in range(self.others)]
        self.residues = ResidueField(field.rates, field.factor, values)
        self.groups: dict[Exponents, Group] = defaultdict(list)
        """Monomials in the variables by their weights, which the motion keeps together."""
        self.solutions: dict[Exponents, list[Combination]] = defaultdict(list)
        """Modulo the prime."""
        self.span = Echelon()
        """The polynomials in known integrals, up to the weight at which new ones are looked for."""

    def up_to(self, weight: int, first: int) -> Iterator[Terms]:
        """Integrals with terms up to a weight that are no polynomials in the known ones."""
        solved, constants = self._solve_in_stages(first, weight), first
        for size in range(first, weight + 1):
            if (number := number_of_monomials(self.weights, size)) > LARGEST:
                raise TooLarge(f"{number} monomials have the weight {size} or less")
            for grade, (group, solutions) in next(solved).items():
                self.groups[grade] += group
                self.solutions[grade] += solutions
            yield from self._new(size)
        dimension = sum(map(len, self.solutions.values())) + constants
        remember_dimension(self.residues, self.weights, weight, dimension)

    def _new(self, weight: int) -> Iterator[Terms]:
        """Those of them that the solutions up to a weight give."""
        dimension = sum(map(len, self.solutions.values()))
        self.span = self._span(weight)
        candidates = self._candidates(number_of_monomials(self.weights, weight))
        while len(self.span) < dimension and (terms := next(candidates, None)):
            if self.span.extend(self.residues.residues(terms)):
                self.known.append(primitive(terms))
                yield self.known[-1]
                self.span = self._span(weight)

    def _solve_in_stages(self, first: int, last: int) -> Iterator[Solved]:
        """The monomials of each weight and the solutions that end there, by their grades.

        What a group of monomials gives up to a weight is the beginning of what it gives up to a
        larger one: several weights are solved at once, or one by one if that is too large.
        """
        for stage in _stages(self.weights, last):
            try:
                for solved in self._solve(first, stage):
                    yield solved
                    first += 1
            except TooLarge:
                for weight in range(first, stage + 1):
                    yield from self._solve(weight, weight)
            first = stage + 1

    def _solve(self, first: int, last: int) -> Iterator[Solved]:
        """The same for the weights of a stage, each as soon as its groups are solved."""
        by_weight: list[dict[Exponents, Group]] = []
        groups = {grade: [*group] for grade, group in self.groups.items()}
        for weight in range(first, last + 1):
            by_weight.append({})
            for exponents in monomials(self.weights, weight):
                grade = tuple(sum(map(mul, w, exponents)) for w in self.field.weights)
                by_weight[-1].setdefault(grade, []).append(exponents)
                groups.setdefault(grade, []).append(exponents)
        solved: dict[Exponents, list[Combination]] = {}
        waiting = self._solve_groups(by_weight, groups)
        for weight, own in enumerate(by_weight, first):
            solved.update(islice(waiting, len(own.keys() - solved)))
            yield {
                grade: (group, [s for s in solved[grade] if self._weight_of(s) == weight])
                for grade, group in own.items()
            }

    def _weight_of(self, solution: Combination) -> int:
        """The weight of the heaviest monomial of a combination, which comes first."""
        return sum(map(mul, self.weights, next(iter(solution))))

    def _solve_groups(
        self, by_weight: Iterable[Collection[Exponents]], groups: Mapping[Exponents, Group]
    ) -> Iterator[tuple[Exponents, list[Combination]]]:
        """The solutions for grades: those that come first by weights, of these the largest."""
        order: dict[Exponents, None] = {}
        for grades in by_weight:
            new = [grade for grade in grades if grade not in order]
            order.update(dict.fromkeys(sorted(new, key=lambda grade: -len(groups[grade]))))
        work = partial(_combinations, self.residues)
        return zip(order, self.pool.map(work, [groups[g] for g in order]), strict=True)

    def _candidates(self, size: int) -> Iterator[Terms]:
        """Integrals with coefficients of each degree in the constants, the shortest first."""
        if not self.others:
            rates, factor = self.field.rates, self.field.factor
            found = sorted(chain.from_iterable(self.solutions.values()), key=_size)
            new = (solution for solution in found if not self.span.has(_packed(solution)))
            yield from (terms for solution in new if (terms := _lift(solution, rates, factor)))
            return
        for degree in range(CONSTANTS + 1):
            if size * (degree + 1) <= LARGEST:
                yield from sorted(self._kernel(degree), key=_size)

    def _kernel(self, degree: int) -> Iterator[Terms]:
        """A basis of the integrals with coefficients of some degree in the constants."""
        groups: dict[Exponents, list[Exponents]] = defaultdict(list)
        ones = (1,) * self.others
        constants = [e for size in range(degree + 1) for e in monomials(ones, size)]
        for own in chain.from_iterable(self.groups.values()):
            for powers in constants:
                groups[self.field.grade((*own, *powers))].append((*own, *powers))
        work = partial(_solutions, self.field.rates, self.field.factor)
        return chain.from_iterable(self.pool.map(work, groups.values()))

    def _span(self, weight: int) -> Echelon:
        """The polynomials in known integrals, up to a weight and but for constants."""
        of_integrals = self.factors is self.known
        integrals = [self._weigh(f) for f in self.factors]
        left = [(0, {0: 1})] if of_integrals else [self._weigh(f) for f in self.known]
        found = chain.from_iterable(products(f, integrals, weight) for f in left)
        span = Echelon()
        for product in islice(found, of_integrals, None):
            span.extend(product)
        return span

    def _weigh(self, terms: Terms) -> Weighted:
        return weight_of(terms, self.weights), self.residues.residues(terms)


Group = list[Exponents]
"""Monomials in the variables."""

Combination = dict[Exponents, int]
"""A polynomial modulo the prime."""

Solved = dict[Exponents, tuple[Group, list[Combination]]]
"""Monomials of a weight, and the solutions of which they are the heaviest, by their grades."""


def _stages(weights: Sequence[int], last: int) -> list[int]:
    """Weights up to which is solved at once, of which the next has many more monomials."""
    sizes = (number_of_monomials(weights, weight) for weight in range(last + 1))
    numbers = [*takewhile(LARGEST.__ge__, sizes)]
    stages = [len(numbers) - 1]
    while stages[-1] > 0:
        stages.append(max(bisect(numbers, numbers[stages[-1]] // GROWTH, hi=stages[-1]) - 1, 0))
    return stages[::-1]


def _combinations(field: ResidueField, group: Sequence[Exponents]) -> list[Combination]:
    """A basis of the combinations of monomials that the motion multiplies by the factor.

    In each the last monomials of the group come first.
    """
    found = relations([field.derivative(exponents) for exponents in group])
    return [{group[k]: relation[k] for k in sorted(relation, reverse=True)} for relation in found]


def _solutions(rates: Sequence[Terms], factor: Terms, group: Sequence[Exponents]) -> list[Terms]:
    """Those over the rational numbers, of monomials in the variables and the constants."""
    found = _combinations(ResidueField(rates, factor), group)
    return [terms for solution in found if (terms := _lift(solution, rates, factor))]


def _lift(found: Combination, rates: Sequence[Terms], factor: Terms) -> Terms | None:
    """The polynomial with small coefficients, if the motion multiplies it by the factor."""
    terms, total = lift(found), defaultdict[Exponents, Fraction](Fraction)
    for exponents, value in terms.items():
        for other, rate in derivative(exponents, rates, factor).items():
            total[other] += value * rate
    return None if any(total.values()) else terms


def _packed(found: Combination) -> Residues:
    return {pack(exponents): value for exponents, value in found.items()}


def _size(terms: Mapping[Exponents, object]) -> tuple[int, int]:
    return max(map(sum, terms)), len(terms)
