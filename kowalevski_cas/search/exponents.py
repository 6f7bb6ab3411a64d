"""Kowalevski exponents: how solutions of polynomial equations of motion may become infinite.

Under weights w, the leading terms f of a field have the solutions x = c t^-w for each c other than
zero with w c + f(c) = 0, the balances; solutions nearby begin with powers of t higher by the
exponents, the eigenvalues of Df(c) + w. See H. Yoshida, Celestial Mechanics 31 (1983).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, combinations
from math import prod
from operator import mul

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.flint import polynomial_of, terms_of, to_flint, to_fraction
from kowalevski_cas.algebra.ideals import reduce_groebner_basis
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.polynomial_fields import PolynomialField
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.branches import Branch, branches, maximal, solve_by_cases, without

LARGEST = 6
"""The largest weight that is tried."""

Division = tuple[fmpq_mpoly, list[fmpq_mpoly], fmpq_mpoly]
"""A unit u, cofactors, and the rest of u times a polynomial after the multiples."""


@dataclass(frozen=True)
class Balance:
    """Equations for c, for each component how w c + f(c) is made of them, and the exponents."""

    equations: Branch
    divisions: tuple[Division, ...]
    matrix: tuple[tuple[fmpq_mpoly, ...], ...]
    """Multiples of the rows of ρ - w - Df(c), where what is solved for is put in."""
    characteristic: Division
    """Its determinant, divided by what is not solved."""
    exponents: tuple[Fraction, ...]
    """Those that are rational numbers, as often as they occur."""
    factors: tuple[fmpq_mpoly, ...]
    """The polynomials in ρ for the others."""

    def is_principal(self) -> bool:
        """Whether the exponents are -1, once, and natural numbers."""
        lowest, *others = self.exponents or (Fraction(0),)
        natural = all(other >= 0 and other.denominator == 1 for other in others)
        return not self.factors and lowest == -1 and natural


class LeadingPart:
    """The terms of a field that lead under weights.

    Args:
        at: the evaluation of a space, with FLINT.
        letter: a constant that does not stand in the motion, for an exponent.

    Raises:
        Meaningless: the motion is no polynomial in the variables, or no term leads under positive
            weights up to :data:`LARGEST`.
    """

    def __init__(self, at: Evaluation, letter: str) -> None:
        field = PolynomialField(at)
        self.names, self.size = field.names, field.size
        self.context = fmpq_mpoly_ctx.get(
            ("u", *(f"v{k}" for k in range(len(self.names)))), Ordering.lex
        )
        self.scale, *generators = self.context.gens()
        """What makes equations homogeneous, by the scale of the time."""
        self.variables, self.exponent = (
            generators[: self.size],
            generators[field.names.index(letter)],
        )
        self.weights = weights_of_leading_terms(
            [[e[: self.size] for e in rate] for rate in field.rates]
        )
        self.multiple = self._polynomial(field.polynomial(field.multiple))
        if any(map(self.multiple.derivative, self.places)):
            raise Meaningless("quotients by variables stand in the motion")
        self.leading, self.lower = [], []
        for weight, rate in zip(self.weights, field.rates, strict=True):
            leads = {e: v for e, v in rate.items() if self._weight(e) == weight + 1}
            self.leading.append(self._polynomial(leads))
            self.lower.append(self._polynomial(rate) - self.leading[-1])

    @property
    def places(self) -> range:
        """The places of the variables among the generators."""
        return range(1, self.size + 1)

    def _weight(self, exponents: Sequence[int]) -> Fraction:
        return sum(map(mul, self.weights, exponents), Fraction(0))

    def _polynomial(self, terms: Terms) -> fmpq_mpoly:
        return polynomial_of(self.context, {(0, *e): v for e, v in terms.items()})

    def balances(self, pool: Pool = HERE) -> Iterator[Balance]:
        """All balances, by cases; constants are in general position.

        The equations are made homogeneous, so that no case is left out for having no real point.

        Raises:
            Meaningless: it is not seen of a case that it is a balance.
        """
        sides = [
            self.multiple * to_flint(w) * variable + part
            for w, variable, part in zip(self.weights, self.variables, self.leading, strict=True)
        ]
        homogeneous = [
            side + (self.scale - 1) * (side - part)
            for side, part in zip(sides, self.leading, strict=True)
        ]
        tasks = (
            ([*homogeneous, *self.variables[:k]], self.places, [self.scale, variable])
            for k, variable in enumerate(self.variables)
        )
        found = chain.from_iterable(pool.map(solve_by_cases, tasks))
        for equations in maximal([*chain.from_iterable(map(self._at_one, found))]):
            yield self._balance(sides, equations)

    def _at_one(self, found: Branch) -> Iterator[Branch]:
        """The cases of a case, at the scale 1; what is left of several equations is a basis."""
        parts: Iterable[Branch] = [found]
        if len(found.rest) > 1:  # the factors of a basis tell cases apart
            basis = (self._homogeneous(polynomial) for polynomial in self._basis(found))
            parts = branches(
                [*(value for _, value in found.solved), *basis], self.places, found.nonzero
            )
        for part in parts:
            rest = self._basis(part) if len(part.rest) > 1 else [*map(self._monic, part.rest)]
            if all(any(map(equation.derivative, self.places)) for equation in rest):
                pairs = ((place, _monic(self._monic(value), place)) for place, value in part.solved)
                yield Branch(tuple(pairs), tuple(rest), ())

    def _monic(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial at the scale 1, with leading coefficient 1."""
        lower = without(polynomial, 0, self.scale - 1)
        return lower / lower.leading_coefficient()

    def _homogeneous(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial at the scale 1, at any scale."""
        terms = terms_of(polynomial)
        top = max(self._weight(e[1:]) for e in terms)
        own = {(int(top - self._weight(e[1:])), *e[1:]): value for e, value in terms.items()}
        return polynomial_of(self.context, own)

    def _basis(self, found: Branch) -> list[fmpq_mpoly]:
        """A Gröbner basis of what vanishes at the scale 1 where the rest does, and nothing else."""
        unit = prod(map(self._monic, found.nonzero), start=self.scale) - 1
        basis = reduce_groebner_basis([*map(self._monic, found.rest), unit])
        return [polynomial for polynomial in basis if not polynomial.degrees()[0]]

    def _balance(self, sides: Sequence[fmpq_mpoly], equations: Branch) -> Balance:
        divisions = tuple(pseudo_remainder(side, equations) for side in sides)
        if any(rest for *_, rest in divisions):
            raise Meaningless("a balance is not solved for: try it with numbers for constants")
        solved, matrix = Branch(equations.solved, (), ()), []
        for k, side in enumerate(sides, 1):
            row = [
                (j == k) * self.multiple * self.exponent - side.derivative(j) for j in self.places
            ]
            parts = [pseudo_remainder(entry, solved) for entry in row]
            unit = prod({str(u): u for u, *_ in parts}.values(), start=self.context.constant(1))
            matrix.append(tuple(rest * (unit / u) for u, _, rest in parts))
        characteristic = pseudo_remainder(determinant(matrix), Branch((), equations.rest, ()))
        exponents, factors = self._roots(characteristic[2])
        return Balance(equations, divisions, tuple(matrix), characteristic, exponents, factors)

    def _roots(self, polynomial: fmpq_mpoly) -> tuple[tuple[Fraction, ...], tuple[fmpq_mpoly, ...]]:
        """The rational roots of a polynomial in the exponent, and its other factors."""
        exponents: list[Fraction] = []
        others: list[fmpq_mpoly] = []
        place = self.context.gens().index(self.exponent)
        for factor, power in polynomial.factor()[1]:
            slope = factor.derivative(place)
            root = self.exponent - factor / slope if slope and slope.is_constant() else slope
            if slope and slope.is_constant() and root.is_constant():
                value = root.leading_coefficient() if root else fmpq()
                exponents += [to_fraction(value)] * power
            elif slope:
                others += [factor] * power
        return tuple(sorted(exponents)), tuple(others)


def weights_of_leading_terms(rates: Sequence[Sequence[tuple[int, ...]]]) -> tuple[Fraction, ...]:
    """The positive weights under which most terms lead, and none is heavier than these.

    Whole weights are rather taken than halves. A term leads if it is heavier by 1 than the variable
    of which it stands in the derivative.

    >>> [str(w) for w in weights_of_leading_terms([[(0, 1)], [(3, 0), (1, 0)]])]
    ['1', '2']
    """
    size = len(rates)
    rows = [
        tuple(e - (j == k) for j, e in enumerate(exponents))
        for k, rate in enumerate(rates)
        for exponents in rate
    ]
    best: tuple[int, int, Fraction, tuple[Fraction, ...]] | None = None
    for scale in (1, 2):
        top, waiting = LARGEST * scale, [tuple[int, ...]()]
        while waiting:
            own = waiting.pop()
            ranges = [_range(row, own, top) for row in rows]
            leads = sum(low <= scale <= high for low, high in ranges)
            if any(low > scale for low, _ in ranges) or not leads or (best and leads < -best[0]):
                continue
            if len(own) < size:
                waiting += [(*own, weight) for weight in range(top, 0, -1)]
                continue
            weights = tuple(Fraction(weight, scale) for weight in own)
            found = (-leads, scale, sum(weights, Fraction(0)), weights)
            best = min(best or found, found)
    if best is None:
        raise Meaningless(f"no term of the motion leads under positive weights up to {LARGEST}")
    return best[-1]


def _range(row: Sequence[int], own: Sequence[int], top: int) -> tuple[int, int]:
    """The least and the greatest weight of a term, if the first weights are given."""
    known = sum(a * b for a, b in zip(row, own, strict=False))
    left = row[len(own) :]
    low = sum(a if a > 0 else a * top for a in left)
    high = sum(a * top if a > 0 else a for a in left)
    return known + low, known + high


def pseudo_remainder(polynomial: fmpq_mpoly, branch: Branch) -> Division:
    """A multiple of a polynomial, divided by the equations of a branch one after another."""
    context = polynomial.context()
    unit, cofactors = context.constant(1), list[fmpq_mpoly]()
    for place, equation in branch.solved:
        power = 0 if polynomial.is_zero() else int(polynomial.degrees()[place])
        factor = equation.derivative(place) ** power
        rest = without(polynomial, place, equation)
        cofactors = [factor * cofactor for cofactor in cofactors]
        cofactors.append((factor * polynomial - rest) / equation)
        unit, polynomial = unit * factor, rest
    own = [context.constant(0)] * len(branch.rest)
    before = None
    while before != polynomial:
        before = polynomial
        for k, equation in enumerate(branch.rest):
            quotient, polynomial = divmod(polynomial, equation)
            own[k] += quotient
    return unit, [*cofactors, *own], polynomial


def _monic(equation: fmpq_mpoly, place: int) -> fmpq_mpoly:
    """The equation with the unknown at a place alone, if a number stands before it."""
    slope = equation.derivative(place)
    return equation / slope.leading_coefficient() if slope.is_constant() else equation


def determinant(matrix: Sequence[Sequence[fmpq_mpoly]]) -> fmpq_mpoly:
    """The determinant, by the minors of the first rows."""
    size = len(matrix)
    minors: dict[tuple[int, ...], fmpq_mpoly] = {(): matrix[0][0].context().constant(1)}
    for height, row in enumerate(matrix, 1):
        minors = {
            chosen: sum(
                (
                    (-1) ** (height - 1 - k) * row[j] * minors[(*chosen[:k], *chosen[k + 1 :])]
                    for k, j in enumerate(chosen)
                ),
                row[0].context().constant(0),
            )
            for chosen in combinations(range(size), height)
        }
    return minors[tuple(range(size))]
