"""F′ = KF for polynomials F and K with unknown coefficients, as equations for these.

All that stands here is plain data, so that equations are made where they are solved.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from operator import add, mul
from random import Random

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpz

from kowalevski_cas.algebra.flint import polynomial_of
from kowalevski_cas.problem.polynomial_fields import Exponents, Terms, derivative, monomials
from kowalevski_cas.search.branches import (
    Branch,
    Solved,
    branches,
    maximal,
    reduce_solutions,
    replace_solved,
)

SMALLEST, LARGEST = 10**3, 10**4
"""Between these are the numbers that stand for constants in general position."""


@dataclass(frozen=True)
class Ansatze:
    """The ansatz for each leading monomial of F.

    Args:
        rates: the components of the motion, in the variables and then the constants.
        constants: their names.
        gradings: the weights of the variables for which F is homogeneous.
        cofactors: the monomials of K.
        granted: polynomials in the constants that are not zero.
        special: whether the constants are unknowns as well.
    """

    rates: tuple[Terms, ...]
    constants: tuple[str, ...]
    gradings: tuple[Exponents, ...]
    cofactors: tuple[Exponents, ...]
    granted: tuple[Terms, ...]
    special: bool

    def of(self, leading: Exponents) -> Ansatz:
        """The ansatz with a leading monomial."""
        return Ansatz(self, [leading, *self._below(leading)])

    def solve(self, leading: Exponents) -> list[Branch]:
        """The cases in which the equations of an ansatz hold: a task for a pool.

        If the constants are in general position, they are numbers first: what is zero there is zero
        for all of them, and few unknowns are left.
        """
        ansatz = self.of(leading)
        granted = tuple(ansatz.in_constants(terms) for terms in self.granted)
        levels = ansatz.equations()
        if self.special:
            return [*branches(chain.from_iterable(levels), ansatz.places, granted)]
        if not self.constants:
            return ansatz.rational_cases(levels, granted)
        found: list[Branch] = []
        for zeros in ansatz.zeros(levels):
            found += ansatz.rational_cases([zeros, *levels], granted)
        return [*maximal(found)]

    def _below(self, leading: Exponents) -> Iterator[Exponents]:
        """The monomials before another one that have the same weights."""
        same = self._grade(leading)
        for degree in range(sum(leading) + 1):
            for exponents in monomials((1,) * len(self.rates), degree):
                before = (degree, exponents) < (sum(leading), leading)
                if before and self._grade(exponents) == same:
                    yield exponents

    def _grade(self, exponents: Exponents) -> list[int]:
        return [sum(map(mul, weights, exponents)) for weights in self.gradings]


class Ansatz:
    """The coefficients of F and K as unknowns, in the names c, k, and those of the constants."""

    def __init__(self, ansatze: Ansatze, powers: Sequence[Exponents]) -> None:
        self.rates, self.size = ansatze.rates, len(ansatze.rates)
        self.monomials, self.cofactors = powers, ansatze.cofactors
        self.unknowns = len(powers) - 1 + len(self.cofactors)
        self.width = self.unknowns + len(ansatze.constants)
        names = [*(f":{k}" for k in range(self.unknowns)), *ansatze.constants]
        self.context = fmpq_mpoly_ctx.get(names, Ordering.degrevlex)
        self.places = [*range(self.unknowns), *reversed(range(self.unknowns, self.width))]

    def in_constants(self, terms: Terms) -> fmpq_mpoly:
        """A polynomial in the constants."""
        before = (0,) * self.unknowns
        return polynomial_of(
            self.context, {(*before, *e[self.size :]): v for e, v in terms.items()}
        )

    def equations(self) -> list[list[fmpq_mpoly]]:
        """The coefficients of F′ − KF by degrees, those of the highest first."""
        found: dict[Exponents, dict[Exponents, Fraction]] = {}
        size, others = self.size, (0,) * (self.width - self.unknowns)
        for place, own in enumerate(self.monomials, -1):
            for exponents, value in derivative((*own, *others), self.rates, {}).items():
                key = (*self._product(place)[: self.unknowns], *exponents[size:])
                terms = found.setdefault(exponents[:size], {})
                terms[key] = terms[key] + value if key in terms else value
            for k, factor in enumerate(self.cofactors, len(self.monomials) - 1):
                terms = found.setdefault(tuple(map(add, own, factor)), {})
                terms[self._product(place, k)] = Fraction(-1)
        levels: dict[int, list[fmpq_mpoly]] = {}
        for exponents in sorted(found, key=lambda e: (sum(e), e), reverse=True):
            equation = polynomial_of(self.context, found[exponents])
            levels.setdefault(sum(exponents), []).append(equation)
        return [*levels.values()]

    def rational_cases(
        self, levels: Sequence[Sequence[fmpq_mpoly]], granted: tuple[fmpq_mpoly, ...]
    ) -> list[Branch]:
        """The cases in which unknowns are rational functions of the constants.

        The equations of the highest degree are solved first, so that others are left early.
        """
        start, places = Branch((), (), granted), self.places[: self.unknowns]
        return [*maximal([*_rational_cases(levels, places, start)])]

    def zeros(self, levels: Sequence[Sequence[fmpq_mpoly]]) -> list[list[fmpq_mpoly]]:
        """The unknowns that are zero in each case, where the constants are certain numbers."""
        random = Random(1)
        names = [self.context.name(place) for place in range(self.unknowns, self.width)]
        numbers: dict[str | int, int | fmpz | fmpq] = {
            name: random.randrange(SMALLEST, LARGEST) for name in names
        }
        there = [[equation.subs(numbers) for equation in level] for level in levels]
        cases = self.rational_cases(there, ())
        if any(case.rest for case in cases):  # all equations at once may leave none
            every = chain.from_iterable(there)
            cases = [*cases, *branches(every, self.places[: self.unknowns])]
        solved = chain.from_iterable(map(_separate, cases))
        found = (tuple(place for place, equation in case if len(equation) == 1) for case in solved)
        return [[self.context.gen(place) for place in zero] for zero in dict.fromkeys(found)]

    def _product(self, *places: int) -> Exponents:
        """The monomial of unknowns at different places; at −1 there is the coefficient 1."""
        exponents = [0] * self.width
        for place in places:
            if place >= 0:
                exponents[place] = 1
        return tuple(exponents)


def _separate(case: Branch) -> Iterator[Solved]:
    """What a case with numbers says of all unknowns; two that are left have to be rational."""
    if not case.rest:
        yield case.solved
        return
    degrees = [map(int, equation.degrees()) for equation in case.rest]
    left = [place for place, column in enumerate(zip(*degrees, strict=True)) if any(column)]
    if len(left) != 2 or len(case.rest) < 2:
        return
    one, other, *_ = sorted(case.rest, key=len)
    eliminant = one.resultant(other, one.context().name(left[0]))
    for branch in branches([eliminant, *case.rest], left, case.nonzero):
        if not branch.rest:
            yield reduce_solutions((*case.solved, *branch.solved))


def _rational_cases(
    levels: Sequence[Sequence[fmpq_mpoly]], places: Sequence[int], before: Branch
) -> Iterator[Branch]:
    """The cases of a case, if those of the first equations are separated before all others.

    Where an equation is left in which one unknown stands alone, that is no rational function.
    """
    for equation in before.rest:
        degrees = equation.degrees()
        if sum(degrees[place] > 0 for place in places) == 1:
            return
    if not levels:
        yield Branch(reduce_solutions(before.solved), before.rest, before.nonzero)
        return
    replaced = (replace_solved(equation, before.solved) for equation in levels[0])
    for branch in branches([*replaced, *before.rest], places, before.nonzero):
        solved = {place for place, _ in branch.solved}
        rest = [place for place in places if place not in solved]
        both = Branch((*before.solved, *branch.solved), branch.rest, branch.nonzero)
        yield from _rational_cases(levels[1:], rest, both)
