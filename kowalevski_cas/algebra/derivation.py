"""The derivation of a tower of roots along a field given by its components."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import reduce, singledispatch
from operator import add

from kowalevski_cas.algebra.tower import Element, Parts, Ring

Field = Mapping[str, Element]
"""The derivative of each generator; generators that are not named are constants."""


@singledispatch
def along(element: Element, field: Field) -> Element:
    r"""The derivative of an element along a field, by the product and chain rules.

    A root :math:`g^2=r` that has no component of its own in the field changes by
    :math:`g' = r'g/(2r)`, and if :math:`r'=gq` by :math:`q/2`, without a division.
    """
    ring = element.ring
    if len(element.summands) > 1:
        return reduce(add, (along(Element(ring, *one), field) for one in element.summands))
    total = ring.zero
    for partial, rate in _partials(element, field):
        total = total + Element(ring, partial, {}) * rate
    if not element.denominator:
        return total
    result = total * Element(ring, {0: ring.polynomials.one}, element.denominator)
    for index, exponent in element.denominator.items():
        change = along(Element(ring, {0: ring.divisors[index]}, {}), field)
        if not change.is_zero or change.denominator:
            over = Element(ring, {0: ring.polynomials.constant(-exponent)}, {index: 1})
            result = result + element * change * over
    return result


def gradient(element: Element, names: tuple[str, ...]) -> list[Element]:
    """The partial derivatives by these generators."""
    return [along(element, {name: element.ring.one}) for name in names]


def _partials(element: Element, field: Field) -> Iterator[tuple[Parts, Element]]:
    """The partial derivatives of a numerator that do not vanish, by what moves, and its rate."""
    ring, parts = element.ring, element.parts
    for name, rate in field.items():
        place = ring.polynomials.places.get(name)
        if place is None or (rate.is_zero and not rate.denominator):
            continue  # a zero remembers what it was divided by
        partial = {}
        for mask, p in parts.items():
            if derived := ring.polynomials.derivative(p, place):
                partial[mask] = derived
        if partial:
            yield partial, rate
    for bit, name in enumerate(ring.roots):
        if partial := {mask ^ 1 << bit: p for mask, p in parts.items() if mask >> bit & 1}:
            yield partial, _root_along(ring, bit, name, field)


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
