"""Formulas in a ring: a fold over the tree, for anything that gives names their values."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from typing import Any

from kowalevski_cas.algebra.tower import Element, Ring
from kowalevski_cas.notation import (
    Conjugate,
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Root,
    ScalarProduct,
    Sum,
    Vector,
    to_latex,
)
from kowalevski_cas.problem.space import Equation, Meaningless


class Triple(tuple[Element, ...]):
    """The components of a vector, or the diagonal of a matrix."""

    __slots__ = ()


Value = Element | Triple


class Fold(ABC):
    """Values of formulas, by those of names, roots and derivatives.

    ``letters`` are names that stand for themselves in the ``ring``, with their places there.
    """

    ring: Ring
    letters: dict[str, int]

    @abstractmethod
    def value(self, name: str, conjugated: bool = False) -> Value:
        """The value of a name, or its conjugate; raises :class:`Meaningless` if it has none."""

    @abstractmethod
    def root(self, argument: Formula, conjugated: bool = False) -> Element:
        """The square root that is declared for an expression."""

    @abstractmethod
    def derivative(self, element: Element) -> Element:
        """The derivative along the field."""

    @abstractmethod
    def partial(self, element: Element, name: str) -> Element:
        """The partial derivative by a generator."""

    @property
    @abstractmethod
    def time_sign(self) -> int:
        """1 if the time is real, −1 if it is imaginary."""

    def __call__(self, formula: Formula, conjugated: bool = False) -> Value:
        """The value of a formula, or of its complex conjugate.

        Raises :class:`Meaningless` if a name has no meaning, if vectors and scalars are
        mixed up, or if a denominator vanishes identically.
        """
        rule = _RULES.get(type(formula))
        if rule is None:
            raise Meaningless(f"{to_latex(formula)} has no value of its own")
        return rule(formula, self, conjugated)

    def scalar(self, formula: Formula, conjugated: bool = False) -> Element:
        """The value of a formula that has to be a scalar."""
        value = self(formula, conjugated)
        if isinstance(value, Triple):
            raise Meaningless(f"{to_latex(formula)} is a vector where a scalar is expected")
        return value

    def vector(self, formula: Formula, conjugated: bool = False) -> Triple:
        """The value of a formula that has to be a vector."""
        value = self(formula, conjugated)
        if not isinstance(value, Triple):
            raise Meaningless(f"{to_latex(formula)} is a scalar where a vector is expected")
        return value

    def components(self, formula: Formula) -> tuple[Element, ...]:
        """The value of a formula as a tuple of scalars."""
        value = self(formula)
        return tuple(value) if isinstance(value, Triple) else (value,)

    def pairs(self, equations: Sequence[Equation]) -> list[tuple[Element, Element]]:
        """The values of both sides, component by component."""
        found = []
        for left, right in equations:
            a, b = self.components(left), self.components(right)
            if len(a) != len(b):
                raise Meaningless("the sides of an equation are a vector and a scalar")
            found += list(zip(a, b, strict=True))
        return found

    def differences(self, equations: Sequence[Equation]) -> list[Element]:
        """The left sides minus the right sides, component by component."""
        return [left - right for left, right in self.pairs(equations)]

    def polynomial(self, formula: Sum) -> tuple[list[Element], list[Formula]]:
        """The sum of those terms that are monomials in letters, if any, and the other terms."""
        if not self.letters:
            return [], [*formula.terms]
        size = len(self.ring.polynomials.generators)
        found: dict[int, dict[tuple[int, ...], int | Fraction]] = {}
        others = []
        for term in formula.terms:
            monomial = _monomial(term, self.letters, size)
            if monomial is None:
                others.append(term)
                continue
            mask, exponents, value = monomial
            part = found.setdefault(mask, {})
            part[exponents] = part.get(exponents, 0) + value
        return [self.ring.from_terms(found)] if found else [], others


def _monomial(
    formula: Formula, letters: Mapping[str, int], size: int
) -> tuple[int, tuple[int, ...], int | Fraction] | None:
    """The roots, the exponents and the coefficient of a product of letters and numbers."""
    value: int | Fraction = 1
    if type(formula) is Negative:
        value, formula = -1, formula.argument
    mask, exponents = 0, [0] * size
    for factor in formula.factors if type(formula) is Product else (formula,):
        power = 1
        if type(factor) is Power and type(factor.exponent) is Number:
            power, factor = factor.exponent.value, factor.base
        if type(factor) is Name:
            place = letters.get(factor.name)
            if place is None:
                return None
            if place < size:
                exponents[place] += power
            elif power == 1 and not mask >> place - size & 1:
                mask |= 1 << place - size
            else:
                return None
        elif (number := rational_number(factor)) is not None:
            value *= number**power
        else:
            return None
    return mask, tuple(exponents), value


def rational_number(formula: Formula) -> int | Fraction | None:
    """The number that a formula is: a whole one or a quotient, perhaps with a sign."""
    if type(formula) is Number:
        return formula.value
    if type(formula) is Quotient:
        above, below = formula.numerator, formula.denominator
        if type(above) is Number and type(below) is Number and below.value:
            return Fraction(above.value, below.value)
    if type(formula) is Negative and (value := rational_number(formula.argument)) is not None:
        return -value
    return None


# -- rules -----------------------------------------------------------------------


def _pair_components(left: Triple, right: Triple) -> Iterator[tuple[Element, Element]]:
    """The components of two vectors; raises :class:`Meaningless` if one has more of them."""
    if len(left) != len(right):
        raise Meaningless(f"a vector of {len(left)} components beside one of {len(right)}")
    return zip(left, right, strict=True)


def multiply(left: Value, right: Value) -> Value:
    """The product of scalars, of a scalar and a vector, or of a diagonal matrix and a vector."""
    if isinstance(left, Triple):
        if isinstance(right, Triple):
            return Triple(a * b for a, b in _pair_components(left, right))
        return Triple(a * right for a in left)
    if isinstance(right, Triple):
        return Triple(left * b for b in right)
    return left * right


def _add(left: Value, right: Value) -> Value:
    if isinstance(left, Triple) and isinstance(right, Triple):
        return Triple(a + b for a, b in _pair_components(left, right))
    if isinstance(left, Triple) or isinstance(right, Triple):
        raise Meaningless("a vector is added to a scalar")
    return left + right


def _each(value: Value, function: Callable[[Element], Element]) -> Value:
    return Triple(map(function, value)) if isinstance(value, Triple) else function(value)


def _sum(formula: Sum, at: Fold, bar: bool) -> Value:
    if bar:
        return reduce(_add, (at(term, bar) for term in formula.terms))
    polynomial, others = at.polynomial(formula)
    return reduce(_add, [*polynomial, *map(at, others)])


def _product(formula: Product, at: Fold, bar: bool) -> Value:
    return reduce(multiply, (at(factor, bar) for factor in formula.factors))


def _inverse(element: Element, formula: Formula) -> Element:
    try:
        return element.inverse() + element * element.ring.zero  # which remembers what is below it
    except ZeroDivisionError:
        shown = to_latex(formula)
        raise Meaningless(f"division by {shown}, which vanishes identically") from None


def _quotient(formula: Quotient, at: Fold, bar: bool) -> Value:
    if (number := rational_number(formula)) is not None:
        return at.ring.number(number)
    value = at(formula.numerator, bar)
    for divisor, exponent in divisors_of(formula.denominator):
        if isinstance(divisor, Number) and divisor.value:
            value = multiply(value, at.ring.number(Fraction(1, divisor.value**exponent)))
            continue
        below = at(divisor, bar)
        if isinstance(below, Triple):
            inverse: Value = Triple(_inverse(entry, divisor) for entry in below)
        else:
            inverse = _inverse(below, divisor) ** exponent
        value = multiply(value, inverse)
    return value


def divisors_of(formula: Formula) -> Iterator[tuple[Formula, int]]:
    """The factors of a denominator as it is printed, with exponents."""
    match formula:
        case Product(factors):
            for factor in factors:
                yield from divisors_of(factor)
        case Power(base, Number(exponent)) if exponent:
            yield base, exponent
        case _:
            yield formula, 1


def _power(formula: Power, at: Fold, bar: bool) -> Value:
    base = at.scalar(formula.base, bar)
    match formula.exponent:
        case Number(0):
            return at.ring.one + base * at.ring.zero  # which remembers what the base divides by
        case Number(exponent):
            return base**exponent
        case Negative(Number(exponent)):
            return _inverse(base, formula.base) ** exponent
    raise Meaningless(f"{to_latex(formula.exponent)} is no exponent that can be used here")


def _scalar_product(formula: ScalarProduct, at: Fold, bar: bool) -> Value:
    left, right = (at.vector(f, bar) for f in (formula.left, formula.right))
    total = at.ring.zero
    for a, b in _pair_components(left, right):
        total = total + a * b
    return total


def _cross_product(formula: CrossProduct, at: Fold, bar: bool) -> Value:
    left, right = (at.vector(f, bar) for f in (formula.left, formula.right))
    if {len(left), len(right)} != {3}:
        raise Meaningless(f"{to_latex(formula)} multiplies vectors that have not three components")
    (a1, a2, a3), (b1, b2, b3) = left, right
    return Triple((a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1))


def _derivative(formula: Derivative, at: Fold, bar: bool) -> Value:
    rate = _each(at(formula.argument, bar), at.derivative)
    if bar and at.time_sign < 0:
        return _each(rate, lambda element: -element)
    return rate


_RULES: dict[type[Formula], Callable[[Any, Fold, bool], Value]] = {
    Number: lambda f, at, _: at.ring.number(f.value),
    Name: lambda f, at, bar: at.value(f.name, bar),
    Sum: _sum,
    Negative: lambda f, at, bar: _each(at(f.argument, bar), lambda element: -element),
    Product: _product,
    Quotient: _quotient,
    Power: _power,
    Root: lambda f, at, bar: at.root(f.argument, bar),
    Derivative: _derivative,
    Partial: lambda f, at, bar: _each(
        at(f.argument, bar), lambda element: at.partial(element, f.by)
    ),
    Conjugate: lambda f, at, bar: at(f.argument, not bar),
    Vector: lambda f, at, bar: Triple(at.scalar(entry, bar) for entry in f.components),
    Diagonal: lambda f, at, bar: Triple(at.scalar(entry, bar) for entry in f.entries),
    ScalarProduct: _scalar_product,
    CrossProduct: _cross_product,
}
