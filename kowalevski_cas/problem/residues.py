"""Polynomials in the variables of a field modulo a prime, at residues of its constants.

A monomial is a number: its exponents are digits to the base 2ᴮᴵᵀˢ, so that monomials are multiplied
by an addition.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from functools import cached_property
from itertools import chain, count
from operator import lshift

from kowalevski_cas.algebra.elimination import PRIME, rank
from kowalevski_cas.algebra.kernels import residue
from kowalevski_cas.problem.place import Misplaced
from kowalevski_cas.problem.polynomial_fields import Exponents, Terms, monomials

BITS = 16
"""Of an exponent; so many that no sum of an exponent of the field and a degree is too large."""

Residues = dict[int, int]
"""The residues of the coefficients, by monomials."""


class ResidueField:
    """A polynomial vector field, less the multiplication by a factor, modulo the prime.

    Args:
        rates: the components of the field, in the variables and then the constants.
        factor: what is subtracted times a polynomial when this is differentiated.
        values: residues of the last names, the constants; ``None`` is one that nothing has asked
            for. Without values all names are kept.

    Raises:
        Misplaced: an exponent is too large, or a constant without a value stands somewhere.
    """

    def __init__(
        self, rates: Sequence[Terms], factor: Terms, values: Sequence[int | None] = ()
    ) -> None:
        self.rates, self.factor, self.values = rates, factor, values

    @cached_property
    def _steps(self) -> list[list[tuple[int, int]]]:
        """What a derivative adds to a monomial, and the coefficients, for each variable in it."""
        return [
            [(step - (1 << BITS * k), value) for step, value in self.residues(rate).items()]
            for k, rate in enumerate(self.rates)
        ]

    @cached_property
    def _multiple(self) -> list[tuple[int, int]]:
        return [(step, -value) for step, value in self.residues(self.factor).items()]

    def derivative(self, exponents: Exponents) -> Residues:
        """What the field, less the factor, makes of a monomial in the variables."""
        monomial = pack(exponents)
        found = {monomial + step: value for step, value in self._multiple}
        for exponent, steps in zip(exponents, self._steps, strict=False):
            for step, value in steps if exponent else ():
                key = monomial + step
                found[key] = found.get(key, 0) + exponent * value
        return {key: rest for key, value in found.items() if (rest := value % PRIME)}

    @cached_property
    def key(self) -> Hashable:
        """What the derivatives of all monomials depend on."""
        return tuple(tuple(sorted(steps)) for steps in [*self._steps, self._multiple])

    def residues(self, terms: Terms) -> Residues:
        """A polynomial in the variables and the constants, at the values of these."""
        found: Residues = {}
        for exponents, coefficient in terms.items():
            value, size = residue(coefficient), len(exponents) - len(self.values)
            for base, exponent in zip(self.values, exponents[size:], strict=True):
                if exponent:
                    if base is None:
                        raise Misplaced("a constant is not rational at the point")
                    value = value * pow(base, exponent, PRIME) % PRIME
            key = pack(exponents[:size])
            found[key] = (found.get(key, 0) + value) % PRIME
        return {key: value for key, value in found.items() if value}


def dimension(field: ResidueField, weights: Sequence[int], degree: int) -> int:
    """The dimension of the space of polynomials up to a degree whose derivative vanishes.

    A search that has just found them all knows it, and need not eliminate them again.
    """
    if (asked := (field.key, tuple(weights), degree)) not in _dimensions:
        of_degree = (monomials(weights, weight) for weight in range(degree + 1))
        columns = [*map(field.derivative, chain.from_iterable(of_degree))]
        remember_dimension(field, weights, degree, len(columns) - rank(columns))
    return _dimensions[asked]


def remember_dimension(
    field: ResidueField, weights: Sequence[int], degree: int, found: int
) -> None:
    """Keep a dimension for who asks next."""
    _dimensions.clear()
    _dimensions[field.key, tuple(weights), degree] = found


_dimensions: dict[Hashable, int] = {}
"""The one that was found last."""


def pack(exponents: Sequence[int]) -> int:
    """The number of a monomial; raises :class:`Misplaced` if an exponent is too large."""
    if (largest := max(exponents, default=0)) >> BITS - 1:
        raise Misplaced(f"an exponent is {largest}, which is too large")
    return sum(map(lshift, exponents, count(0, BITS)))


def unpack(monomial: int) -> list[int]:
    """The exponents of a monomial, up to the last that is not zero."""
    found = []
    while monomial:
        found.append(monomial & (1 << BITS) - 1)
        monomial >>= BITS
    return found


def product_of(left: Residues, right: Residues) -> Residues:
    """The product of two polynomials."""
    total: Residues = {}
    for a, u in left.items():
        for b, v in right.items():
            total[a + b] = total.get(a + b, 0) + u * v
    return {key: rest for key, value in total.items() if (rest := value % PRIME)}


Weighted = tuple[int, Residues]
"""A polynomial with its degree."""


def products(left: Weighted, integrals: Sequence[Weighted], degree: int) -> Iterator[Residues]:
    """A polynomial times all products of powers of integrals, up to a degree."""
    degree_here, terms = left
    if not terms or degree_here > degree:
        return
    yield terms
    for k, (more, integral) in enumerate(integrals):
        if degree_here + more <= degree:
            yield from products(
                (degree_here + more, product_of(terms, integral)), integrals[k:], degree
            )
