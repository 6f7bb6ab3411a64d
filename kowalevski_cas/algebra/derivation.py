"""The derivation of a tower of roots along a field given by its components."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import singledispatch

from kowalevski_cas.algebra.polynomials import Polynomial
from kowalevski_cas.algebra.tower import Element, Ring

Field = Mapping[str, Element]
"""The derivative of each generator; generators that are not named are constants."""


@singledispatch
def along(element: Element, field: Field) -> Element:
    r"""The derivative of an element along a field, by the product and chain rules.

    A root :math:`g^2=r` that has no component of its own in the field changes by
    :math:`g' = r'g/(2r)`, and if :math:`r'=gq` by :math:`q/2`, without a division.
    """
    ring = element.ring
    total = ring.zero
    for mask, polynomial in element.parts.items():
        change = _polynomial_along(ring, polynomial, field)
        if not mask:
            total = total + change
        else:
            total = total + change * Element(ring, {mask: ring.polynomials.one}, {})
            coefficient = Element(ring, {0: polynomial}, {})
            total = total + coefficient * _roots_along(ring, mask, field)
    if not element.denominator:
        return total
    result = total * Element(ring, {0: ring.polynomials.one}, element.denominator)
    for index, exponent in element.denominator.items():
        change = _polynomial_along(ring, ring.divisors[index], field)
        if not change.is_zero or change.denominator:
            over = Element(ring, {0: ring.polynomials.constant(Fraction(-exponent))}, {index: 1})
            result = result + element * change * over
    return result


def gradient(element: Element, names: tuple[str, ...]) -> list[Element]:
    """The partial derivatives by these generators."""
    return [along(element, {name: element.ring.one}) for name in names]


def _polynomial_along(ring: Ring, polynomial: Polynomial, field: Field) -> Element:
    total = ring.zero
    for index, name in enumerate(ring.polynomials.generators):
        component = field.get(name)
        if component is None or (component.is_zero and not component.denominator):
            continue  # a zero remembers what it was divided by
        partial = ring.polynomials.derivative(polynomial, index)
        if partial:
            total = total + Element(ring, {0: partial}, {}) * component
    return total


def _roots_along(ring: Ring, mask: int, field: Field) -> Element:
    """The derivative of a product of roots."""
    total = ring.zero
    for bit, name in enumerate(ring.roots):
        if mask >> bit & 1:
            rest = Element(ring, {mask ^ (1 << bit): ring.polynomials.one}, {})
            total = total + rest * _root_along(ring, bit, name, field)
    return total


def _root_along(ring: Ring, bit: int, name: str, field: Field) -> Element:
    if name in field:
        return field[name]
    change = along(ring.radicands[bit], field)
    if change.is_zero:
        return change
    if all(mask >> bit & 1 for mask in change.parts):
        rest = {mask ^ (1 << bit): part for mask, part in change.parts.items()}
        return Element(ring, rest, change.denominator) * ring.number(Fraction(1, 2))
    twice = ring.radicands[bit] * ring.number(2)
    return change * ring.generator(name) * twice.inverse()
