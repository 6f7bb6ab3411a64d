"""The ring of a tower with its roots as ordinary variables: plain polynomials in FLINT."""

from __future__ import annotations

from collections.abc import Sequence

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.flint import polynomial_of, terms_of, to_fraction
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.tower import Element, Ring


class Flat:
    """The ring of a tower with its roots as ordinary variables.

    The roots come first, the last one foremost, so that in lexicographic order
    the relations between them are led by their squares.
    """

    def __init__(self, ring: Ring, order: Ordering = Ordering.lex) -> None:
        self.ring = ring
        self.roots = len(ring.roots)
        self.size = self.roots + len(ring.polynomials.generators)
        self.context = fmpq_mpoly_ctx.get(tuple(f"g{k}" for k in range(self.size)), order)

    def indices(self, names: Sequence[str]) -> tuple[int, ...]:
        """The places of names among the variables."""
        order = (*reversed(self.ring.roots), *self.ring.polynomials.generators)
        return tuple(order.index(name) for name in names if name in order)

    def relations(self, among: Sequence[fmpq_mpoly] | None = None) -> list[fmpq_mpoly]:
        """The equations of the roots, of those in given polynomials; the last ones first."""
        return [
            self.context.gens()[self.roots - 1 - bit] ** 2 - self.polynomial(radicand)
            for bit, radicand in reversed(list(enumerate(self.ring.radicands)))
            if among is None or any(p.degrees()[self.roots - 1 - bit] for p in among)
        ]

    def polynomial(self, element: Element) -> fmpq_mpoly:
        """The numerator of an element."""
        terms: Terms = {}
        for mask, part in element.terms().items():
            roots = tuple(mask >> bit & 1 for bit in reversed(range(self.roots)))
            for exponents, value in part.items():
                terms[roots + exponents] = value
        return polynomial_of(self.context, terms)

    def without_roots(self, element: Element) -> tuple[Element, fmpq_mpoly]:
        """The roots that divide a numerator, as an element, and the numerator without them."""
        polynomial = self.polynomial(element)
        content = self.ring.one
        for bit, name in enumerate(self.ring.roots):
            root = self.context.gens()[self.roots - 1 - bit]
            quotient, remainder = divmod(polynomial, root)
            if remainder.is_zero() and not polynomial.is_zero():
                polynomial, content = quotient, content * self.ring.generator(name)
        return content, polynomial

    def element(self, polynomial: fmpq_mpoly) -> Element:
        """A polynomial as an element of the tower."""
        total = self.ring.zero
        for exponents, value in terms_of(polynomial).items():
            product = self.ring.from_terms({0: {exponents[self.roots :]: value}})
            for bit, exponent in enumerate(reversed(exponents[: self.roots])):
                if exponent:
                    product = product * self.ring.generator(self.ring.roots[bit]) ** exponent
            total = total + product
        return total

    def inverse(self, polynomial: fmpq_mpoly) -> Element:
        """One over a polynomial, divided by one irreducible factor after another."""
        content, factors = polynomial.factor()
        result = self.ring.number(1 / to_fraction(content))
        for factor, exponent in factors:
            result = result * self.element(factor).inverse() ** int(exponent)
        return result

    def inverse_denominator(self, element: Element) -> Element:
        """One over the denominator of an element."""
        return Element(self.ring, self.ring.one.parts, element.denominator)
