r"""Arguments of functions as sums of products with rational factors: :math:`\omega t-\theta/2`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import reduce

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    once,
    power,
    times,
    to_latex,
    total,
)
from kowalevski_cas.problem.space import Meaningless

Monomial = tuple[tuple[Formula, int], ...]
"""Formulas that are no products, with their exponents, each once and in one order."""

Combination = Mapping[Monomial, Fraction]
"""A sum of products with rational factors."""


@once
def combination(formula: Formula) -> Combination:
    r"""The sum of products that a formula is; what is no sum or product stands for itself.

    >>> from kowalevski_cas.notation import Vocabulary, read
    >>> [*combination(read(r"2(x-\frac{y}{2})", Vocabulary("xy"))).values()]
    [Fraction(2, 1), Fraction(-1, 1)]
    """
    match formula:
        case Number(value):
            return {(): Fraction(value)} if value else {}
        case Negative(argument):
            return _product(combination(argument), {(): Fraction(-1)})
        case Sum(terms):
            found: dict[Monomial, Fraction] = {}
            for term in terms:
                for monomial, factor in combination(term).items():
                    found[monomial] = found.get(monomial, Fraction(0)) + factor
            return {monomial: factor for monomial, factor in found.items() if factor}
        case Product(factors):
            return reduce(_product, map(combination, factors), {(): Fraction(1)})
        case Quotient(above, below):
            return _product(combination(above), _inverse(combination(below), below))
        case Power(base, Number(exponent)):
            return combination(Product((base,) * exponent))
    return {((formula, 1),): Fraction(1)}


def _product(left: Combination, right: Combination) -> Combination:
    found: dict[Monomial, Fraction] = {}
    for one, a in left.items():
        for other, b in right.items():
            exponents = dict(one)
            for formula, exponent in other:
                exponents[formula] = exponents.get(formula, 0) + exponent
            whole = sorted(((f, e) for f, e in exponents.items() if e), key=_order)
            found[tuple(whole)] = found.get(tuple(whole), Fraction(0)) + a * b
    return {monomial: factor for monomial, factor in found.items() if factor}


def _order(part: tuple[Formula, int]) -> tuple[bool, str]:
    """As in LaTeX, but for the time, which is printed last."""
    tex = to_latex(part[0])
    return tex in ("t", r"\tau"), tex


def _inverse(below: Combination, formula: Formula) -> Combination:
    if len(below) != 1:
        return {((formula, -1),): Fraction(1)}
    ((monomial, factor),) = below.items()
    return {tuple((base, -exponent) for base, exponent in monomial): 1 / factor}


def product_of(monomial: Monomial, over: int = 1) -> Formula:
    r"""A product, over a whole number, as a formula.

    >>> to_latex(product_of(((Name("x"), 1), (Name("y"), -1)), 2))
    '\\frac{x}{2y}'
    """
    above = times(*(power(base, e) for base, e in monomial if e > 0))
    below = times(Number(over), *(power(base, -e) for base, e in monomial if e < 0))
    return above if below == Number(1) else Quotient(above, below)


def names_in(monomial: Monomial) -> Iterator[str]:
    """The names in a product."""
    for formula, _ in monomial:
        yield from sorted(formula.names())


def single_name(monomial: Monomial) -> str | None:
    """The name that a product is; ``None`` if it is none."""
    match monomial:
        case ((Name(name), 1),):
            return name
    return None


def is_arithmetic(formula: Formula) -> bool:
    """Whether a formula is made of names and numbers by arithmetic and roots."""
    return isinstance(formula, _ARITHMETIC) and all(map(is_arithmetic, formula.children()))


_ARITHMETIC = (Name, Number, Sum, Negative, Product, Quotient, Power, Root)


def multiple(argument: Formula, count: int) -> Formula:
    """A whole multiple of an argument; a number below a line is cancelled."""
    whole = times(Number(abs(count)), argument)
    if isinstance(argument, Quotient) and isinstance(argument.denominator, Number):
        factor = Fraction(abs(count), argument.denominator.value)
        above = times(Number(factor.numerator), argument.numerator)
        below = Number(factor.denominator)
        whole = above if below == Number(1) else Quotient(above, below)
    return whole if count > 0 else Negative(whole)


def by_name(monomial: Monomial, name: str) -> Formula:
    """The derivative of a product of names by one of them."""
    found: list[Formula] = []
    for formula, exponent in monomial:
        if formula == Name(name):
            rest = tuple((f, e - (f == formula)) for f, e in monomial)
            by = product_of(tuple((f, e) for f, e in rest if e))
            found.append(times(Number(abs(exponent)), by))
            if exponent < 0:
                found[-1] = Negative(found[-1])
        elif name in formula.names():
            raise Meaningless(f"print the derivative of {to_latex(formula)} by {name}", name)
    return total(found)
