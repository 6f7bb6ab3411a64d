"""Polynomials over the rational numbers; some generators are roots of other polynomials."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from math import gcd, isqrt, lcm, prod
from operator import or_

from .reading import BITS, DEGREE, NAMES, Budget, need

WIDTH = 11  # bits of an exponent in a monomial; the highest of them stays free
MASK = (1 << WIDTH) - 1
FEW = 256  # bits
Terms = dict[int, int]


class Ring:
    """Polynomials over the rational numbers in generators, of which some obey relations.

    A monomial is an integer: the total degree in its lowest bits, then the exponents of the
    generators, in the order in which these were adjoined. Such integers add and compare as
    monomials multiply and compare.
    """

    def __init__(self, budget: Budget) -> None:
        self.budget, self.spend = budget, budget.spend
        self.names = list[str]()  # of the generators
        self.at: dict[str, int] = {}
        self.unit: dict[str, int] = {}
        self.numbers: dict[int | Fraction, Element] = {}
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
        self.names.append(name)
        shift = WIDTH * len(self.names)
        self.at[name], self.unit[name] = shift, (1 << shift) + 1
        self.guard |= 1 << shift + WIDTH - 1
        return self.generator(name)

    def relate(self, name: str, square: Element) -> None:
        """Give a generator its square."""
        self.roots[name] = square
        self.squares |= MASK - 1 << self.at[name]

    def generator(self, name: str) -> Element:
        """A generator as a polynomial."""
        return Element(self, {self.unit[name]: 1}, 1, 1)

    def number(self, value: int | Fraction) -> Element:
        """A number as a polynomial."""
        if value not in self.numbers:
            above, below = value.as_integer_ratio()
            bits = max(above.bit_length(), below.bit_length())
            self.numbers[value] = Element(self, {0: above}, below, bits)
        return self.numbers[value]

    def exponents(self, monomial: int) -> list[tuple[str, int]]:
        """The generators in a monomial, with their exponents."""
        found = list[tuple[str, int]]()
        while (k := (monomial.bit_length() - 1) // WIDTH) > 0:
            found.append((self.names[k - 1], monomial >> k * WIDTH))
            monomial &= (1 << k * WIDTH) - 1
        self.spend(len(found))
        return found[::-1]

    def total(self, elements: Iterable[Element]) -> Element:
        """The sum of elements."""
        return self.combination((1, e) for e in elements)

    def combination(self, parts: Iterable[tuple[int, Element]], below: int = 1) -> Element:
        """The sum of elements times integers, divided by an integer."""
        every, common, out = [*parts], 1, Terms()
        found = [part for part in every if part[1].terms]
        self.spend(1 + len(every))
        if len(found) == 1 and found[0][0] == below == 1:
            return found[0][1]
        for other in {e.below for _, e in found}:
            common = lcm(common, other)
            need(common.bit_length() <= BITS, "a number is too large")
            self.spend(1 + (common.bit_length() ** 2 >> 14))
        bits = (below * common).bit_length()
        for c, e in found:
            factor = c * (common // e.below)
            bits = max(bits, e.bits + factor.bit_length())
            self.spend(len(e.terms) * (1 + (e.bits * factor.bit_length() >> 16)))
            for m, d in e.terms.items():
                out[m] = out.get(m, 0) + factor * d
        return Element(self, out, below * common, bits + len(found).bit_length())

    def product(self, elements: Iterable[Element]) -> Element:
        """The product of elements: of the monomials first, which is one more factor of the rest."""
        monomial, count, below, bits, steps, sums = 0, 1, 1, 1, 5, list[Element]()
        for e in elements:
            if not e.terms:
                self.spend(steps)
                return e
            if len(e.terms) > 1:
                sums.append(e)
                continue
            ((m, c),) = e.terms.items()
            steps += 1 + (bits * e.bits >> 16)
            monomial, count, below, bits = monomial + m, count * c, below * e.below, bits + e.bits
            if bits > FEW:
                bits = max(count.bit_length(), below.bit_length())
            need(monomial & MASK <= DEGREE and bits <= BITS, "a degree or number is too large")
        self.spend(steps)
        if not sums or monomial or count != 1 or below != 1:
            sums.append(Element(self, {monomial: count}, below, bits).reduced(monomial))
        return reduce(Element.times, sums)


def degree(monomials: Iterable[int]) -> int:
    """The largest total degree."""
    return max((m & MASK for m in monomials), default=0)


class Element:
    """A polynomial: integer coefficients, and a positive integer below them.

    None of these has more than so many bits; that is no more than a bound while they are few.
    """

    __slots__ = ("below", "bits", "ring", "terms")

    def __init__(self, ring: Ring, terms: Terms, below: int, bits: int) -> None:
        if bits > FEW:
            bits = max(below.bit_length(), max(map(int.bit_length, terms.values()), default=0))
            need(bits <= BITS, "a number is too large")
        ring.spend(5 + len(terms) * (1 + (bits * below.bit_length() >> 14)))
        if below > 1 and (common := gcd(below, *terms.values())) > 1:
            below, terms = below // common, {m: c // common for m, c in terms.items()}
        if 0 in terms.values():
            terms = {m: c for m, c in terms.items() if c}
        self.ring, self.terms, self.below, self.bits = ring, terms, below, bits

    def __neg__(self) -> Element:
        return self.over_same({m: -c for m, c in self.terms.items()})

    def __add__(self, other: Element) -> Element:
        return self.ring.combination([(1, self), (1, other)])

    def __sub__(self, other: Element) -> Element:
        return self.ring.combination([(1, self), (-1, other)])

    def __mul__(self, other: Element) -> Element:
        return self.ring.product((self, other))

    def __pow__(self, exponent: int) -> Element:
        return self.ring.product([self] * exponent)

    def times(self, other: Element) -> Element:
        """The product, term by term."""
        few, many = (self, other) if len(self.terms) <= len(other.terms) else (other, self)
        size = len(few.terms) * len(many.terms)
        self.ring.spend(size * (1 + (few.bits * many.bits >> 16)))
        if not few.terms:  # roots of squares have divisors of zero
            return few
        (m, c), *rest = few.terms.items()
        out = {m + n: c * d for n, d in many.terms.items()}
        for m, c in rest:
            for n, d in many.terms.items():
                k = m + n
                out[k] = out.get(k, 0) + c * d
        union = reduce(or_, out)
        need(union & MASK <= DEGREE or degree(out) <= DEGREE, "a degree is too large")
        bits = few.bits + many.bits + len(few.terms).bit_length()
        return Element(self.ring, out, few.below * many.below, bits).reduced(union)

    def reduced(self, union: int) -> Element:
        """The same with each root in the first power at most; all monomials are in the union."""
        ring, value = self.ring, self
        for name, root in reversed(ring.roots.items()) if union & ring.squares else ():
            mask, square = MASK - 1 << ring.at[name], 2 * ring.unit[name]
            while high := {m - square: c for m, c in value.terms.items() if m & mask}:
                need(degree(high) + degree(root.terms) <= DEGREE, "a degree is too large")
                size = len(high) * len(root.terms) * (1 + (value.bits * root.bits >> 16))
                ring.spend(len(value.terms) + size)
                out = {m: root.below * c for m, c in value.terms.items() if not m & mask}
                for m, c in high.items():
                    for n, d in root.terms.items():
                        k = m + n
                        out[k] = out.get(k, 0) + c * d
                bits = value.bits + root.bits + len(root.terms).bit_length() + 1
                value = Element(ring, out, value.below * root.below, bits)
        return value

    def over_same(self, terms: Terms, bits: int = 0) -> Element:
        """Other terms over the same integer, with so many bits more at most."""
        return Element(self.ring, terms, self.below, self.bits + bits)

    def generators(self) -> list[str]:
        """The generators that occur."""
        self.ring.spend(1 + (len(self.terms) >> 3))
        return [name for name, _ in self.ring.exponents(reduce(or_, self.terms, 0))]

    def split(self, name: str) -> dict[int, Element]:
        """The coefficients as a polynomial in one generator."""
        found: dict[int, Terms] = {}
        shift, unit = self.ring.at[name], self.ring.unit[name]
        for m, c in self.terms.items():
            e = m >> shift & MASK
            found.setdefault(e, {})[m - e * unit] = c
        return {e: self.over_same(terms) for e, terms in found.items()}

    def partial(self, name: str) -> Element:
        """The derivative by one generator, while the others stay."""
        self.ring.spend(len(self.terms))
        shift, unit = self.ring.at[name], self.ring.unit[name]
        terms = {m - unit: c * e for m, c in self.terms.items() if (e := m >> shift & MASK)}
        return self.over_same(terms, WIDTH)

    def flipped(self, name: str) -> Element:
        """The same for the other value of a root."""
        shift = self.ring.at[name]
        terms = {m: -c if m >> shift & 1 else c for m, c in self.terms.items()}
        return self.over_same(terms)

    def normed(self) -> tuple[Element, Element]:
        """The product of the other values for all signs of the roots, and with it the norm."""
        above, norm, roots = self.ring.number(1), self, self.ring.roots
        for name in reversed(roots) if roots.keys() & self.generators() else ():
            if name in norm.generators():
                other = norm.flipped(name)
                above, norm = above * other, norm * other
        return above, norm

    def cleared(self) -> tuple[Element, Element]:
        """The element times powers of the divisors that clear it of their inverses; and these."""
        value, powers = self, self.ring.number(1)
        for name in self.generators():
            if divisor := self.ring.divisors.get(name):
                zero, parts = self.ring.number(0), value.split(name)
                value = parts.get(0, zero)
                for e in range(1, max(parts, default=0) + 1):
                    value, powers = value * divisor + parts.get(e, zero), powers * divisor
        return value, powers

    def vanishes(self) -> bool:
        """Whether it is zero wherever it is defined."""
        return not self.terms or not self.cleared()[0].terms

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
        return Fraction(common, self.below), Element(self.ring, terms, 1, self.bits)

    def over(self, divisor: Element) -> Element | None:
        """The quotient by a primitive polynomial, if it is a polynomial; neither has roots."""
        self.ring.spend(1 + (len(self.terms) + len(divisor.terms) >> 4))
        guard, first, last = self.ring.guard, max(divisor.terms), min(divisor.terms)
        rest, out, bits = dict(self.terms), Terms(), self.bits
        while rest:
            top, low = max(rest), min(rest)
            count, left = divmod(rest[top], divisor.terms[first])
            if left or ((top | guard) - first & (low | guard) - last & guard) != guard:
                return None
            bits = max(bits, count.bit_length())
            need(bits <= BITS, "a number is too large")
            self.ring.spend((len(divisor.terms) + len(rest)) * (1 + (count.bit_length() >> 6)))
            out[top - first] = count
            for m, c in divisor.terms.items():
                rest[m + top - first] = rest.get(m + top - first, 0) - count * c
                if not rest[m + top - first]:
                    del rest[m + top - first]
        return Element(self.ring, out, self.below, bits)

    def words(self) -> str:
        """The polynomial in plain letters, up to a number."""
        self.ring.spend(1 + (len(self.terms) * len(self.ring.at) >> 3))
        shown = []
        for m, c in sorted(self.terms.items(), reverse=True):
            powers = self.ring.exponents(m)
            parts = [name if e == 1 else f"{name} ^ {e}" for name, e in powers]
            shown.append(" * ".join([str(c), *parts] if c != 1 or not parts else parts))
        return f"({' + '.join(shown)})"
