"""Elements at exact points: numbers in a tower of square roots over the rationals."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from math import isqrt, prod
from operator import add

from kowalevski_cas.algebra.polynomials import Map, Polynomial, Polynomials, Terms
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element, Ring, Summand
from kowalevski_cas.notation import Vocabulary, to_latex

TRIED = 10_000
"""The divisors that are tried to find the square factors of a number."""

NUMBERS = Vocabulary(scalars=frozenset({"i"}))
"""What is needed to print numbers in a tower of roots."""


def number_ring(arithmetic: type[Polynomials]) -> Ring:
    """The rationals with :math:`i` adjoined, as a ring without variables."""
    ring = Ring(arithmetic(("",)))
    ring.adjoin("i", ring.number(-1))
    return ring


def gaussian(numbers: Ring, re: Fraction, im: Fraction) -> Element:
    """The number re + im·i of a :func:`number_ring`."""
    constant = numbers.polynomials.constant
    return Element(numbers, {mask: constant(v) for mask, v in ((0, re), (1, im)) if v}, {})


def square_root(value: Fraction) -> Fraction | None:
    """The rational square root of a rational number, if there is one."""
    if value < 0:
        return None
    top, bottom = isqrt(value.numerator), isqrt(value.denominator)
    if top * top == value.numerator and bottom * bottom == value.denominator:
        return Fraction(top, bottom)
    return None


def rational(element: Element) -> Fraction | None:
    """The value of an element that is a rational number; ``None`` if it is none."""
    parts = element.terms()
    if not parts:
        return Fraction(0)
    if element.denominator or parts.keys() != {0} or any(map(any, parts[0])):
        return None
    (value,) = parts[0].values()
    return value


def is_negative(number: Element) -> bool:
    """Whether a real number is negative; the roots that it is made of are the positive ones."""
    squares = [rational(radicand) or Fraction(0) for radicand in number.ring.radicands]
    parts = [
        (value, int(prod(s for bit, s in enumerate(squares) if mask >> bit & 1)))
        for mask, terms in number.terms().items()
        for value in terms.values()
    ]
    # the roots are independent: what has parts is not zero, and some digits tell its sign
    digits = 32
    while parts:
        unit = Fraction(1, 10**digits)
        roots = [isqrt(square * 100**digits) * unit for _, square in parts]
        found = [(v * root, v * (root + unit)) for (v, _), root in zip(parts, roots, strict=True)]
        if sum(map(min, found)) > 0 or sum(map(max, found)) < 0:
            return sum(map(max, found)) < 0
        digits *= 2
    return False


class Substitution:
    """The homomorphism from ``ring`` to a ring of numbers that an exact point defines.

    ``values`` gives the generators of the polynomials; the roots of the ring
    become rational where their radicands are squares, and are adjoined where not,
    unless their values are given as ``roots``.
    """

    def __init__(
        self,
        ring: Ring,
        values: Mapping[str, Element],
        numbers: Ring,
        roots: dict[int, Element] | None = None,
    ) -> None:
        self.numbers = numbers
        self.ring = ring
        self._inverses: dict[int, Element] = {}
        self.values = [values[name] for name in ring.polynomials.generators]
        self._image = _gaussian(ring.polynomials, self.values, numbers)
        self.roots: dict[int, Element] = {} if roots is None else roots
        """The values of the roots, by their places in the ring."""
        for bit, name in enumerate(ring.roots if roots is None else ()):
            given = values.get(name)
            radicand = ring.radicands[bit]
            self.roots[bit] = root_in(numbers, self(radicand)) if given is None else given

    def __call__(self, element: Element) -> Element:
        """The value of an element; raises ``ZeroDivisionError`` on a zero of its denominator."""
        return reduce(add, map(self._summand, element.summands))

    def _summand(self, summand: Summand) -> Element:
        parts, denominator = summand
        total = self.numbers.zero
        for mask, polynomial in parts.items():
            value = self._polynomial(polynomial)
            for bit, root in self.roots.items() if mask else ():
                if mask >> bit & 1:
                    value = value * root
            total = total + value
        for index, exponent in denominator.items():
            total = total * self._inverse(index) ** exponent
        return total

    def _inverse(self, index: int) -> Element:
        """One over a divisor of the ring; each is computed once."""
        if index not in self._inverses:
            self._inverses[index] = self._polynomial(self.ring.divisors[index]).inverse()
        return self._inverses[index]

    def _polynomial(self, polynomial: Polynomial) -> Element:
        if self._image is not None:
            numbers, value = self.numbers, self._image(polynomial)
            if not numbers.polynomials.occurring_places(value):
                return numbers.element({0: value}, {})
            return _by_unit(numbers.polynomials.terms(value), numbers)
        terms = self.ring.polynomials.terms(polynomial)
        return substitute(terms, self.values.__getitem__, self.numbers)


def root_in(numbers: Ring, radicand: Element) -> Element:
    """A square root of a number, adjoined to a ring of numbers if it has to be."""
    value = rational(radicand)
    if value == -1:
        return numbers.generator("i")
    if value is not None and (root := square_root(value)) is not None:
        return numbers.number(root)
    if value is None:
        return _adjoin(numbers, radicand)
    whole = value.numerator * value.denominator
    found = numbers.number(Fraction(1, value.denominator))
    if whole < 0:
        found = found * numbers.generator("i")
    for prime, exponent in prime_factors(abs(whole)):
        found = found * numbers.number(prime ** (exponent // 2))
        if exponent % 2:  # roots of primes do not depend on each other
            found = found * _adjoin(numbers, numbers.number(prime))
    return found


def _adjoin(numbers: Ring, radicand: Element) -> Element:
    name = rf"\sqrt{{{to_latex(formula_of(radicand, NUMBERS))}}}"
    return numbers.generator(name) if name in numbers.roots else numbers.adjoin(name, radicand)


def substitute(terms: Terms, value_of: Callable[[int], Element], ring: Ring) -> Element:
    """What a polynomial becomes in a ring, by what its generators are there, at their places.

    What terms have in common is multiplied once: place after place, by the powers that occur.
    """
    if not terms:
        return ring.zero
    places = [place for place, powers in enumerate(zip(*terms, strict=True)) if any(powers)]

    def put(terms: Terms, depth: int) -> Element:
        if depth == len(places):
            return ring.number(*terms.values())
        place = places[depth]
        by_power: dict[int, dict[tuple[int, ...], Fraction]] = {}
        for exponents, coefficient in terms.items():
            by_power.setdefault(exponents[place], {})[exponents] = coefficient
        total = ring.zero
        for exponent, group in by_power.items():
            value = put(group, depth + 1)
            total = total + (value_of(place) ** exponent * value if exponent else value)
        return total

    return put(terms, 0)


def prime_factors(number: int) -> Iterator[tuple[int, int]]:
    """The prime factors of a positive number; beyond what is tried, what is left counts as one."""
    from flint import fmpz

    for prime, exponent in fmpz(number).factor(trial_limit=TRIED):
        root = prime.isqrt()
        yield (int(root), 2 * exponent) if root**2 == prime else (int(prime), exponent)


def _gaussian(polynomials: Polynomials, values: Sequence[Element], numbers: Ring) -> Map | None:
    """What puts in values that are rational but for i, with a letter for i; else ``None``."""
    if numbers.polynomials.generators != ("",) or numbers.roots[:1] != ["i"]:
        return None
    if any(value.denominator or value.parts.keys() - {0, 1} for value in values):
        return None
    zero, letter = numbers.polynomials.zero, numbers.polynomials.generator(0)
    found = []
    for value in values:
        re, im = value.parts.get(0, zero), value.parts.get(1)
        found.append(re if im is None else re + im * letter)
    return polynomials.substitution(found, numbers.polynomials)


def _by_unit(terms: Terms, numbers: Ring) -> Element:
    """The number that a polynomial in a letter for i is, by i² = −1."""
    parts = [Fraction(0), Fraction(0)]
    for (exponent,), value in terms.items():
        parts[exponent & 1] += -value if exponent & 2 else value
    return gaussian(numbers, *parts)


def rank(matrix: list[list[Element]]) -> int:
    """The rank of a matrix of numbers, by elimination."""
    rows = [row for row in matrix if any(not entry.is_zero for entry in row)]
    found = 0
    while rows:
        pivot = rows.pop()
        column = next((k for k, entry in enumerate(pivot) if not entry.is_zero), None)
        if column is None:
            continue
        found += 1
        inverse = pivot[column].inverse()
        rows = [
            row if row[column].is_zero else _less(row, row[column] * inverse, pivot) for row in rows
        ]
    return found


def dependence(matrix: list[list[Element]]) -> list[Element] | None:
    """Numbers, not all zero, with which rows add up to zero; ``None`` if they are independent."""
    size, width = len(matrix), max(map(len, matrix), default=0)
    ring = matrix[0][0].ring if width else None
    unit = [] if ring is None else [ring.zero, ring.one]
    rows = [[*row, *(unit[j == k] for j in range(size))] for k, row in enumerate(matrix)]
    while rows:
        pivot = rows.pop()
        column = next((k for k in range(width) if not pivot[k].is_zero), None)
        if column is None:
            return pivot[width:]
        inverse = pivot[column].inverse()
        rows = [
            row if row[column].is_zero else _less(row, row[column] * inverse, pivot) for row in rows
        ]
    return None


def independent(matrix: list[list[Element]]) -> bool:
    """Whether rows are certainly independent: by elimination with what has an inverse only.

    Among numbers with open roots there are divisors of zero.
    """
    rows = [*matrix]
    while rows:
        pivot = rows.pop()
        found = next(((k, i) for k, e in enumerate(pivot) if (i := inverse_of(e))), None)
        if found is None:
            return False
        column, inverse = found
        rows = [
            row if row[column].is_zero else _less(row, row[column] * inverse, pivot) for row in rows
        ]
    return True


def inverse_of(number: Element) -> Element | None:
    """One over a number; ``None`` for zero, and for its divisors."""
    try:
        return number.inverse()
    except ZeroDivisionError:
        return None


def _less(row: list[Element], factor: Element, pivot: list[Element]) -> list[Element]:
    return [a if b.is_zero else a - factor * b for a, b in zip(row, pivot, strict=True)]
