"""Polynomials of SymPy's ``polys.rings``: sparse dictionaries, in pure Python."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

# SymPy counts with FLINT's numbers where it finds them, and would be no opinion of its own.
os.environ.setdefault("SYMPY_GROUND_TYPES", "python")

from sympy import ZZ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from kowalevski_cas.algebra.polynomials import Coefficients, Map, Polynomials, Terms


@dataclass(frozen=True, slots=True)
class Scaled:
    """A polynomial with whole coefficients over a positive number, in lowest terms.

    Rational coefficients would be put in lowest terms one by one, which takes most of the time.
    """

    whole: PolyElement
    below: int = 1

    def __add__(self, other: Scaled) -> Scaled:
        if self.below == other.below:
            return _lowest(self.whole + other.whole, self.below)
        below = lcm(self.below, other.below)
        left, right = below // self.below, below // other.below
        return _lowest(self.whole * left + other.whole * right, below)

    def __neg__(self) -> Scaled:
        return Scaled(-self.whole, self.below)

    def __sub__(self, other: Scaled) -> Scaled:
        if self.below == other.below:
            return _lowest(self.whole - other.whole, self.below)
        return self + -other

    def __mul__(self, other: Scaled) -> Scaled:
        whole = self.whole.square() if self is other else self.whole * other.whole
        return _lowest(whole, self.below * other.below)

    def __bool__(self) -> bool:
        return bool(self.whole)


def _lowest(whole: PolyElement, below: int) -> Scaled:
    if below > 1 and (common := gcd(below, *whole.values())) > 1:
        return Scaled(whole.quo_ground(common), below // common)
    return Scaled(whole, below)


def _plain(whole: PolyElement) -> PolyElement | int:
    """A polynomial, or the number that it is."""
    return whole.const() if whole.is_ground else whole


class Arithmetic(Polynomials):
    """``PolyElement`` over ``ZZ`` in lexicographic order, over a number."""

    name = "sympy"

    def __init__(self, generators: tuple[str, ...]) -> None:
        super().__init__(generators)
        self.ring = PolyRing([f"g{index}" for index in range(len(generators))], ZZ, lex)
        self.zero = Scaled(self.ring.zero)
        self.one = Scaled(self.ring.one)

    def generator(self, index: int) -> Scaled:
        return Scaled(self.ring.gens[index])

    def constant(self, value: int | Fraction) -> Scaled:
        return Scaled(self.ring.ground_new(value.numerator), value.denominator)

    def derivative(self, polynomial: Scaled, index: int) -> Scaled:
        return _lowest(polynomial.whole.diff(index), polynomial.below)

    def substitution(self, values: Sequence[Scaled], target: Polynomials) -> Map:
        assert isinstance(target, Arithmetic)
        ring, below = target.ring, lcm(*(value.below for value in values))
        images = [_plain(value.whole * (below // value.below)) for value in values]

        def image(polynomial: Scaled) -> Scaled:
            degree = max(map(sum, polynomial.whole), default=0)
            total = 0
            for exponents, coefficient in polynomial.whole.items():
                product = coefficient * below ** (degree - sum(exponents))
                for image, exponent in zip(images, exponents, strict=True):
                    if exponent:
                        product = product * image**exponent
                total = total + product
            return _lowest(ring(total), polynomial.below * below**degree)

        return image

    def is_monomial(self, polynomial: Scaled) -> bool:
        return len(polynomial.whole) == 1

    def occurring_places(self, polynomial: Scaled) -> list[int]:
        return [place for place, degree in enumerate(polynomial.whole.degrees()) if degree > 0]

    def terms(self, polynomial: Scaled) -> Terms:
        return {
            exponents: Fraction(int(value), polynomial.below)
            for exponents, value in polynomial.whole.terms()
        }

    def from_terms(self, terms: Coefficients) -> Scaled:
        below = lcm(*(value.denominator for value in terms.values()))
        whole = {e: value.numerator * (below // value.denominator) for e, value in terms.items()}
        return Scaled(self.ring.from_dict(whole), below)
