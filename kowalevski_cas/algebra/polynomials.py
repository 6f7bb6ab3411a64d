"""What an exact arithmetic has to offer: polynomials with rational coefficients.

Everything else (fractions, roots, the imaginary unit, derivatives along a
field) is built once, in :mod:`kowalevski_cas.algebra.tower`, on top of these
few operations. A new exact arithmetic is one new file with one such class.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

Polynomial = Any
"""A polynomial of the library at hand, in the one form that it has there.

It must support ``+``, ``-``, ``*``, unary ``-`` and ``==``, and be false exactly if it vanishes
identically.
"""

Map = Callable[[Polynomial], Polynomial]
"""What makes polynomials of another ring out of those of one."""

Terms = dict[tuple[int, ...], Fraction]
"""The neutral form of a polynomial: exponents of the generators to coefficient."""

Coefficients = Mapping[tuple[int, ...], int | Fraction]
"""What a polynomial is made of; whole numbers may be integers of Python."""


class TooLarge(ValueError):
    """What would take too much memory; the message says how large it is."""


class Polynomials(ABC):
    """The ring of polynomials over the rationals in named generators."""

    name: str
    zero: Polynomial
    one: Polynomial

    def __init__(self, generators: tuple[str, ...]) -> None:
        self.generators = generators
        self.places = {name: place for place, name in enumerate(generators)}

    @abstractmethod
    def generator(self, index: int) -> Polynomial:
        """The generator with this index."""

    @abstractmethod
    def constant(self, value: int | Fraction) -> Polynomial:
        """A rational number as a polynomial."""

    @abstractmethod
    def derivative(self, polynomial: Polynomial, index: int) -> Polynomial:
        """The partial derivative by the generator with this index."""

    @abstractmethod
    def substitution(self, values: Sequence[Polynomial], target: Polynomials) -> Map:
        """The homomorphism that puts polynomials of ``target`` in place of the generators."""

    @abstractmethod
    def is_monomial(self, polynomial: Polynomial) -> bool:
        """Whether a polynomial that is not zero has one term only."""

    @abstractmethod
    def occurring_places(self, polynomial: Polynomial) -> Collection[int]:
        """The places of the generators that stand in a polynomial."""

    @abstractmethod
    def terms(self, polynomial: Polynomial) -> Terms:
        """The neutral form of a polynomial."""

    @abstractmethod
    def from_terms(self, terms: Coefficients) -> Polynomial:
        """The polynomial with these coefficients."""


def primitive(terms: Terms) -> Terms:
    """The polynomial times the number that makes its coefficients whole and coprime."""
    below = lcm(*(value.denominator for value in terms.values()))
    above = gcd(*(value.numerator * (below // value.denominator) for value in terms.values()))
    sign = 1 if terms[max(terms)] > 0 else -1
    return {key: value * Fraction(sign * below, above) for key, value in terms.items()}
