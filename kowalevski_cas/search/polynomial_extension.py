r"""A polynomial vector field of which one with functions and roots is a part.

In the place of sines, exponentials and roots stand variables of their own, which move by their
rates, and so do variables for one over what the rates are divided by. What is constant along this
field is so along the other one; the relations of functions and roots are among it.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq, fmpq_mpoly

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Quotient,
    power,
    substitute,
    times,
)
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import EquationOfMotion, Space
from kowalevski_cas.search.integrals import first_integrals
from kowalevski_cas.search.points import distinct

ONE = Number(1)


def integrals_in_functions(at: Evaluation, degree: int, pool: Pool = HERE) -> Iterator[Formula]:
    """Polynomials in variables, functions, roots and one over divisors, that do not move.

    The degree counts each of these once. What is a polynomial in those before is left out, and so
    is what is constant by a relation; that there are no others is not known.
    """
    extension = PolynomialExtension(at)
    for found in first_integrals(extension.evaluation, degree, pool=pool):
        formula = substitute(formula_in(found), extension.values)
        value = at.scalar(formula)
        if any(not at.partial(value, name).is_zero for name in at.setting.variables):
            yield formula


class PolynomialExtension:
    """The polynomial field, and what its variables stand for."""

    def __init__(self, at: Evaluation) -> None:
        self.at, ring = at, at.ring
        names = (*at.setting.variables, *at.setting.roots)
        rates = {name: _rate(at, name) for name in names}
        moving = [n for n in names if n in at.setting.variables or not rates[n].is_zero]
        factors = (f for n in moving for k in rates[n].denominator for f, _ in _factors(at, k))
        self.below = distinct([*factors])
        self.inverses = [Name(f"w_{{{number}}}") for number in range(1, len(self.below) + 1)]
        field = {name: self._polynomial(rates[name]) for name in moving}
        self.values: dict[str, Formula] = {}
        for factor, inverse in zip(self.below, self.inverses, strict=True):
            divisor = ring.element({0: factor}, {})
            rate = self._polynomial(at.derivative(divisor) * divisor.inverse())
            field[inverse.name] = Negative(times(inverse, rate))
            self.values[inverse.name] = Quotient(ONE, formula_in(divisor))
        space = Space(
            variables=tuple(field),
            constants=(*at.setting.constants, *(name for name in names if name not in moving)),
            field=tuple(EquationOfMotion((name,), ONE, rate) for name, rate in field.items()),
        )
        self.evaluation = Evaluation(space, load("flint"))

    def _polynomial(self, element: Element) -> Formula:
        """An element in lowest terms, with variables for one over irreducible factors."""
        parts, unit = dict(element.parts), fmpq(1)
        powers = dict.fromkeys(map(str, self.below), 0)
        for k, exponent in element.denominator.items():
            unit *= self.at.ring.divisors[k].leading_coefficient() ** exponent
            for factor, multiplicity in _factors(self.at, k):
                powers[str(factor)] += exponent * multiplicity
        inverses = []
        for factor, inverse in zip(self.below, self.inverses, strict=True):
            left = powers[str(factor)]
            while left and all((part % factor).is_zero() for part in parts.values()):
                parts = {mask: part / factor for mask, part in parts.items()}
                left -= 1
            inverses += [power(inverse, left)] if left else []
        above = Element(element.ring, {mask: part / unit for mask, part in parts.items()}, {})
        return times(formula_in(above), *inverses)


def _factors(at: Evaluation, divisor: int) -> list[tuple[fmpq_mpoly, int]]:
    """The irreducible factors of a divisor, with their multiplicities."""
    return [(_monic(factor), n) for factor, n in at.ring.divisors[divisor].factor()[1]]


def _monic(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    return polynomial / polynomial.leading_coefficient()


def _rate(at: Evaluation, name: str) -> Element:
    return at.derivative(at.scalar(Name(name)))
