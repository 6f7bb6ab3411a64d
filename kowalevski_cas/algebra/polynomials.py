"""What an exact arithmetic has to offer: polynomials with rational coefficients.

Everything else (fractions, roots, the imaginary unit, derivatives along a
field) is built once, in :mod:`kowalevski_cas.algebra.tower`, on top of these
few operations. A new exact arithmetic is one new file with one such class.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce
from operator import itemgetter
from typing import Any

Polynomial = Any
"""A polynomial of the library at hand; it must support ``+``, ``-``, ``*`` and unary ``-``."""

Terms = dict[tuple[int, ...], Fraction]
"""The neutral form of a polynomial: exponents of the generators to coefficient."""

Coefficients = Mapping[tuple[int, ...], int | Fraction]
"""What a polynomial is made of; whole numbers may be integers of Python."""


class Polynomials(ABC):
    """The ring of polynomials over the rationals in named generators."""

    name: str
    zero: Polynomial
    one: Polynomial

    def __init__(self, generators: tuple[str, ...]) -> None:
        self.generators = generators

    @abstractmethod
    def generator(self, index: int) -> Polynomial:
        """The generator with this index."""

    @abstractmethod
    def constant(self, value: Fraction) -> Polynomial:
        """A rational number as a polynomial."""

    def product(self, left: Polynomial, right: Polynomial) -> Polynomial:
        """The product of two polynomials, in the form in which the library keeps them."""
        return left * right

    @abstractmethod
    def derivative(self, polynomial: Polynomial, index: int) -> Polynomial:
        """The partial derivative by the generator with this index."""

    def composed(
        self, polynomial: Polynomial, values: Sequence[Polynomial], target: Polynomials
    ) -> Polynomial:
        """The polynomial with polynomials of ``target`` in place of its generators."""
        total, powers = target.zero, dict[tuple[int, int], Polynomial]()
        for exponents, coefficient in self.terms(polynomial).items():
            product = target.constant(coefficient)
            for power in filter(itemgetter(1), enumerate(exponents)):
                if power not in powers:
                    place, exponent = power
                    powers[power] = reduce(target.product, [values[place]] * exponent)
                product = target.product(product, powers[power])
            total = total + product
        return total

    @abstractmethod
    def is_zero(self, polynomial: Polynomial) -> bool:
        """Whether the polynomial vanishes identically; the answer is exact."""

    def degrees(self, polynomial: Polynomial) -> Sequence[int]:
        """The degree in each generator of a polynomial that is not zero."""
        return tuple(map(max, zip(*self.terms(polynomial), strict=True)))

    @abstractmethod
    def terms(self, polynomial: Polynomial) -> Terms:
        """The neutral form of a polynomial."""

    @abstractmethod
    def from_terms(self, terms: Coefficients) -> Polynomial:
        """The polynomial with these coefficients."""
