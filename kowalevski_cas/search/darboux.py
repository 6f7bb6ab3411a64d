"""Darboux polynomials: polynomials F with F′ = KF, where neither F nor K is known.

The coefficients of both are unknowns of quadratic equations. If a leading monomial of F has the
coefficient 1, some equation is linear as a rule; else one splits into factors (:mod:`branches`).
Weights of the variables leave few monomials for K: in no weight is it heavier than the motion. If
the motion is homogeneous, so is K, and the parts of F are Darboux polynomials: F is homogeneous.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product, tee
from random import Random

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpz

from kowalevski_cas.algebra.elimination import PRIME, Echelon
from kowalevski_cas.algebra.flint import polynomial_of, terms_of, to_fraction
from kowalevski_cas.algebra.polynomials import TooLarge, primitive
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
from kowalevski_cas.search.ansatz import Ansatz, Ansatze
from kowalevski_cas.search.branches import Branch, Elimination

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
    leading, waiting = tee(search.leading_monomials(degree))
    for monomial, cases in zip(leading, pool.map(search.ansatze.solve, waiting), strict=True):
        yield from search.new(monomial, cases)


class _DarbouxSearch:
    """Darboux polynomials found so far, in a field."""

    def __init__(self, at: Evaluation, special: bool) -> None:
        self.at, self.field, self.special = at, PolynomialField(at), special
        self.field.polynomial(self.field.multiple.inverse())  # else variables stand below
        self.found: list[Darboux] = []
        granted = [self.field.polynomial(e) for e in at.granted if self._is_constant(e)]
        self.ansatze = Ansatze(
            tuple(self.field.rates),
            self.field.names[self.field.size :],
            tuple(self.field.weights),
            tuple(_lighter(self.field)),
            tuple(granted),
            special,
        )

    def leading_monomials(self, degree: int) -> Iterator[Exponents]:
        """By degree and then in the order of the variables."""
        for size in range(1, degree + 1):
            if (count := number_of_monomials((1,) * self.field.size, size)) > LARGEST:
                raise TooLarge(f"{count} unknown coefficients up to degree {size}")
            yield from monomials((1,) * self.field.size, size)

    def new(self, leading: Exponents, cases: Iterable[Branch]) -> Iterator[Darboux]:
        """What solutions for a leading monomial give besides what was found before."""
        for branch in cases:
            solutions = _Solutions(self.field, self.ansatze.of(leading))
            solution = None if branch.rest else solutions(branch)
            darboux = None if solution is None else self._irreducible(solution)
            if darboux is not None and self._is_new(darboux):
                self.found.append(darboux)
                yield darboux

    def _is_constant(self, element: Element) -> bool:
        """Whether no variable and no root stands in an element."""
        if element.parts.keys() - {0} or element.denominator:
            return False
        return not any(any(e[: self.field.size]) for e in self.field.polynomial(element))

    def _irreducible(self, darboux: Darboux) -> Darboux | None:
        """The polynomial without factors that are constant, if it does not split and is right."""
        field = self.field
        context = fmpq_mpoly_ctx.get(field.names, Ordering.degrevlex)
        terms = field.polynomial(darboux.polynomial)
        polynomial = polynomial_of(context, terms)
        factors = [
            (factor, power)
            for factor, power in polynomial.factor()[1]
            if any(factor.degrees()[: field.size])
        ]
        if len(factors) != 1 or factors[0][1] != 1:
            return None
        found = terms_of(factors[0][0])
        return Darboux(field.element(primitive(found)), darboux.cofactor, darboux.equations)

    def _is_new(self, darboux: Darboux) -> bool:
        """Whether it is no combination of products of those found, for the same constants."""
        values = self._values(darboux)
        known = [other for other in self.found if self._holds(other, values)]
        own = [(self._at(f.polynomial, values), self._at(f.cofactor, values)) for f in known]
        target, cofactor = self._at(darboux.polynomial, values), self._at(darboux.cofactor, values)
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

    def _values(self, darboux: Darboux) -> list[int]:
        """Residues of constants in general position among those that obey the equations."""
        random, names = Random(1), self.field.names[self.field.size :]
        values = {name: random.randrange(PRIME) for name in names}
        for left, right in reversed(darboux.equations):
            (name,) = (n for n in names if (left - self.at.ring.generator(n)).is_zero)
            values[name] = self._at(right, [*values.values()]).get(0, 0)
        return [*values.values()]

    def _holds(self, darboux: Darboux, values: Sequence[int]) -> bool:
        try:
            return not any(self._at(left - right, values) for left, right in darboux.equations)
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


class _Solutions:
    """What branches say of an ansatz."""

    def __init__(self, field: PolynomialField, ansatz: Ansatz) -> None:
        self.field, self.ansatz = field, ansatz
        self.unknowns, self.context = ansatz.unknowns, ansatz.context

    def __call__(self, branch: Branch) -> Darboux | None:
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
            solved = Elimination(place, equation)
            above = self._element(solved.value, open_values)
            value = above if above.is_zero else above / self._element(solved.slope, open_values)
            if place < self.unknowns:
                values[place] = value
            else:
                name = field.names[field.size + place - self.unknowns]
                equations.append((ring.generator(name), value))
        polynomial = self._combination(values, enumerate(self.ansatz.monomials, -1))
        factors = enumerate(self.ansatz.cofactors, len(self.ansatz.monomials) - 1)
        cofactor = self._combination(values, factors) / field.multiple
        return Darboux(polynomial, cofactor, tuple(equations))

    def _combination(
        self, values: Mapping[int, Element], monomials: Iterable[tuple[int, Exponents]]
    ) -> Element:
        """The monomials, each multiplied by the value at its place."""
        field, others = self.field, (0,) * (self.ansatz.width - self.unknowns)
        terms = (
            values[k] * field.element({(*exponents, *others): Fraction(1)})
            for k, exponents in monomials
            if not values[k].is_zero
        )
        return sum(terms, field.at.ring.zero)

    def _open_values(self, branch: Branch) -> list[int]:
        """Numbers for all unknowns, zeros if the branch can be solved where they are zero."""
        slopes = [equation.derivative(place) for place, equation in branch.solved]
        slopes = [slope for slope in slopes if not slope.is_constant()]
        degrees = [slope.degrees()[: self.unknowns] for slope in slopes]
        most = [sum(map(int, column)) for column in zip(*degrees, strict=True)]
        # As many numbers as degrees, and one more: at some of them no coefficient vanishes.
        choices = product(*(range(degree + 1) for degree in most or [0] * self.unknowns))
        return next(
            [*numbers]
            for numbers in choices
            if not any(self._element(slope, numbers).is_zero for slope in slopes)
        )

    def _element(self, polynomial: fmpq_mpoly, values: Sequence[int]) -> Element:
        """A polynomial in the constants, with values for all unknowns."""
        if polynomial.is_constant():
            return self.field.at.ring.number(to_fraction(polynomial.leading_coefficient()))
        degrees = polynomial.degrees()
        given: dict[str | int, int | fmpz | fmpq] = {
            k: value for k, value in enumerate(values) if degrees[k]
        }
        before = (0,) * self.field.size
        return self.field.element(
            {
                (*before, *exponents[self.unknowns :]): value
                for exponents, value in terms_of(polynomial.subs(given)).items()
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
