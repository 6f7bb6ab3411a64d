"""Polynomials of SymPy's ``polys.rings``: sparse dictionaries, in pure Python."""

from __future__ import annotations

import os
from collections.abc import Mapping
from fractions import Fraction

# SymPy counts with FLINT's numbers where it finds them, and would be no opinion of its own.
os.environ.setdefault("SYMPY_GROUND_TYPES", "python")

from sympy import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from kowalevski_cas.algebra.polynomials import Polynomials, Terms


class Arithmetic(Polynomials):
    """``PolyElement`` over ``QQ`` in lexicographic order."""

    name = "sympy"

    def __init__(self, generators: tuple[str, ...]) -> None:
        super().__init__(generators)
        self.ring = PolyRing([f"g{index}" for index in range(len(generators))], QQ, lex)
        self.zero = self.ring.zero
        self.one = self.ring.one

    def generator(self, index: int) -> PolyElement:
        return self.ring.gens[index]

    def constant(self, value: Fraction) -> PolyElement:
        return self.ring.ground_new(QQ(value.numerator, value.denominator))

    def derivative(self, polynomial: PolyElement, index: int) -> PolyElement:
        return polynomial.diff(index)

    def is_zero(self, polynomial: PolyElement) -> bool:
        return bool(polynomial == 0)

    def terms(self, polynomial: PolyElement) -> Terms:
        return {
            exponents: Fraction(int(value.numerator), int(value.denominator))
            for exponents, value in polynomial.terms()
        }

    def from_terms(self, terms: Mapping[tuple[int, ...], Fraction]) -> PolyElement:
        return self.ring.from_dict(
            {e: QQ(value.numerator, value.denominator) for e, value in terms.items()}
        )
