"""Formulas as polynomials in a letter: the coefficients of what they have above a fraction bar."""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from itertools import zip_longest

from kowalevski_cas.notation import (
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    times,
    total,
)

ZERO, ONE = Number(0), Number(1)

Polynomial = tuple[Formula, ...]
"""Coefficients, that of the lowest power first."""

_HIGHEST = 12
"""The highest power that is written out."""


class Fraction:
    """A polynomial in a letter over a product of others."""

    def __init__(self, above: Polynomial, below: tuple[Polynomial, ...] = ()) -> None:
        self.above, self.below = above, below

    def over(self, factors: Iterable[Polynomial]) -> Polynomial:
        """What stands above a product that has all factors below."""
        rest = [*factors]
        for factor in self.below:
            rest.remove(factor)
        return reduce(_product, rest, self.above)


def coefficients(formula: Formula, letter: Formula) -> Polynomial:
    """The coefficients of a formula in a letter, over its smallest common denominator.

    Raises ``ValueError`` if it is no quotient of polynomials in the letter.
    """
    return _fraction(formula, letter).above


def _fraction(formula: Formula, letter: Formula) -> Fraction:
    if formula == letter:
        return Fraction((ZERO, ONE))
    if letter not in formula.nodes():
        return Fraction((formula,))
    match formula:
        case Sum(terms):
            return _sum([_fraction(term, letter) for term in terms])
        case Negative(argument):
            one = _fraction(argument, letter)
            return Fraction(tuple(map(negative, one.above)), one.below)
        case Product(factors):
            each = [_fraction(factor, letter) for factor in factors]
            above = reduce(_product, (one.above for one in each))
            return Fraction(above, tuple(factor for one in each for factor in one.below))
        case Quotient(numerator, denominator):
            top, divisor = (_fraction(one, letter) for one in (numerator, denominator))
            if len(divisor.above) == 1 and not divisor.below:
                over = (divided(one, divisor.above[0]) for one in top.above)
                return Fraction(tuple(over), top.below)
            factors = denominator.factors if isinstance(denominator, Product) else (denominator,)
            parts = [_fraction(one, letter) for one in factors]
            if any(part.below for part in parts):
                raise ValueError("a fraction stands below another one")
            return Fraction(top.above, (*top.below, *(part.above for part in parts)))
        case Power(base, Number(exponent)) if exponent <= _HIGHEST:
            one = _fraction(base, letter)
            return Fraction(reduce(_product, [one.above] * exponent, (ONE,)), one.below * exponent)
    raise ValueError("no quotient of polynomials")


def _sum(terms: list[Fraction]) -> Fraction:
    below: list[Polynomial] = []
    for term in terms:
        have = [*below]
        for factor in term.below:
            if factor in have:
                have.remove(factor)
            else:
                below.append(factor)
    rows = [term.over(below) for term in terms]
    above = tuple(_total(row) for row in zip_longest(*rows, fillvalue=ZERO))
    return Fraction(above, tuple(below))


def _product(one: Polynomial, other: Polynomial) -> Polynomial:
    degree = len(one) + len(other) - 2
    return tuple(
        _total(
            _times(one[k], other[power - k]) for k in range(len(one)) if 0 <= power - k < len(other)
        )
        for power in range(degree + 1)
    )


def _total(terms: Iterable[Formula]) -> Formula:
    rest = [term for term in terms if term != ZERO]
    numbers = [term for term in rest if _integer(term) is not None]
    if len(numbers) > 1:
        rest = [term for term in rest if term not in numbers]
        rest.append(_signed(sum(_integer(term) or 0 for term in numbers)))
    return total(term for term in rest if term != ZERO)


def _times(*factors: Formula) -> Formula:
    """A product with its numbers in one, and its signs."""
    number, rest = 1, list[Formula]()
    for factor in factors:
        if isinstance(factor, Negative):
            number, factor = -number, factor.argument
        for one in factor.factors if isinstance(factor, Product) else (factor,):
            if isinstance(one, Number):
                number *= one.value
            else:
                rest.append(one)
    found = times(Number(abs(number)), *rest) if number else ZERO
    return Negative(found) if number < 0 else found


def _integer(one: Formula) -> int | None:
    match one:
        case Number(value):
            return value
        case Negative(Number(value)):
            return -value
    return None


def _signed(value: int) -> Formula:
    return Number(value) if value >= 0 else Negative(Number(-value))


def negative(one: Formula) -> Formula:
    """A formula with the other sign."""
    return _times(Negative(ONE), one)


def divided(one: Formula, divisor: Formula) -> Formula:
    """A formula over another one."""
    if one == ZERO or divisor == ONE:
        return one
    match one, divisor:
        case (Number(above), Number(below)) if above % below == 0:
            return Number(above // below)
        case (Negative(argument), _):
            return negative(divided(argument, divisor))
    return Quotient(one, divisor)
