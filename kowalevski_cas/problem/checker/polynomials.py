"""Polynomials over the rational numbers; some generators are roots of other polynomials."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from math import gcd, isqrt, lcm, prod

from .reading import BITS, DEGREE, NAMES, Budget, need

WIDTH = 11  # bits of an exponent in a monomial; the highest of them stays free
MASK = (1 << WIDTH) - 1
Terms = dict[int, int]


class Ring:
    """Polynomials over the rational numbers in generators, of which some obey relations.

    A monomial is an integer: the total degree in its lowest bits, then the exponents of the
    generators, in the order in which these were adjoined. Such integers add and compare as
    monomials multiply and compare.
    """

    def __init__(self, budget: Budget) -> None:
        self.budget, self.spend = budget, budget.spend
        self.at: dict[str, int] = {}
        self.unit: dict[str, int] = {}
        self.roots: dict[str, Element] = {}  # the squares of generators
        self.divisors: dict[str, Element] = {}  # of which generators are the inverses
        self.powers: dict[str, tuple[Element, Element]] = {}  # bases and exponents
        self.unknown: set[str] = set()  # what may depend on all other names
        self.squares, self.guard = 0, 1 << WIDTH - 1

    def another(self) -> Ring:
        """A ring without generators; the work in both is counted together."""
        return Ring(self.budget)

    def adjoin(self, name: str) -> Element:
        """A new generator."""
        need(name not in self.at and len(self.at) < NAMES, "names are too many, or given twice")
        shift = WIDTH * (len(self.at) + 1)
        self.at[name], self.unit[name] = shift, (1 << shift) + 1
        self.guard |= 1 << shift + WIDTH - 1
        return self.generator(name)

    def relate(self, name: str, square: Element) -> None:
        """Give a generator its square."""
        self.roots[name] = square
        self.squares |= MASK - 1 << self.at[name]

    def generator(self, name: str) -> Element:
        """A generator as a polynomial."""
        return Element(self, {self.unit[name]: 1})

    def number(self, value: int | Fraction) -> Element:
        """A number as a polynomial."""
        return Element(self, {0: value.numerator}, value.denominator)

    def total(self, elements: Iterable[Element]) -> Element:
        """The sum of elements."""
        found, below, out = [e for e in elements if e.terms], 1, Terms()
        self.spend(1)
        if len(found) == 1:
            return found[0]
        for e in found:
            below = lcm(below, e.below)
            need(below.bit_length() <= BITS, "a number is too large")
            self.spend(1 + (below.bit_length() ** 2 >> 14))
        for e in found:
            factor = below // e.below
            self.spend(len(e.terms) * (1 + (e.bits * factor.bit_length() >> 16)))
            for m, c in e.terms.items():
                out[m] = out.get(m, 0) + factor * c
        return Element(self, out, below)


class Element:
    """A polynomial: integer coefficients, and a positive integer below them."""

    __slots__ = ("below", "bits", "ring", "terms")

    def __init__(self, ring: Ring, terms: Terms, below: int = 1) -> None:
        bits = max(below.bit_length(), max(map(int.bit_length, terms.values()), default=0))
        need(bits <= BITS, "a number is too large")
        ring.spend(5 + len(terms) * (1 + (bits * below.bit_length() >> 14)))
        common = gcd(below, *terms.values()) if below > 1 else 1
        self.ring, self.below, self.bits = ring, below // common, bits
        self.terms = {m: c // common for m, c in terms.items() if c}

    def __neg__(self) -> Element:
        return Element(self.ring, {m: -c for m, c in self.terms.items()}, self.below)

    def __add__(self, other: Element) -> Element:
        return self.ring.total((self, other))

    def __sub__(self, other: Element) -> Element:
        return self.ring.total((self, -other))

    def __mul__(self, other: Element) -> Element:
        ring, out, a, b = self.ring, Terms(), self.terms, other.terms
        need(self.degree() + other.degree() <= DEGREE, "a degree is too large")
        ring.spend(len(a) * len(b) * (1 + (self.bits * other.bits >> 16)))
        for m, c in a.items():
            for n, d in b.items():
                out[m + n] = out.get(m + n, 0) + c * d
        return Element(ring, out, self.below * other.below).reduced()

    def __pow__(self, exponent: int) -> Element:
        if not exponent:
            return self * self.ring.number(0) + self.ring.number(1)
        return reduce(Element.__mul__, [self] * exponent)

    def degree(self) -> int:
        """The total degree."""
        return max([m & MASK for m in self.terms], default=0)

    def reduced(self) -> Element:
        """The same with each root in the first power at most."""
        ring, value = self.ring, self
        for name in reversed(ring.roots):
            shift, square, root = ring.at[name], 2 * ring.unit[name], ring.roots[name]
            while (bits := reduce(int.__or__, value.terms, 0)) & ring.squares:
                if bits >> shift & MASK < 2:
                    break
                high = {m - square: c for m, c in value.terms.items() if m >> shift & MASK > 1}
                need(max(m & MASK for m in high) + root.degree() <= DEGREE, "a degree is too large")
                size = 1 + (value.bits * root.bits >> 16)
                ring.spend(len(value.terms) + len(high) * len(root.terms) * size)
                out = {m: root.below * c for m, c in value.terms.items() if m - square not in high}
                for m, c in high.items():
                    for n, d in root.terms.items():
                        out[m + n] = out.get(m + n, 0) + c * d
                value = Element(ring, out, value.below * root.below)
        return value

    def generators(self) -> list[str]:
        """The generators that occur."""
        self.ring.spend(1 + (len(self.terms) + len(self.ring.at) >> 3))
        bits = reduce(int.__or__, self.terms, 0)
        return [name for name, shift in self.ring.at.items() if bits >> shift & MASK]

    def split(self, name: str) -> dict[int, Element]:
        """The coefficients as a polynomial in one generator."""
        found: dict[int, Terms] = {}
        shift, unit = self.ring.at[name], self.ring.unit[name]
        for m, c in self.terms.items():
            e = m >> shift & MASK
            found.setdefault(e, {})[m - e * unit] = c
        return {e: Element(self.ring, terms, self.below) for e, terms in found.items()}

    def partial(self, name: str) -> Element:
        """The derivative by one generator, while the others stay."""
        shift, unit = self.ring.at[name], self.ring.unit[name]
        terms = {m - unit: c * e for m, c in self.terms.items() if (e := m >> shift & MASK)}
        return Element(self.ring, terms, self.below)

    def flipped(self, name: str) -> Element:
        """The same for the other value of a root."""
        shift = self.ring.at[name]
        terms = {m: -c if m >> shift & 1 else c for m, c in self.terms.items()}
        return Element(self.ring, terms, self.below)

    def normed(self) -> tuple[Element, Element]:
        """The product of the other values for all signs of the roots, and with it the norm."""
        above, norm = self.ring.number(1), self
        for name in reversed(self.ring.roots):
            if name in norm.generators():
                other = norm.flipped(name)
                above, norm = above * other, norm * other
        return above, norm

    def cleared(self) -> tuple[Element, Element]:
        """The element times powers of the divisors that clear it of their inverses; and these."""
        value, powers = self, self.ring.number(1)
        for name in self.generators():
            if divisor := self.ring.divisors.get(name):
                top = max(parts := value.split(name), default=0)
                value = self.ring.total(p * divisor ** (top - e) for e, p in parts.items())
                powers = powers * divisor**top
        return value, powers

    def vanishes(self) -> bool:
        """Whether it is zero wherever it is defined."""
        return not self.cleared()[0].terms

    def differs(self) -> bool:
        """Whether a number is certainly not zero, whatever the signs of its roots."""
        return bool(self.normed()[1].terms)

    def is_negative(self) -> bool:
        """Whether a number is negative, or may be; its roots are the positive ones."""
        squares = {name: self.ring.roots[name].value() or 0 for name in self.generators()}
        if not self.terms or min(squares.values(), default=1) < 1:
            return bool(self.terms)
        low = 0
        self.ring.spend(len(self.terms) << 4)
        for m, c in self.terms.items():
            square = prod(squares[n].numerator for n in squares if m >> self.ring.at[n] & MASK)
            root = isqrt(c * c * square << 2 * BITS)  # rounded off; that of a square is exact
            low += root if c > 0 else -root - (root * root < c * c * square << 2 * BITS)
        return low < 0

    def value(self) -> Fraction | None:
        """The number that it is, if it is one."""
        return Fraction(self.terms.get(0, 0), self.below) if self.terms.keys() <= {0} else None

    def primitive(self) -> tuple[Fraction, Element]:
        """A number, and integers without a common factor, of which this is the product."""
        common = gcd(*self.terms.values()) * (-1 if self.terms[max(self.terms)] < 0 else 1)
        terms = {m: c // common for m, c in self.terms.items()}
        return Fraction(common, self.below), Element(self.ring, terms)

    def over(self, divisor: Element) -> Element | None:
        """The quotient by a primitive polynomial, if it is a polynomial; neither has roots."""
        self.ring.spend(1 + (len(self.terms) + len(divisor.terms) >> 4))
        guard, first, last = self.ring.guard, max(divisor.terms), min(divisor.terms)
        rest, out = dict(self.terms), Terms()
        while rest:
            top, low = max(rest), min(rest)
            count, left = divmod(rest[top], divisor.terms[first])
            if left or ((top | guard) - first & (low | guard) - last & guard) != guard:
                return None
            need(count.bit_length() <= BITS, "a number is too large")
            self.ring.spend((len(divisor.terms) + len(rest)) * (1 + (count.bit_length() >> 6)))
            out[top - first] = count
            for m, c in divisor.terms.items():
                rest[m + top - first] = rest.get(m + top - first, 0) - count * c
                if not rest[m + top - first]:
                    del rest[m + top - first]
        return Element(self.ring, out, self.below)

    def words(self) -> str:
        """The polynomial in plain letters, up to a number."""
        self.ring.spend(1 + (len(self.terms) * len(self.ring.at) >> 3))
        shown = []
        for m, c in sorted(self.terms.items(), reverse=True):
            powers = [(name, m >> shift & MASK) for name, shift in self.ring.at.items()]
            parts = [name if e == 1 else f"{name} ^ {e}" for name, e in powers if e]
            shown.append(" * ".join([str(c), *parts] if c != 1 or not parts else parts))
        return f"({' + '.join(shown)})"
