"""Products of powers of Darboux polynomials that are constant, or last multipliers (Darboux).

If F′ = KF for several F, a product of powers F^λ times exp G has the logarithmic derivative
Σ λK + G′. It is an integral if this vanishes, and a last multiplier if it is −div of the motion.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.polynomial_fields import Exponents, PolynomialField, monomials
from kowalevski_cas.search.darboux import Darboux

Column = Mapping[Exponents, Element]
"""A polynomial in the variables, by its coefficients."""


@dataclass(frozen=True)
class Relation:
    """Σ λK + G′ = 0, or Σ λK + G′ + div = 0 for a ``multiplier``, with constants λ."""

    exponents: tuple[Element, ...]
    exponential: Element
    multiplier: bool


def relations(field: PolynomialField, known: Sequence[Darboux]) -> Iterator[Relation]:
    """A basis of the relations among cofactors that are not zero, with G of the motion's degree."""
    at, zero = field.at, field.at.ring.zero
    degree = max((sum(e[: field.size]) for rate in field.rates for e in rate), default=0)
    others = (0,) * (len(field.names) - field.size)
    powers = [
        field.element({(*e, *others): Fraction(1)})
        for size in range(1, degree + 1)
        for e in monomials((1,) * field.size, size)
    ]
    divergence = zero
    for name in at.setting.variables:
        divergence = divergence + at.partial(at.rates.get(name, zero), name)
    whole = [*(one.cofactor for one in known), *map(at.derivative, powers), divergence]
    for vector in _nullspace([_coefficients(field, one) for one in whole], field):
        exponents = vector[: len(known)]
        exponential = sum((a * b for a, b in zip(vector[len(known) :], powers, strict=False)), zero)
        if divergence.is_zero and not vector[-1].is_zero:
            continue
        if not all(one.is_zero for one in exponents) or not vector[-1].is_zero:
            yield Relation(tuple(exponents), exponential, not vector[-1].is_zero)


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
    zero, one = field.at.ring.zero, field.at.ring.one
    pivots: list[tuple[Exponents, dict[Exponents, Element], list[Element]]] = []
    for k, column in enumerate(columns):
        rest, made = dict(column), [zero] * len(columns)
        made[k] = one
        for key, basis, combination in pivots:
            factor = rest.get(key, zero)
            if not factor.is_zero:
                rest = {
                    e: rest.get(e, zero) - factor * basis.get(e, zero)
                    for e in rest.keys() | basis.keys()
                }
                made = [a - factor * b for a, b in zip(made, combination, strict=True)]
        left = {e: value for e, value in rest.items() if not value.is_zero}
        if not left:
            yield made
            continue
        lead = max(left)
        over = left[lead].inverse()
        scaled = {e: value * over for e, value in left.items()}
        pivots.append((lead, scaled, [value * over for value in made]))
