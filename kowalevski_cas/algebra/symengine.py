"""Expressions of SymEngine, kept expanded, so that zero has one form only."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import symengine
from symengine import Expr

from kowalevski_cas.algebra.polynomials import Coefficients, Polynomials, Terms


class Arithmetic(Polynomials):
    """Polynomial expressions in SymEngine's symbols; every product is expanded at once."""

    name = "symengine"

    def __init__(self, generators: tuple[str, ...]) -> None:
        super().__init__(generators)
        self.symbols = [symengine.Symbol(f"g{index}") for index in range(len(generators))]
        self.index = {symbol: index for index, symbol in enumerate(self.symbols)}
        self.zero = symengine.Integer(0)
        self.one = symengine.Integer(1)

    def generator(self, index: int) -> Expr:
        return self.symbols[index]

    def constant(self, value: int | Fraction) -> Expr:
        return symengine.Rational(value.numerator, value.denominator)

    def product(self, left: Expr, right: Expr) -> Expr:
        return symengine.expand(left * right)

    def derivative(self, polynomial: Expr, index: int) -> Expr:
        return polynomial.diff(self.symbols[index])

    def composed(self, polynomial: Expr, values: Sequence[Expr], target: Polynomials) -> Expr:
        return symengine.expand(polynomial.xreplace(dict(zip(self.symbols, values, strict=True))))

    def is_zero(self, polynomial: Expr) -> bool:
        return bool(symengine.expand(polynomial) == self.zero)

    def terms(self, polynomial: Expr) -> Terms:
        expanded = symengine.expand(polynomial)
        terms: Terms = {}
        for monomial, value in expanded.as_coefficients_dict().items():
            exponents = [0] * len(self.symbols)
            if monomial.is_Number:  # a constant comes as itself, once
                value, monomial = value * monomial, self.one
            for base, exponent in monomial.as_powers_dict().items():
                if base in self.index:
                    exponents[self.index[base]] = int(exponent)
            value = value * self.one  # a number of SymEngine, also where it is one of Python
            if value != self.zero:
                terms[tuple(exponents)] = Fraction(int(value.p), int(value.q))
        return terms

    def from_terms(self, terms: Coefficients) -> Expr:
        total = self.zero
        for exponents, value in terms.items():
            product = self.constant(value)
            for symbol, exponent in zip(self.symbols, exponents, strict=True):
                if exponent:
                    product *= symbol**exponent
            total += product
        return total
