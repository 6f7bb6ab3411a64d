"""Polynomial first integrals of a polynomial vector field, up to a degree or a weight."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import chain
from random import Random

from kowalevski_cas.algebra.kernels import PRIME, TooLarge, kernel, rank
from kowalevski_cas.algebra.polynomials import primitive
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.kernel import LARGEST, Residues, product_of, residues
from kowalevski_cas.problem.polynomial_fields import (
    Exponents,
    PolynomialField,
    Terms,
    derivative,
    monomials,
    number_of_monomials,
    weight_of,
)

CONSTANTS = 6
"""The largest degree of coefficients in the constants."""


def first_integrals(
    at: Evaluation,
    weight: int,
    weights: Sequence[int] = (),
    pool: Pool = HERE,
    cofactor: Element | None = None,
    integrals: Sequence[Element] = (),
) -> Iterator[Element]:
    """Polynomials in the variables that do not move, the lightest first.

    Those that are polynomials in the ones before them, with coefficients that depend on the
    constants, are left out. If there is a ``cofactor`` K, they are the polynomials F with F′ = KF
    instead, without the combinations of those before by polynomials in the ``integrals``.

    Args:
        at: the evaluation of a space, with FLINT.
        weight: the largest weight of a polynomial.
        weights: the positive weights of the variables; all are 1, and the weight is the degree,
            if none are given.
        pool: where the linear algebra is done, block by block.
        cofactor: K.
        integrals: first integrals, for the combinations that are left out.

    Raises:
        Meaningless: if a root stands in the equations of motion.
        TooLarge: if what comes next takes too much memory.
    """
    field = PolynomialField(at, cofactor)
    search = _IntegralSearch(field, weights or (1,) * len(at.setting.variables), pool)
    if cofactor is not None:
        search.factors = [field.polynomial(one) for one in integrals]
    for size in range(cofactor is None, weight + 1):
        for terms in search.of_weight(size):
            yield search.field.element(terms)


class _IntegralSearch:
    """Integrals found so far, in a field."""

    def __init__(self, field: PolynomialField, weights: Sequence[int], pool: Pool) -> None:
        self.field, self.weights, self.pool = field, weights, pool
        self.known: list[Terms] = []
        self.factors = self.known
        """What known ones are multiplied by: integrals by each other."""
        self.monomials: list[Exponents] = []
        self.columns: list[Residues] = []
        self.others = len(field.names) - field.size
        random = Random(1)
        self.values = [random.randrange(PRIME) for _ in range(self.others)]

    def of_weight(self, weight: int) -> Iterator[Terms]:
        """Integrals with terms up to a weight that are no polynomials in the known ones."""
        if (size := number_of_monomials(self.weights, weight)) > LARGEST:
            raise TooLarge(f"{size} monomials have the weight {weight} or less")
        for own in monomials(self.weights, weight):
            exponents = (*own, *(0,) * self.others)
            self.monomials.append(exponents)
            self.columns.append(residues(self.field.derivative(exponents), self.values))
        dimension = len(self.columns) - rank(self.columns, self.pool)
        span = self._span(weight)
        for degree in range(CONSTANTS + 1 if self.others else 1):
            if len(span) == dimension or len(self.monomials) * (degree + 1) > LARGEST:
                return
            for terms in sorted(self._kernel(degree), key=_size):
                if len(span) < dimension and span.extend(residues(terms, self.values)):
                    self.known.append(primitive(terms))
                    yield self.known[-1]
                    span = self._span(weight)

    def _kernel(self, degree: int) -> Iterator[Terms]:
        """A basis of the integrals with coefficients of some degree in the constants."""
        groups: dict[Exponents, list[Exponents]] = {}
        ones = (1,) * self.others
        constants = [e for size in range(degree + 1) for e in monomials(ones, size)]
        for own in self.monomials:
            for powers in constants:
                exponents = (*own[: self.field.size], *powers)
                groups.setdefault(self.field.grade(exponents), []).append(exponents)
        work = partial(_solutions, self.field.rates, self.field.factor)
        return chain.from_iterable(self.pool.map(work, groups.values()))

    def _span(self, weight: int) -> Span:
        """The polynomials in known integrals, up to a weight and but for constants."""
        own = [residues(f, self.values) for f in self.factors]
        same = self.factors is self.known
        found, waiting = (
            Span(),
            [(residues(f, self.values), k * same) for k, f in enumerate(self.known)],
        )
        while waiting:
            left, first = waiting.pop()
            if weight_of(left, self.weights) <= weight:
                found.extend(left)
                waiting += [(product_of(left, own[k]), k) for k in range(first, len(own))]
        return found


def _solutions(rates: Sequence[Terms], factor: Terms, group: Sequence[Exponents]) -> list[Terms]:
    """A basis of the combinations of monomials that the motion multiplies by the factor."""
    vectors = kernel([derivative(exponents, rates, factor) for exponents in group])
    return [{e: v for e, v in zip(group, vector, strict=True) if v} for vector in vectors]


def _size(terms: Terms) -> tuple[int, int]:
    return max(map(sum, terms)), len(terms)


class Span:
    """A space of polynomials modulo a prime, by a basis whose leading terms differ."""

    def __init__(self) -> None:
        self._basis: dict[Exponents, Residues] = {}

    def __len__(self) -> int:
        return len(self._basis)

    def extend(self, terms: Residues) -> bool:
        """Add a polynomial; whether it was not in the space before."""
        rest = dict(terms)
        while rest:
            lead = max(rest)
            if lead not in self._basis:
                over = pow(rest[lead], -1, PRIME)
                self._basis[lead] = {e: v * over % PRIME for e, v in rest.items()}
                return True
            factor = rest[lead]
            for exponents, value in self._basis[lead].items():
                new = (rest.get(exponents, 0) - factor * value) % PRIME
                if new:
                    rest[exponents] = new
                else:
                    rest.pop(exponents, None)
        return False
