"""The Painlevé test: whether Laurent series with all their free constants begin at a balance.

A series x = t^-w (c + c₁ t + c₂ t² + …) is put into the equations of motion. With A = Df(c) + w the
coefficient of t^k has to obey (k - A) c_k = R_k, where R_k is known from those before. If k is an
exponent, this is a condition on R_k, and some constants in c_k are free. See M. J. Ablowitz,
A. Ramani and H. Segur, J. Math. Phys. 21 (1980).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from math import prod
from operator import mul

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from kowalevski_cas.algebra.flint import coefficients, to_flint
from kowalevski_cas.algebra.ideals import reduce_groebner_basis, remainder
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.branches import Branch, branches, without
from kowalevski_cas.search.exponents import Balance, LeadingPart, determinant

Vector = list[fmpq_mpoly]


@dataclass(frozen=True)
class Laurent:
    """What has to hold for the series of a principal balance to have all free constants."""

    conditions: tuple[tuple[int, fmpq_mpoly], ...]
    """Exponents and what has to vanish there, if the conditions before hold.

    The generators are those of the leading part, and then the free constants.
    """
    cases: tuple[Branch, ...]
    """For which values of the constants of the motion all conditions hold."""
    logarithm: int | None
    """The exponent at which constants are missing whatever holds."""


def laurent(part: LeadingPart, balance: Balance) -> Laurent:
    """The series of a principal balance under whole weights, up to its largest exponent.

    Raises:
        Meaningless: one choice of free constants does not serve for the whole balance.
    """
    series, conditions = _Series(part, balance), list[tuple[int, fmpq_mpoly]]()
    if balance.exponents.count(Fraction(0)) > _dimension(part, balance):
        return Laurent((), (), 0)
    for order in range(1, int(balance.exponents[-1]) + 1):
        found = series.extend(order)
        if found is None:
            return Laurent(tuple(conditions), (), order)
        conditions += ((order, condition) for condition in found)
    return Laurent(
        tuple(conditions), tuple(series.cases(condition for _, condition in conditions)), None
    )


def _dimension(part: LeadingPart, balance: Balance) -> int:
    """How many free constants are in c, by the leading monomials of a Gröbner basis."""
    solved = {place for place, _ in balance.equations.solved}
    free = [place for place in part.places if place not in solved]
    leads = [
        {place for place in free if monomial[place]}
        for monomial in (equation.monomial(0) for equation in balance.equations.rest)
    ]
    sizes = (
        size
        for size in range(len(free), -1, -1)
        for chosen in combinations(free, size)
        if not any(lead <= {*chosen} for lead in leads)
    )
    return next(sizes)


class _Series:
    """The coefficients of the series, as polynomials modulo the equations for c.

    The scale stands for one over the product of what is divided by.
    """

    def __init__(self, part: LeadingPart, balance: Balance) -> None:
        self.size, self.weights, self.places = part.size, part.weights, part.places
        self.exponents = balance.exponents
        names = (*part.context.names(), *(f"c{k}" for k in self.places))
        self.context = fmpq_mpoly_ctx.get(names, Ordering.lex)
        self.zero, gens = self.context.constant(0), self.context.gens()
        self.letters = [*gens[-self.size :]]
        solved = [(place, self._lift(value)) for place, value in balance.equations.solved]
        self.rest = tuple(map(self._lift, balance.equations.rest))
        multiple = self._lift(part.multiple)
        slopes = [multiple, *(value.derivative(place) for place, value in solved)]
        self.below = prod({str(slope): slope for slope in slopes}.values(), start=self.zero + 1)
        self.inverse = gens[0] * (self.below / multiple)
        self.unit = gens[0] * self.below - 1
        values = [*gens]
        for place, value in solved:
            slope = value.derivative(place)
            values[place] = self._short(
                (values[place] * slope - value) * gens[0] * (self.below / slope)
            )
        self.coefficients = [[values[place] for place in self.places]]
        sides = list(zip(map(self._lift, part.leading), map(self._lift, part.lower), strict=True))
        self.matrix = [
            [
                self._short(self.inverse * leading.derivative(j).compose(*values, ctx=self.context))
                + (i == j) * to_flint(part.weights[i - 1])
                for j in self.places
            ]
            for i, (leading, _) in enumerate(sides, 1)
        ]
        self.terms = [[*self._terms(leading + lower)] for leading, lower in sides]

    def _lift(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        more = (0,) * self.size
        return self.context.from_dict({(*e, *more): v for e, v in polynomial.to_dict().items()})

    def _terms(self, polynomial: fmpq_mpoly) -> Iterator[tuple[tuple[int, ...], fmpq_mpoly]]:
        """Exponents of the variables, and coefficients."""
        for e, value in polynomial.to_dict().items():
            own = tuple(map(int, e[1 : self.size + 1]))
            constants = (0,) * (self.size + 1) + tuple(e[self.size + 1 :])
            yield own, self.context.from_dict({constants: value})

    def _short(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        return remainder(polynomial, [self.unit, *self.rest])

    def _numerator(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """What has to vanish for a polynomial to do so; zero if it vanishes at all points."""
        polynomial = remainder(without(polynomial, 0, self.unit), self.rest)
        inverse = self.context.gens()[0] * polynomial - 1
        return self.zero if len(self.rest) > 1 and self._nowhere(inverse) else polynomial

    def _nowhere(self, polynomial: fmpq_mpoly) -> bool:
        """Whether a polynomial vanishes at no point of the balance."""
        basis = reduce_groebner_basis([*self.rest, polynomial])
        return not all(any(polynomial.degrees()[: self.size + 1]) for polynomial in basis)

    def extend(self, order: int) -> Vector | None:
        """One coefficient more; what has to vanish for it, or ``None`` if constants are missing.

        Polynomials in A are its inverse on the image and the projection to the rest, by the theorem
        of Cayley and Hamilton: with h the product of ρ - r for the exponents r other than k, and
        h = (ρ - k) q + h(k), they are q(A) / h(k) and h(A) / h(k).
        """
        others = [exponent for exponent in self.exponents if exponent != order]
        times = len(self.exponents) - len(others)
        roots = (fmpq_poly([-to_flint(other), 1]) for other in others)
        projection = prod(roots, start=fmpq_poly([1]))
        projection /= projection(order)
        known, quotient = self._known_terms(order), projection // fmpq_poly([-order, 1])
        next_one, conditions = self._apply_polynomial(quotient, known), Vector()
        if times:
            places = range(self.size)
            units = ([self.zero + (j == k) for j in places] for k in places)
            columns = [self._apply_polynomial(projection, unit) for unit in units]
            moved = (self._times(column) for column in columns)
            kept = zip(moved, columns, strict=True)
            if any(
                self._numerator(a - order * b) for m, c in kept for a, b in zip(m, c, strict=True)
            ):
                return None
            chosen = self._independent(columns, times)
            failing = self._apply_polynomial(projection, known)
            hindering = [one for k in chosen if (one := self._numerator(failing[k]))]
            conditions = [condition / condition.factor()[0] for condition in hindering]
            for k in chosen:
                letter = self.letters.pop(0)
                next_one = [a + letter * b for a, b in zip(next_one, columns[k], strict=True)]
        self.coefficients.append([self._short(coefficient) for coefficient in next_one])
        return conditions

    def cases(self, conditions: Iterable[fmpq_mpoly]) -> Iterator[Branch]:
        """Where the constants of the motion make conditions hold for all others."""
        places = range(self.size + 1, len(self.context.gens()) - self.size)
        others = [k for k in range(len(self.context.gens())) if k not in places]
        equations = (
            c for condition in conditions for c in coefficients(condition, others).values()
        )
        return branches(equations, places, [self.below])

    def _independent(self, columns: Sequence[Vector], times: int) -> tuple[int, ...]:
        """The places of a principal minor that does not vanish: of a projection there is one.

        Where a balance has several parts, it has to vanish at none of them.
        """
        size = [sum(map(len, column)) for column in columns]
        order = sorted(range(self.size), key=size.__getitem__)
        minors = (
            (chosen, determinant([[columns[j][i] for j in chosen] for i in chosen]))
            for chosen in combinations(order, times)
        )
        for chosen, minor in minors:
            if value := self._numerator(minor):
                if len(self.rest) < 2 or self._nowhere(value):
                    return chosen
        raise Meaningless("it has several parts, with other free constants each")

    def _times(self, vector: Vector) -> Vector:
        """A times a vector."""
        return [self._short(sum(map(mul, row, vector), self.zero)) for row in self.matrix]

    def _apply_polynomial(self, polynomial: fmpq_poly, vector: Vector) -> Vector:
        """A polynomial in A times a vector."""
        total = [self.zero] * self.size
        for value in reversed(polynomial.coeffs()):
            moved = self._times(total)
            total = [a + value * b for a, b in zip(moved, vector, strict=True)]
        return total

    def _known_terms(self, order: int) -> Vector:
        """What the coefficients found so far give for the next one."""
        return [
            self._short(
                self.inverse
                * sum(
                    (
                        value * self._coefficient(powers, order - self._gap(k, powers))
                        for powers, value in terms
                    ),
                    self.zero,
                )
            )
            for k, terms in enumerate(self.terms)
        ]

    def _gap(self, place: int, powers: tuple[int, ...]) -> int:
        """By how much a term is less heavy than the leading ones."""
        return int(self.weights[place] + 1 - sum(map(mul, self.weights, powers)))

    def _coefficient(self, powers: tuple[int, ...], order: int) -> fmpq_mpoly:
        """The coefficient of a power of t in a product of series."""
        product = [self.zero + 1] + [self.zero] * order if order >= 0 else []
        for place, power in enumerate(powers):
            own = [coefficient[place] for coefficient in self.coefficients]
            for _ in range(power):
                product = [
                    self._short(
                        sum(
                            (product[k - j] * own[j] for j in range(min(k + 1, len(own)))),
                            self.zero,
                        )
                    )
                    for k in range(len(product))
                ]
        return product[order] if product else self.zero
