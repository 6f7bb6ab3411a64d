"""Elements as formulas, to be shown."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element
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
    Vocabulary,
    read,
)


def formula_of(element: Element, vocabulary: Vocabulary) -> Formula:
    """The formula of an element, numerator over denominator, in the names of its ring."""
    ring = element.ring
    base = [name_formula(name, vocabulary) for name in ring.polynomials.generators]
    roots = [name_formula(name, vocabulary) for name in ring.roots]
    terms: Terms = {}
    for mask, part in element.terms().items():
        extra = tuple(mask >> bit & 1 for bit in range(len(roots)))
        terms |= {exponents + extra: value for exponents, value in part.items()}
    below: list[Formula] = []
    for index, exponent in element.denominator.items():
        divisor = polynomial_formula(ring.polynomials.terms(ring.divisors[index]), base)
        below.append(_power(divisor, exponent))
    return _over(polynomial_formula(terms, [*base, *roots]), below)


def polynomial_formula(terms: Terms, names: Sequence[Formula]) -> Formula:
    """The formula of a polynomial, its terms in descending order."""
    if not terms:
        return Number(0)
    summands = [_term(e, terms[e], names) for e in sorted(terms, reverse=True)]
    return Sum(tuple(summands)) if len(summands) > 1 else summands[0]


def name_formula(name: str, vocabulary: Vocabulary) -> Formula:
    """The formula of a generator: a name, a root, or a symbolic power; a ring of numbers has none."""
    return read(name, vocabulary) if name else Number(1)


def fraction_formula(value: Fraction) -> Formula:
    """The formula of a rational number."""
    size = abs(value)
    shown: Formula = Number(size.numerator)
    if size.denominator != 1:
        shown = Quotient(shown, Number(size.denominator))
    return Negative(shown) if value < 0 else shown


def _term(exponents: tuple[int, ...], value: Fraction, names: Sequence[Formula]) -> Formula:
    factors = [_power(n, e) for n, e in zip(names, exponents, strict=True) if e]
    size = abs(value)
    if size != 1 or not factors:
        factors.insert(0, fraction_formula(size))
    shown = Product(tuple(factors)) if len(factors) > 1 else factors[0]
    return Negative(shown) if value < 0 else shown


def _power(base: Formula, exponent: int) -> Formula:
    return base if exponent == 1 else Power(base, Number(exponent))


def _over(above: Formula, below: list[Formula]) -> Formula:
    if not below:
        return above
    divisor = Product(tuple(below)) if len(below) > 1 else below[0]
    if isinstance(above, Negative):
        return Negative(Quotient(above.argument, divisor))
    return Quotient(above, divisor)
