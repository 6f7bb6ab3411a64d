"""Expressions of SymEngine, kept expanded, so that each polynomial has one form only."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from symengine import Add, Expr, Integer, Mul, Rational, Symbol, expand

from kowalevski_cas.algebra.polynomials import Coefficients, Map, Polynomials, Terms

ZERO = Integer(0)


class ExpandedExpression:
    """An expanded expression; sums of such are expanded, nothing else is."""

    __slots__ = ("value",)

    def __init__(self, value: Expr) -> None:
        self.value = value

    def __add__(self, other: ExpandedExpression) -> ExpandedExpression:
        return ExpandedExpression(self.value + other.value)

    def __neg__(self) -> ExpandedExpression:
        return ExpandedExpression(expand(-self.value))

    def __sub__(self, other: ExpandedExpression) -> ExpandedExpression:
        return ExpandedExpression(expand(self.value - other.value))

    def __mul__(self, other: ExpandedExpression) -> ExpandedExpression:
        return ExpandedExpression(expand(self.value * other.value))

    def __bool__(self) -> bool:
        return bool(self.value != ZERO)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ExpandedExpression) and bool(self.value == other.value)


class Arithmetic(Polynomials):
    """Polynomial expressions in SymEngine's symbols."""

    name = "symengine"

    def __init__(self, generators: tuple[str, ...]) -> None:
        super().__init__(generators)
        self.symbols = [Symbol(f"g{index}") for index in range(len(generators))]
        self.index = {symbol: index for index, symbol in enumerate(self.symbols)}
        self.zero = self.constant(0)
        self.one = self.constant(1)

    def generator(self, index: int) -> ExpandedExpression:
        return ExpandedExpression(self.symbols[index])

    def constant(self, value: int | Fraction) -> ExpandedExpression:
        return ExpandedExpression(Rational(value.numerator, value.denominator))

    def derivative(self, polynomial: ExpandedExpression, index: int) -> ExpandedExpression:
        return ExpandedExpression(polynomial.value.diff(self.symbols[index]))

    def substitution(self, values: Sequence[ExpandedExpression], target: Polynomials) -> Map:
        images = {g: image.value for g, image in zip(self.symbols, values, strict=True)}
        return lambda polynomial: ExpandedExpression(expand(polynomial.value.xreplace(images)))

    def is_monomial(self, polynomial: ExpandedExpression) -> bool:
        return not polynomial.value.is_Add

    def occurring_places(self, polynomial: ExpandedExpression) -> set[int]:
        return {self.index[symbol] for symbol in polynomial.value.free_symbols}

    def terms(self, polynomial: ExpandedExpression) -> Terms:
        terms: Terms = {}
        for product in Add.make_args(polynomial.value):
            exponents, value = [0] * len(self.symbols), Fraction(1)
            for factor in Mul.make_args(product):
                if factor.is_Number:
                    value = Fraction(int(factor.p), int(factor.q))
                else:
                    base, exponent = factor.args or (factor, 1)
                    exponents[self.index[base]] = int(exponent)
            if value:
                terms[tuple(exponents)] = value
        return terms

    def from_terms(self, terms: Coefficients) -> ExpandedExpression:
        return ExpandedExpression(Add(*(self._product(*term) for term in terms.items())))

    def _product(self, exponents: Sequence[int], value: int | Fraction) -> Expr:
        powers = zip(self.symbols, exponents, strict=True)
        number = Rational(value.numerator, value.denominator)
        return Mul(number, *(symbol**exponent for symbol, exponent in powers if exponent))
