"""Darboux polynomials: polynomials F with F′ = KF, where neither F nor K is known.

The coefficients of both are unknowns of quadratic equations. If a leading monomial of F has the
coefficient 1, some equation is linear as a rule; else one splits into factors (:mod:`branches`).
Weights of the variables leave few monomials for K: in no weight is it heavier than the motion. If
the motion is homogeneous, so is K, and the parts of F are Darboux polynomials: F is homogeneous.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product, tee
from random import Random

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.elimination import PRIME, Echelon, TooLarge
from kowalevski_cas.algebra.flint import polynomial_of, terms_of
from kowalevski_cas.algebra.polynomials import primitive
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.polynomial_fields import (
    Exponents,
    PolynomialField,
    Terms,
    monomials,
    number_of_monomials,
)
from kowalevski_cas.problem.residues import ResidueField, Residues, product_of, unpack
from kowalevski_cas.search.branches import Branch, solve_by_cases

LARGEST = 500
"""The largest number of unknown coefficients."""


@dataclass(frozen=True)
class Darboux:
    """A polynomial F with F′ = KF where the equations for constants hold, by both sides."""

    polynomial: Element
    cofactor: Element
    equations: tuple[tuple[Element, Element], ...] = ()


def darboux_polynomials(
    at: Evaluation, degree: int, special: bool = False, pool: Pool = HERE
) -> Iterator[Darboux]:
    """Real Darboux polynomials up to a degree, the lowest first.

    They do not split over the rational numbers, and combinations of products of those before are
    left out; so are those whose coefficients are no rational functions of the constants.

    Args:
        at: the evaluation of a space, with FLINT.
        degree: the largest degree of a polynomial.
        special: whether the constants may have special values; else they are in general position.
        pool: where the equations are solved, those of a leading monomial by themselves.

    Raises:
        Meaningless: the motion is no polynomial in the variables.
        TooLarge: what comes next has too many unknowns.
    """
    search = _DarbouxSearch(at, special)
    ansatze, waiting = tee(search.ansatze(degree))
    found = pool.map(solve_by_cases, map(search.task, waiting))
    for cases, ansatz in zip(found, ansatze, strict=True):
        yield from search.new(ansatz, cases)


class _DarbouxSearch:
    """Darboux polynomials found so far, in a field."""

    def __init__(self, at: Evaluation, special: bool) -> None:
        self.at, self.field, self.special = at, PolynomialField(at), special
        self.field.polynomial(self.field.multiple.inverse())  # else variables stand below
        self.found: list[Darboux] = []
        self.cofactors = [*_lighter(self.field)]
        self.gradings = self.field.weights

    def ansatze(self, degree: int) -> Iterator[_Ansatz]:
        """One for each leading monomial, by degree and then in the order of the variables."""
        for size in range(1, degree + 1):
            if (count := number_of_monomials((1,) * self.field.size, size)) > LARGEST:
                raise TooLarge(f"{count} unknown coefficients up to degree {size}")
            for leading in monomials((1,) * self.field.size, size):
                yield _Ansatz(self.field, self._below(leading), self.cofactors)

    def task(self, ansatz: _Ansatz) -> tuple[list[fmpq_mpoly], list[int], list[fmpq_mpoly]]:
        """The equations of an ansatz, with the places of their unknowns, and what is not zero."""
        places = ansatz.places if self.special else ansatz.places[: ansatz.unknowns]
        granted = [self.field.polynomial(e) for e in self.at.granted if self._is_constant(e)]
        return ansatz.equations(), places, [ansatz.in_constants(terms) for terms in granted]

    def new(self, ansatz: _Ansatz, cases: Iterable[Branch]) -> Iterator[Darboux]:
        """What the solutions of its equations give besides what was found before."""
        for branch in cases:
            solution = None if branch.rest else ansatz.solution(branch)
            one = None if solution is None else self._irreducible(solution)
            if one is not None and self._is_new(one):
                self.found.append(one)
                yield one

    def _below(self, leading: Exponents) -> list[Exponents]:
        """A monomial, and those below it with the same weights."""
        size = (1,) * self.field.size
        lower = (e for degree in range(sum(leading) + 1) for e in monomials(size, degree))
        same = [_weight(w, leading) for w in self.gradings]
        others = (e for e in lower if [_weight(w, e) for w in self.gradings] == same)
        return [leading, *(e for e in others if (sum(e), e) < (sum(leading), leading))]

    def _is_constant(self, element: Element) -> bool:
        """Whether no variable and no root stands in an element."""
        if element.parts.keys() - {0} or element.denominator:
            return False
        return not any(any(e[: self.field.size]) for e in self.field.polynomial(element))

    def _irreducible(self, one: Darboux) -> Darboux | None:
        """The polynomial without factors that are constant, if it does not split and is right."""
        field = self.field
        context = fmpq_mpoly_ctx.get(field.names, Ordering.degrevlex)
        terms = field.polynomial(one.polynomial)
        polynomial = polynomial_of(context, terms)
        factors = [
            (factor, power)
            for factor, power in polynomial.factor()[1]
            if any(factor.degrees()[: field.size])
        ]
        if len(factors) != 1 or factors[0][1] != 1:
            return None
        found = terms_of(factors[0][0])
        return Darboux(field.element(primitive(found)), one.cofactor, one.equations)

    def _is_new(self, one: Darboux) -> bool:
        """Whether it is no combination of products of those found, for the same constants."""
        values = self._values(one)
        known = [other for other in self.found if self._holds(other, values)]
        own = [(self._at(f.polynomial, values), self._at(f.cofactor, values)) for f in known]
        target, cofactor = self._at(one.polynomial, values), self._at(one.cofactor, values)
        degree = _degree(target)
        span = Echelon()
        waiting: list[tuple[Residues, Residues, int]] = [({0: 1}, {}, 0)]
        while waiting:
            left, total, first = waiting.pop()
            if total == cofactor:
                span.extend(left)
            for k in range(first, len(own)):
                if _degree(left) + _degree(own[k][0]) <= degree:
                    waiting.append(
                        (product_of(left, own[k][0]), _sum_of_terms(total, own[k][1]), k)
                    )
        return span.extend(target)

    def _values(self, one: Darboux) -> list[int]:
        """Residues of constants in general position among those that obey the equations."""
        random, names = Random(1), self.field.names[self.field.size :]
        values = {name: random.randrange(PRIME) for name in names}
        for left, right in reversed(one.equations):
            (name,) = (n for n in names if (left - self.at.ring.generator(n)).is_zero)
            values[name] = self._at(right, [*values.values()]).get(0, 0)
        return [*values.values()]

    def _holds(self, one: Darboux, values: Sequence[int]) -> bool:
        try:
            return not any(self._at(left - right, values) for left, right in one.equations)
        except ZeroDivisionError:
            return False

    def _at(self, element: Element, values: Sequence[int]) -> Residues:
        """An element whose denominators are constant, at values of the constants.

        Raises ``ZeroDivisionError`` if one vanishes there.
        """
        below = 1
        for index, exponent in element.denominator.items():
            divisor = Element(element.ring, {0: element.ring.divisors[index]}, {})
            value = self._residues(self.field.polynomial(divisor), values).get(0, 0)
            if not value:
                raise ZeroDivisionError
            below = below * pow(value, exponent, PRIME) % PRIME
        found = self._residues(self.field.polynomial(element), values)
        over = pow(below, -1, PRIME)
        return {monomial: value * over % PRIME for monomial, value in found.items()}

    def _residues(self, terms: Terms, values: Sequence[int]) -> Residues:
        return ResidueField(self.field.rates, self.field.factor, values).residues(terms)


class _Ansatz:
    """The coefficients of F and K as unknowns, in the names c, k, and those of the constants."""

    def __init__(
        self, field: PolynomialField, powers: Sequence[Exponents], cofactors: Sequence[Exponents]
    ) -> None:
        self.field, self.monomials, self.cofactors = field, powers, cofactors
        constants = field.names[field.size :]
        self.unknowns = len(self.monomials) - 1 + len(cofactors)
        self.width = self.unknowns + len(constants)
        names = [*(f":{k}" for k in range(self.unknowns)), *constants]
        self.context = fmpq_mpoly_ctx.get(names, Ordering.degrevlex)
        self.places = [*range(self.unknowns), *reversed(range(self.unknowns, self.width))]

    def in_constants(self, terms: Terms) -> fmpq_mpoly:
        """A polynomial in the constants."""
        before = (0,) * self.unknowns
        found = {(*before, *e[self.field.size :]): v for e, v in terms.items()}
        return polynomial_of(self.context, found)

    def equations(self) -> list[fmpq_mpoly]:
        """The coefficients of F′ − KF, those of the leading monomials first."""
        found: dict[Exponents, dict[Exponents, Fraction]] = {}
        size, others = self.field.size, (0,) * (self.width - self.unknowns)
        for place, own in enumerate(self.monomials, -1):
            for exponents, value in self.field.derivative((*own, *others)).items():
                key = (*self._unit(place)[: self.unknowns], *exponents[size:])
                self._add(found, exponents[:size], key, value)
            for k, factor in enumerate(self.cofactors, len(self.monomials) - 1):
                key = tuple(a + b for a, b in zip(self._unit(place), self._unit(k), strict=True))
                total = tuple(a + b for a, b in zip(own, factor, strict=True))
                self._add(found, total, key, Fraction(-1))
        in_order = sorted(found, key=lambda e: (sum(e), e), reverse=True)
        return [polynomial_of(self.context, found[key]) for key in in_order]

    def _unit(self, place: int) -> Exponents:
        return tuple(int(k == place) for k in range(self.width))

    @staticmethod
    def _add(
        found: dict[Exponents, dict[Exponents, Fraction]],
        place: Exponents,
        key: Exponents,
        value: Fraction,
    ) -> None:
        terms = found.setdefault(place, {})
        terms[key] = terms.get(key, Fraction(0)) + value

    def solution(self, branch: Branch) -> Darboux | None:
        """What a branch says of F, K and the constants; what it leaves open of F and K is small.

        There is none if a coefficient that is not zero stands in an equation of the constants: it
        would have to be a function of them, and no rational one.
        """
        field, ring = self.field, self.field.at.ring
        open_values = self._open_values(branch)
        nonzero = [k for k, number in enumerate(open_values) if number]
        of_constants = [equation for place, equation in branch.solved if place >= self.unknowns]
        if any(equation.degrees()[k] for equation in of_constants for k in nonzero):
            return None
        values = {k: ring.number(n) for k, n in enumerate(open_values)} | {-1: ring.one}
        equations = []
        for place, equation in branch.solved:
            slope = equation.derivative(place)
            value = self._element(slope * self.context.gens()[place] - equation, open_values)
            value = value / self._element(slope, open_values)
            if place < self.unknowns:
                values[place] = value
            else:
                name = field.names[field.size + place - self.unknowns]
                equations.append((ring.generator(name), value))
        terms = [values[k] * self._monomial(e) for k, e in enumerate(self.monomials, -1)]
        later = enumerate(self.cofactors, len(self.monomials) - 1)
        factor = [values[k] * self._monomial(e) for k, e in later]
        cofactor = sum(factor, ring.zero) / field.multiple
        return Darboux(sum(terms, ring.zero), cofactor, tuple(equations))

    def _monomial(self, exponents: Exponents) -> Element:
        others = (0,) * (self.width - self.unknowns)
        return self.field.element({(*exponents, *others): Fraction(1)})

    def _open_values(self, branch: Branch) -> list[int]:
        """Numbers for all unknowns, zeros if the branch can be solved where they are zero."""
        slopes = [equation.derivative(place) for place, equation in branch.solved]
        degrees = [sum(int(slope.degrees()[k]) for slope in slopes) for k in range(self.unknowns)]
        # As many numbers as degrees, and one more: at some of them no coefficient vanishes.
        choices = product(*(range(degree + 1) for degree in degrees))
        return next(
            [*numbers]
            for numbers in choices
            if not any(self._element(slope, numbers).is_zero for slope in slopes)
        )

    def _element(self, polynomial: fmpq_mpoly, values: Sequence[int]) -> Element:
        """A polynomial in the constants, with values for all unknowns."""
        names = [*map(self.context.constant, values), *self.context.gens()[self.unknowns :]]
        before = (0,) * self.field.size
        return self.field.element(
            {
                (*before, *exponents[self.unknowns :]): value
                for exponents, value in terms_of(polynomial.compose(*names)).items()
            }
        )


def _lighter(field: PolynomialField) -> Iterator[Exponents]:
    """The monomials that are in no weight heavier than the motion of some variable over it.

    Where the motion is homogeneous they are as heavy.
    """
    size = field.size
    motion = {
        tuple(e - (j == k) for j, e in enumerate(exponents[:size]))
        for k, rate in enumerate(field.rates)
        for exponents in rate
    }
    reach = 2 if size <= 4 else 1 if size <= 7 else 0
    both = [tuple(sign * w for w in weight) for weight in field.weights for sign in (1, -1)]
    weights = [*product(range(-reach, reach + 1), repeat=size), *both, (1,) * size]
    heaviest = [max((_weight(w, e) for e in motion), default=0) for w in weights]
    for degree in reversed(range(heaviest[-1] + 1)):
        for monomial in monomials((1,) * size, degree):
            if all(_weight(w, monomial) <= most for w, most in zip(weights, heaviest, strict=True)):
                yield monomial


def _weight(weights: Sequence[int], exponents: Sequence[int]) -> int:
    return sum(w * e for w, e in zip(weights, exponents, strict=True))


def _degree(terms: Residues) -> int:
    return max((sum(unpack(monomial)) for monomial in terms), default=0)


def _sum_of_terms(left: Residues, right: Residues) -> Residues:
    total = {m: (left.get(m, 0) + right.get(m, 0)) % PRIME for m in left.keys() | right.keys()}
    return {monomial: value for monomial, value in total.items() if value}
