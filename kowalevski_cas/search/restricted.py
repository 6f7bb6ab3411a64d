"""Polynomials that are constant along the motions on an invariant set.

Modulo the equations each polynomial has a remainder, by their Gröbner basis. That of a
derivative vanishes, which is a linear question for the coefficients of a polynomial.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from operator import ge
from random import Random

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.elimination import PRIME, Echelon
from kowalevski_cas.algebra.flint import polynomial_of, terms_of, to_flint
from kowalevski_cas.algebra.ideals import reduce_groebner_basis, remainder
from kowalevski_cas.algebra.kernels import kernel
from kowalevski_cas.algebra.polynomials import TooLarge, primitive
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.kernel import LARGEST
from kowalevski_cas.problem.polynomial_fields import (
    Exponents,
    PolynomialField,
    Terms,
    monomials,
    weight_of,
)
from kowalevski_cas.problem.residues import ResidueField
from kowalevski_cas.problem.space import Meaningless

CONSTANTS = 2
"""The largest degree of coefficients in the constants."""


def integrals_on(at: Evaluation, relations: Sequence[Element], degree: int) -> Iterator[Element]:
    """Integrals on the set where relations vanish, the lowest first, up to a degree.

    Those that are polynomials in the ones before them there are left out. One of which the
    derivative vanishes on the set, but is no combination of the relations, is not found.

    Args:
        at: the evaluation of a space, with FLINT.
        relations: polynomials whose derivatives are combinations of them.
        degree: the largest degree of a polynomial.

    Raises:
        Meaningless: the set is not seen to be invariant, or roots stand somewhere.
        TooLarge: there are too many monomials.
    """
    search = _RestrictedSearch(PolynomialField(at), relations)
    for size in range(1, degree + 1):
        for terms in search.of_degree(size):
            yield search.field.element(terms)


class _RestrictedSearch:
    """Integrals found so far on a set."""

    def __init__(self, field: PolynomialField, relations: Sequence[Element]) -> None:
        self.field = field
        self.context = fmpq_mpoly_ctx.get(field.names, Ordering.deglex)
        whole = (polynomial_of(self.context, field.polynomial(relation)) for relation in relations)
        given = [polynomial for polynomial in whole if polynomial]
        if not given:
            raise Meaningless("the relations hold everywhere")
        self.basis = reduce_groebner_basis(given)
        if any(polynomial.is_constant() for polynomial in self.basis):
            raise Meaningless("the relations hold nowhere")
        self.leads = [tuple(map(int, polynomial.monomial(0))) for polynomial in self.basis]
        self.known: list[fmpq_mpoly] = []
        self.others = len(field.names) - field.size
        random = Random(1)
        values = [random.randrange(PRIME) for _ in range(self.others)]
        self.residues = ResidueField(field.rates, field.factor, values)
        for polynomial in self.basis:
            rates = (self._rate(e) * to_flint(c) for e, c in terms_of(polynomial).items())
            if remainder(sum(rates, self.context.constant(0)), self.basis):
                raise Meaningless("derivatives of the relations are no combinations of them")

    def of_degree(self, degree: int) -> Iterator[Terms]:
        """Integrals up to a degree that are no polynomials in the known ones on the set."""
        span = self._span(degree)
        for own in range(CONSTANTS + 1 if self.others else 1):
            group = [*self._monomials(degree, own)]
            if len(group) > LARGEST:
                raise TooLarge(f"{len(group)} monomials stand in polynomials of degree {degree}")
            rates = [terms_of(remainder(self._rate(e), self.basis)) for e in group]
            found = ({e: v for e, v in zip(group, w, strict=True) if v} for w in kernel(rates))
            for terms in sorted(
                found, key=lambda integral: (max(map(sum, integral)), len(integral))
            ):
                if span.extend(self.residues.residues(terms)):
                    self.known.append(polynomial_of(self.context, primitive(terms)))
                    yield terms_of(self.known[-1])
                    span = self._span(degree)

    def _monomials(self, degree: int, others: int) -> Iterator[Exponents]:
        """Those with so many variables and constants that are their own remainders."""
        for size in range(1, degree + 1):
            for own in monomials((1,) * self.field.size, size):
                for more in range(others + 1):
                    for powers in monomials((1,) * self.others, more):
                        whole = (*own, *powers)
                        if not any(all(map(ge, whole, lead)) for lead in self.leads):
                            yield whole

    def _rate(self, exponents: Exponents) -> fmpq_mpoly:
        return polynomial_of(self.context, self.field.derivative(exponents))

    def _span(self, degree: int) -> Echelon:
        """The remainders of products of known integrals up to a degree."""
        sizes = [weight_of(terms_of(integral), (1,) * self.field.size) for integral in self.known]
        found, waiting = Echelon(), [(self.context.constant(1), 0, 0)]
        while waiting:
            left, size, first = waiting.pop()
            found.extend(self.residues.residues(terms_of(left)))
            for k in range(first, len(self.known)):
                if size + sizes[k] <= degree:
                    product = remainder(left * self.known[k], self.basis)
                    waiting.append((product, size + sizes[k], k))
        return found
