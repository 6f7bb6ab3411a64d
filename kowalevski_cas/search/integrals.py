"""Polynomial first integrals of a polynomial vector field, up to a degree or a weight."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.search.kernels import kernel
from kowalevski_cas.search.polynomial_fields import (
    Exponents,
    PolynomialField,
    Terms,
    monomials,
    primitive,
    product_of,
    weight_of,
)


def first_integrals(
    at: Evaluation, weight: int, weights: Sequence[int] = (), constants: int = 0
) -> Iterator[Element]:
    """Polynomials in the variables that do not move, the lightest first.

    Those that are polynomials in the ones before them, and in the constants, are left out.

    Args:
        at: the evaluation of a space, with FLINT.
        weight: the largest weight of a polynomial.
        weights: the positive weights of the variables; all are 1, and the weight is the degree,
            if none are given.
        constants: the largest degree of the coefficients in the constants.

    Raises:
        Meaningless: if a root stands in the equations of motion.
    """
    search = _Search(PolynomialField(at), weights or (1,) * len(at.setting.variables), constants)
    for size in range(1, weight + 1):
        for terms in search.of_weight(size):
            yield search.field.element(terms)


class _Search:
    """Integrals found so far, in a field."""

    def __init__(self, field: PolynomialField, weights: Sequence[int], constants: int) -> None:
        self.field, self.weights, self.constants = field, weights, constants
        self.known: list[Terms] = []

    @cached_property
    def factors(self) -> list[Exponents]:
        """The monomials in the constants that a coefficient has."""
        field = self.field
        others = len(field.names) - field.size
        return [
            (0,) * field.size + powers
            for degree in range(self.constants + 1)
            for powers in monomials((1,) * others, degree)
        ]

    def of_weight(self, weight: int) -> list[Terms]:
        """Integrals with terms up to a weight that are no polynomials in the known ones."""
        groups: dict[Exponents, list[Exponents]] = {}
        for own in range(1, weight + 1):
            for exponents in monomials(self.weights, own):
                for factor in self.factors:
                    powers = (*exponents, *factor[self.field.size :])
                    groups.setdefault(self.field.grade(powers), []).append(powers)
        made: dict[Exponents, list[Terms]] = {}
        for terms in self._products({(0,) * len(self.field.names): Fraction(1)}, 0, weight):
            made.setdefault(self.field.grade(next(iter(terms))), []).append(terms)
        found = []
        for grade, group in groups.items():
            span = Span(made.get(grade, ()))
            for vector in kernel([self.field.derivative(exponents) for exponents in group]):
                terms = {e: v for e, v in zip(group, vector, strict=True) if v}
                if span.extended(terms):
                    found.append(primitive(terms))
        return self._independent(
            sorted(found, key=lambda terms: (max(map(sum, terms)), len(terms)))
        )

    def _independent(self, found: list[Terms]) -> list[Terms]:
        """Those that are no multiples, by polynomials in the constants, of the ones before."""
        span = Span(())
        kept = []
        for terms in found:
            if span.extended(terms):
                kept.append(terms)
                for factor in self.factors:
                    span.extended(_shifted(terms, factor))
        self.known += kept
        return kept

    def _products(self, left: Terms, start: int, weight: int) -> Iterator[Terms]:
        """Products of known integrals and constants, up to a weight."""
        for factor in self.factors:
            yield _shifted(left, factor)
        for k in range(start, len(self.known)):
            own = weight_of(self.known[k], self.weights)
            if own <= weight:
                yield from self._products(product_of(left, self.known[k]), k, weight - own)


def _shifted(terms: Terms, by: Exponents) -> Terms:
    return {tuple(a + b for a, b in zip(e, by, strict=True)): v for e, v in terms.items()}


class Span:
    """A space of polynomials, by a basis whose leading terms differ."""

    def __init__(self, spanned: Sequence[Terms]) -> None:
        self._basis: dict[Exponents, Terms] = {}
        for terms in spanned:
            self.extended(terms)

    def extended(self, terms: Terms) -> bool:
        """Add a polynomial; whether it was not in the space before."""
        rest = dict(terms)
        while rest:
            lead = max(rest)
            if lead not in self._basis:
                self._basis[lead] = rest
                return True
            own = self._basis[lead]
            factor = rest[lead] / own[lead]
            for exponents, value in own.items():
                new = rest.get(exponents, Fraction(0)) - factor * value
                if new:
                    rest[exponents] = new
                else:
                    rest.pop(exponents, None)
        return False
