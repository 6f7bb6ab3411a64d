"""Products of powers of Darboux polynomials that are constant, or last multipliers (Darboux).

If F′ = KF for several F, and (G/P)′ = L for products P of these, a product of powers F^λ times
exp Σ μ G/P has the logarithmic derivative Σ λK + Σ μL. It is an integral if this vanishes, and a
last multiplier if it is −div of the motion. See C. Christopher and J. Llibre, Annals of
Differential Equations 16 (2000).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import prod
from typing import TypeVar

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.polynomial_fields import Exponents, PolynomialField, monomials
from kowalevski_cas.search.darboux import Darboux

Column = Mapping[Exponents, Element]
"""A polynomial in the variables, by its coefficients."""

Row = TypeVar("Row")


@dataclass(frozen=True)
class Exponential:
    """exp(G/P), by G/P and its derivative; whether P is 1."""

    exponent: Element
    cofactor: Element
    is_polynomial: bool


@dataclass(frozen=True)
class CofactorRelation:
    """Σ λK + Σ μL = 0, or Σ λK + Σ μL + div = 0 for a ``multiplier``, with constants λ, μ."""

    exponents: tuple[Element, ...]
    exponential: Element
    multiplier: bool


def exponential_factors(
    field: PolynomialField, known: Sequence[Darboux], degree: int
) -> Iterator[Exponential]:
    """All exp(G/P) up to a degree of G and P, where (G/P)′ = L has a lower degree than the motion.

    That is a linear question: G′ − KG = LP, where P′ = KP. A G/P that is a combination of those
    before, but for something constant, is left out.
    """
    at = field.at
    motion = max((sum(e[: field.size]) for rate in field.rates for e in rate), default=0)
    powers = [*_monomials(field, max(degree, motion))]
    light = [*_monomials(field, motion - 1)]
    sizes = [
        max(sum(e[: field.size]) for e in field.polynomial(factor.polynomial)) for factor in known
    ]
    span = _Echelon(field)
    for total in range(degree + 1):
        for own in monomials(sizes, total):
            both = [*zip(own, known, strict=True)]
            below = prod((factor.polynomial**n for n, factor in both), start=at.ring.one)
            cofactor = sum(
                (at.ring.number(n) * factor.cofactor for n, factor in both), at.ring.zero
            )
            moved = (at.derivative(g) - cofactor * g for g in powers)
            columns = [
                _coefficients(field, element) for element in (*(below * x for x in light), *moved)
            ]
            for vector in _nullspace(columns, field):
                rate = -_combine(vector, light)
                if span.relation(_coefficients(field, rate)) is None:
                    above = _combine(vector[len(light) :], powers)
                    yield Exponential(above / below, rate, total == 0)


def relations(
    field: PolynomialField, known: Sequence[Darboux], exponentials: Sequence[Exponential] = ()
) -> Iterator[CofactorRelation]:
    """A basis of the relations among cofactors that are not zero."""
    at, zero = field.at, field.at.ring.zero
    divergence = zero
    for name in at.setting.variables:
        divergence = divergence + at.partial(at.rates.get(name, zero), name)
    cofactors = [
        *(factor.cofactor for factor in known),
        *(factor.cofactor for factor in exponentials),
    ]
    whole = [*cofactors, divergence]
    for vector in _nullspace([_coefficients(field, element) for element in whole], field):
        exponents, multiplier = vector[: len(known)], not vector[-1].is_zero
        if multiplier and divergence.is_zero:
            continue
        if multiplier or not all(exponent.is_zero for exponent in exponents):  # no sum of G/P alone
            exponential = _combine(vector[len(known) :], [e.exponent for e in exponentials])
            yield CofactorRelation(tuple(exponents), exponential, multiplier)


def _monomials(field: PolynomialField, degree: int) -> Iterator[Element]:
    others = (0,) * (len(field.names) - field.size)
    for size in range(degree + 1):
        for e in monomials((1,) * field.size, size):
            yield field.element({(*e, *others): Fraction(1)})


def _combine(vector: Sequence[Element], parts: Sequence[Element]) -> Element:
    """The combination of as many parts as there are."""
    zero = vector[0].ring.zero
    return sum((a * b for a, b in zip(vector, parts, strict=False)), zero)


def _coefficients(field: PolynomialField, element: Element) -> Column:
    """The coefficients of an element that is a polynomial in the variables."""
    ring, found = element.ring, dict[Exponents, Element]()
    below = Element(ring, {0: ring.polynomials.one}, element.denominator)
    for exponents, value in field.polynomial(element).items():
        own = (0,) * field.size + exponents[field.size :]
        term = field.element({own: value}) * below
        key = exponents[: field.size]
        found[key] = found[key] + term if key in found else term
    return found


def _nullspace(columns: Sequence[Column], field: PolynomialField) -> Iterator[list[Element]]:
    """A basis of the combinations of columns that vanish, over the functions of the constants."""
    span = _Echelon(field)
    zero = field.at.ring.zero
    for column in columns:
        if (found := span.relation(column)) is not None:
            yield [found.get(k, zero) for k in range(len(columns))]


class _Echelon:
    """Columns with different leading rows, over the functions of the constants."""

    def __init__(self, field: PolynomialField) -> None:
        self.zero, self.one = field.at.ring.zero, field.at.ring.one
        self.pivots: list[tuple[Exponents, Column, dict[int, Element]]] = []
        self.size = 0

    def relation(self, column: Column) -> dict[int, Element] | None:
        """Add a column; if it depends on those before, the combination that vanishes."""
        rest, made = dict(column), {self.size: self.one}
        self.size += 1
        for key, basis, combination in self.pivots:
            factor = rest.get(key, self.zero)
            if not factor.is_zero:
                rest, made = self._less(rest, factor, basis), self._less(made, factor, combination)
        left = {e: value for e, value in rest.items() if not value.is_zero}
        if not left:
            return made
        lead = max(left)
        over = left[lead].inverse()
        scaled = {e: value * over for e, value in left.items()}
        self.pivots.append((lead, scaled, {k: value * over for k, value in made.items()}))
        return None

    def _less(
        self, one: Mapping[Row, Element], factor: Element, other: Mapping[Row, Element]
    ) -> dict[Row, Element]:
        """A vector less a multiple of another one."""
        return {
            row: one.get(row, self.zero) - factor * other.get(row, self.zero)
            for row in one.keys() | other.keys()
        }
