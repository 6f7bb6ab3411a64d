"""Elements as formulas, to be shown."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from math import lcm

from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.tower import Element, Ring
from kowalevski_cas.notation import (
    Application,
    Formula,
    Name,
    Negative,
    NotationError,
    Number,
    Power,
    Product,
    Quotient,
    Vocabulary,
    read,
    times,
    total,
)

# Python turns at most 4300 digits, which are 14,284 bits, into text
LONGEST = 14_000
"""The bits of the longest number that is printed."""

Polynomial = Callable[[Terms, Sequence[Formula]], Formula]
"""How the formula of a polynomial is written."""


def formula_of(element: Element, vocabulary: Vocabulary) -> Formula:
    """The formula of an element in the names of its ring as they are read, to be shown.

    A root above the line with its square below it goes below.
    """
    return _read(element, vocabulary, polynomial_formula)


def product_of(element: Element, vocabulary: Vocabulary) -> Formula:
    """The same formula, with polynomials in their irreducible factors."""
    return _read(element, vocabulary, _product)


def _read(element: Element, vocabulary: Vocabulary, polynomial: Polynomial) -> Formula:
    ring, terms, below, divisors = _cancel(element)
    names = [name_formula(name, vocabulary) for name in ring.names]
    width = len(ring.polynomials.generators)
    shown = []
    for bit, radicand in enumerate(ring.radicands if below else ()):
        inner = _generators_of(radicand, divisors)
        if inner is None or any(not below.get(index) for index in inner):
            continue
        if terms and all(exponents[width + bit] for exponents in terms):
            terms = {_lower(exponents, width + bit): v for exponents, v in terms.items()}
            for index in inner:
                below[index] -= 1
            shown.append(names[width + bit])
    return _fraction(terms, below, divisors, names, polynomial, shown)


def formula_in(element: Element) -> Formula:
    """The formula of an element in which the generators and roots of its ring are names."""
    ring, terms, below, divisors = _cancel(element)
    plain: list[Formula] = [Name(name) for name in ring.polynomials.generators]
    names = list(plain)
    for root, under in zip(ring.roots, ring.below, strict=True):
        # The generator is the root times what it is over.
        over = None if under is None else polynomial_formula(under.terms()[0], plain)
        names.append(Name(root) if over is None else Product((over, Name(root))))
    return _fraction(terms, below, divisors, names, polynomial_formula)


def formula_rows(rows: Iterable[Iterable[Element]]) -> tuple[tuple[Formula, ...], ...]:
    """Rows of elements as formulas."""
    return tuple(tuple(map(formula_in, row)) for row in rows)


def _cancel(element: Element) -> tuple[Ring, Terms, dict[int, int], dict[int, Terms]]:
    """The numerator, the divisors that are left below it, and all divisors, in neutral form."""
    from kowalevski_cas.algebra.factors import exact_quotient

    ring = element.ring
    terms: Terms = {}
    for mask, part in element.terms().items():
        extra = tuple(mask >> bit & 1 for bit in range(len(ring.roots)))
        terms |= {exponents + extra: value for exponents, value in part.items()}
    below: dict[int, int] = {}
    divisors: dict[int, Terms] = {}
    for index, exponent in element.denominator.items():
        divisors[index] = {
            exponents + (0,) * len(ring.roots): value
            for exponents, value in ring.polynomials.terms(ring.divisors[index]).items()
        }
        for _ in range(exponent):
            quotient = exact_quotient(terms, divisors[index])
            if quotient is None:
                below[index] = below.get(index, 0) + 1
            else:
                terms = quotient
    return ring, terms, below, divisors


def _fraction(
    terms: Terms,
    below: Mapping[int, int],
    divisors: Mapping[int, Terms],
    names: Sequence[Formula],
    polynomial: Polynomial,
    roots: Sequence[Formula] = (),
) -> Formula:
    """A polynomial with integer coefficients over a number, divisors and roots."""
    factor = lcm(*(value.denominator for value in terms.values()))
    top = polynomial({e: v * factor for e, v in terms.items()}, names)
    bottom: list[Formula] = [Number(factor)] if factor > 1 else []
    for index, exponent in below.items():
        divisor = polynomial(divisors[index], names)
        if isinstance(divisor, Negative):
            divisor = divisor.argument
            if exponent % 2:
                top = top.argument if isinstance(top, Negative) else Negative(top)
        if exponent:
            power = power_formula(divisor, exponent)
            bottom += power.factors if isinstance(power, Product) else (power,)
    return _over(top, [*bottom, *roots])


def _generators_of(radicand: Element, divisors: dict[int, Terms]) -> list[int] | None:
    """The divisors whose product a radicand is, if it is a product of different generators."""
    parts = radicand.terms()
    if parts.keys() != {0} or len(parts[0]) != 1:
        return None
    ((exponents, value),) = parts[0].items()
    if value != 1 or max(exponents) > 1 or not any(exponents):
        return None
    singles = {
        next(iter(terms)).index(1): index
        for index, terms in divisors.items()
        if len(terms) == 1 and sum(next(iter(terms))) == 1
    }
    places = [place for place, exponent in enumerate(exponents) if exponent]
    return [singles[p] for p in places] if all(p in singles for p in places) else None


def _lower(exponents: tuple[int, ...], place: int) -> tuple[int, ...]:
    return (*exponents[:place], exponents[place] - 1, *exponents[place + 1 :])


def polynomial_formula(terms: Terms, names: Sequence[Formula]) -> Formula:
    """The formula of a polynomial, its terms in descending order."""
    return _sum(terms, names, sorted(terms, reverse=True))


def _sum(terms: Terms, names: Sequence[Formula], order: Sequence[tuple[int, ...]]) -> Formula:
    power = cache(lambda place, exponent: power_formula(names[place], exponent))
    return total(
        multiple(terms[e], [power(place, exponent) for place, exponent in enumerate(e) if exponent])
        for e in order
    )


def _product(terms: Terms, names: Sequence[Formula]) -> Formula:
    """The formula of a polynomial in its irreducible factors, each with a positive term first."""
    if len(terms) < 2:
        return polynomial_formula(terms, names)
    from kowalevski_cas.algebra.factors import irreducible_factors

    number, factors = terms[max(terms)], irreducible_factors(terms)
    factors.sort(key=lambda factor: (len(factor[0]), [-e for e in max(factor[0])]))
    shown = []
    for factor, exponent in factors:
        number /= factor[max(factor)] ** exponent
        if exponent % 2 and number < 0 and min(factor.values()) < 0:
            number, factor = -number, {e: -v for e, v in factor.items()}
        order = sorted(factor, reverse=True)
        first = next(e for e in order if factor[e] > 0)
        order.sort(key=lambda e: e != first)
        shown.append(power_formula(_sum(factor, names, order), exponent))
    return multiple(number, shown)


@cache
def name_formula(name: str, vocabulary: Vocabulary) -> Formula:
    """The formula of a generator: a name, a root, or a power; a ring of numbers has none.

    What is no name of a paper, as an unknown coefficient, stands for itself.
    """
    try:
        return read(name, vocabulary) if name else Number(1)
    except NotationError:
        return Name(name)


def fraction_formula(value: Fraction) -> Formula:
    """The formula of a rational number.

    Raises:
        OverflowError: if it is longer than anybody prints, or Python does.
    """
    size = abs(value)
    if max(size.numerator, size.denominator).bit_length() > LONGEST:
        raise OverflowError("a number is too long to be printed")
    shown: Formula = Number(size.numerator)
    if size.denominator != 1:
        shown = Quotient(shown, Number(size.denominator))
    return Negative(shown) if value < 0 else shown


def multiple(value: Fraction, factors: Iterable[Formula]) -> Formula:
    """A product with a rational number before it, and the sign before that."""
    shown = times(fraction_formula(abs(value)), *factors)
    return Negative(shown) if value < 0 else shown


def power_formula(base: Formula, exponent: int) -> Formula:
    """A power with a whole exponent; that of a power, or of an exponential function, is one."""
    if exponent == 1:
        return base
    match base:
        case Application(r"\exp", (Quotient(above, Number(below)),)) if exponent % below == 0:
            return Application(r"\exp", (multiple(Fraction(exponent // below), (above,)),))
        case Power(own, Number(value)):
            return Power(own, Number(value * exponent))
    return Power(base, Number(exponent))


def _over(above: Formula, below: list[Formula]) -> Formula:
    if not below:
        return above
    divisor = times(*below)
    if isinstance(above, Negative):
        return Negative(Quotient(above.argument, divisor))
    return Quotient(above, divisor)
