"""Fractions of polynomials over the rational numbers; some generators are roots of others."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from math import gcd, lcm
from operator import or_

from .reading import BITS, DEGREE, NAMES, Budget, Rejected, need

WIDTH = 11  # bits of an exponent in a monomial; the highest of them stays free
MASK = (1 << WIDTH) - 1
FEW = 256  # bits
SHORT = 2  # terms of a divisor by which sums are multiplied at once
Terms = dict[int, int]


class Ring:
    """Polynomials over the rational numbers in generators, of which some are roots or inverses.

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
        self.once, self.squares = 0, 0  # the bits of roots, and of their higher powers
        self.large = 0  # the bits of inverses of divisors that are not short
        self.guard = 1 << WIDTH - 1
        self.evens: dict[int, tuple[int, int | Element]] = {}  # even powers of roots
        self.denominators: dict[int, Element] = {}  # by the monomials of inverses
        self.inverses: dict[tuple[int, int, frozenset[tuple[int, int]]], Element] = {}

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
        self.once |= 1 << self.at[name]
        self.squares |= MASK - 1 << self.at[name]

    def invert(self, name: str, divisor: Element) -> None:
        """Give a generator what it is the inverse of."""
        self.divisors[name] = divisor
        if len(divisor.terms) > SHORT:
            self.large |= MASK << self.at[name]

    def generator(self, name: str) -> Element:
        """A generator as a polynomial, or the inverse of a divisor."""
        if name in self.divisors:
            return Element(self, {0: 1}, 1, 1, self.unit[name] - 1)
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
        return self.combination([(1, e) for e in elements])

    def combination(self, parts: list[tuple[int, Element]], below: int = 1) -> Element:
        """The sum of elements times integers, divided by an integer."""
        found = [part for part in parts if part[1].terms]
        if len(found) == 1 and found[0][0] == below == 1:
            self.spend(len(parts))
            return found[0][1]
        common, steps, out = 1, 5 + len(parts), Terms()
        for _, e in found:
            common = self.multiple(common, e.below) if common % e.below else common
        under = self.shared([e.under for _, e in found])
        bits = (below * common).bit_length()
        for c, e in found:
            if e.under != under:
                e = e.over(under)
            c *= common // e.below
            size = c.bit_length()
            bits = max(bits, e.bits + size)
            steps += len(e.terms) * (1 + (e.bits * size >> 16))
            if out:
                for m, d in e.terms.items():
                    out[m] = out.get(m, 0) + c * d
            else:
                out = {m: c * d for m, d in e.terms.items()}
        bits += len(found).bit_length()
        return Element(self, out, below * common, bits, under, steps)

    def multiple(self, one: int, other: int) -> int:
        """The least common multiple of integers."""
        common = lcm(one, other)
        need(common.bit_length() <= BITS, "a number is too large")
        self.spend(1 + (common.bit_length() ** 2 >> 14))
        return common

    def joined(self, elements: list[Element]) -> Element:
        """The sum of elements over all that is below one of them."""
        elements = [e for e in elements if e.terms]
        under = reduce(self.larger, (e.under for e in elements), 0)
        return self.total(e.over(under) for e in elements)

    def monomial(self, inverses: int) -> int:
        """The monomial of these exponents, with its degree."""
        return inverses + sum(e for _, e in self.exponents(inverses)) if inverses else 0

    def shared(self, inverses: list[int]) -> int:
        """What is below a sum: the large divisors that all have, and all the others."""
        if not inverses or inverses.count(inverses[0]) == len(inverses):
            return inverses[0] if inverses else 0
        every = reduce(self.larger, inverses)
        some = reduce(lambda one, other: one + other - self.larger(one, other), inverses)
        return every & ~self.large | some & self.large

    def larger(self, one: int, other: int) -> int:
        """The least common multiple of monomials of inverses."""
        high = (one | self.guard) - other & self.guard  # the exponents that are no less in one
        mask = high - (high >> WIDTH - 1)
        return one & mask | other & ~mask

    def product(self, elements: Iterable[Element]) -> Element:
        """The product of elements: of the monomials first, which is one more factor of the rest."""
        monomial, count, below, bits, under, steps, sums = 0, 1, 1, 1, 0, 5, list[Element]()
        for e in elements:
            if not e.terms:
                self.spend(steps)
                return e
            if len(e.terms) > 1:
                sums.append(e)
                continue
            ((m, c),) = e.terms.items()
            monomial, count, below, bits = monomial + m, count * c, below * e.below, bits + e.bits
            under, steps = under + e.under, steps + 1
            if bits > FEW:
                bits = max(count.bit_length(), below.bit_length())
                steps += bits * e.bits >> 16
            if monomial & MASK > DEGREE or under & self.guard or bits > BITS:
                raise Rejected("a degree or number is too large")
        if sums and not monomial and not under and count == below == 1:
            self.spend(steps)
        else:
            term = Element(self, {monomial: count}, below, bits, under, steps)
            sums.append(term.reduced() if monomial & self.squares else term)
        return reduce(Element.times, sums) if len(sums) > 1 else sums[0]

    def even(self, powers: int) -> tuple[int, int | Element]:
        """A product of even powers of roots, from the bits of these, and what it is."""
        if powers not in self.evens:
            both = self.exponents(powers)
            squares = [self.roots[name] for name, e in both for _ in range(e // 2)]
            found = reduce(Element.times, squares)
            whole = found.terms.keys() == {0} and found.below == 1 and not found.under
            full = powers + sum(e for _, e in both)
            self.evens[powers] = full, found.terms[0] if whole else found
        return self.evens[powers]

    def denominator(self, powers: int) -> Element:
        """The product of the divisors in a monomial of their inverses."""
        if powers not in self.denominators:
            factors = [self.divisors[n] for n, e in self.exponents(powers) for _ in range(e)]
            self.denominators[powers] = reduce(Element.times, factors or [self.number(1)])
        return self.denominators[powers]


class Element:
    """A polynomial over a positive integer and divisors: ``under`` is a monomial of their inverses.

    The terms have integer coefficients. They have inverses in them only where a sum has not all its
    large divisors in common: so a common denominator is made when it is asked for. An element
    without terms is zero, and of what is zero all is gone once it is ``cleared``.
    No integer has more than so many bits; that is no more than a bound while they are few.
    So many steps were taken to find the terms.
    """

    __slots__ = ("below", "bits", "ring", "terms", "under")

    def __init__(
        self, ring: Ring, terms: Terms, below: int, bits: int, under: int = 0, steps: int = 5
    ) -> None:
        steps += len(terms)
        if bits > FEW:
            bits = max(below.bit_length(), max(map(int.bit_length, terms.values()), default=0))
            need(bits <= BITS, "a number is too large")
            steps += len(terms) * (bits * below.bit_length() >> 14)
        ring.spend(steps)
        if below > 1 and (common := gcd(below, *terms.values())) > 1:
            below, terms = below // common, {m: c // common for m, c in terms.items()}
        if 0 in terms.values():
            terms = {m: c for m, c in terms.items() if c}
        if under:
            need(not under & ring.guard, "a degree is too large")
            under = under if terms else 0
        self.ring, self.terms, self.below, self.bits, self.under = ring, terms, below, bits, under

    def __neg__(self) -> Element:
        return self.with_terms({m: -c for m, c in self.terms.items()})

    def __add__(self, other: Element) -> Element:
        return self.ring.combination([(1, self), (1, other)])

    def __sub__(self, other: Element) -> Element:
        return self.ring.combination([(1, self), (-1, other)])

    def __pow__(self, exponent: int) -> Element:
        return self.ring.product([self] * exponent)

    def times(self, other: Element) -> Element:
        """The product, term by term."""
        few, many = (self, other) if len(self.terms) <= len(other.terms) else (other, self)
        ring, size = self.ring, len(few.terms) * len(many.terms)
        ring.spend(5 + size * (1 + (few.bits * many.bits >> 16)))
        if not few.terms:  # roots of squares have divisors of zero
            return few
        one, two = reduce(or_, few.terms), reduce(or_, many.terms)
        if (one & MASK) + (two & MASK) > DEGREE:
            degrees = (max(m & MASK for m in e.terms) for e in (few, many))
            need(sum(degrees) <= DEGREE, "a degree is too large")
        (m, c), *others = few.terms.items()
        out = {m + n: c * d for n, d in many.terms.items()}
        for m, c in others:
            for n, d in many.terms.items():
                k = m + n
                out[k] = out.get(k, 0) + c * d
        bits = few.bits + many.bits + len(few.terms).bit_length()
        whole = Element(ring, out, few.below * many.below, bits, few.under + many.under)
        return whole.reduced() if one & two & ring.once else whole

    __mul__ = times

    def reduced(self) -> Element:
        """The same with each root in the first power at most."""
        ring, groups = self.ring, defaultdict[int, Terms](dict)
        for m, c in self.terms.items():
            groups[m & ring.squares][m] = c
        out, others, bits = groups.pop(0, {}), list[Element](), self.bits
        for powers, terms in groups.items():
            full, even = ring.even(powers)
            if isinstance(even, int):  # as the square of i
                size = even.bit_length()
                ring.spend(len(terms) * (1 + (self.bits * size >> 16)))
                bits = max(bits, self.bits + size)
                for m, c in terms.items():
                    out[m - full] = out.get(m - full, 0) + c * even
            else:
                rest = self.with_terms({m - full: c for m, c in terms.items()})
                others.append(rest.times(even))
        bits += len(groups).bit_length()
        whole = Element(ring, out, self.below, bits, self.under)
        return ring.total([whole, *others]) if others else whole

    def over(self, under: int) -> Element:
        """The same over other divisors: of what is below it, the rest is put into the terms."""
        ring = self.ring
        every = ring.larger(self.under, under)
        more, inverses = every - self.under, every - under
        e = self.times(ring.denominator(more)) if more else self
        full, terms = ring.monomial(inverses), e.terms
        if inverses:
            degree = max(m & MASK for m in terms) + (full & MASK)
            need(degree <= DEGREE, "a degree is too large")
            terms = {m + full: c for m, c in terms.items()}
        return Element(ring, terms, e.below, e.bits, under)

    def by(self, bits: int) -> dict[int, Element]:
        """The terms together that have the same in some bits."""
        groups = defaultdict[int, Terms](dict)
        for m, c in self.terms.items():
            groups[m & bits][m] = c
        self.ring.spend(len(self.terms))
        return {key: self.with_terms(terms) for key, terms in groups.items()}

    def is_mixed(self) -> bool:
        """Whether there are inverses in its terms."""
        return bool(self.ring.large and reduce(or_, self.terms, 0) & self.ring.large)

    def cleared(self) -> Element:
        """The same with all divisors below it; what has the same ones is added first."""
        ring, groups = self.ring, defaultdict[tuple[str, ...], list[Element]](list)
        if not self.is_mixed():
            return self
        for inverses, e in self.by(ring.large).items():
            full = ring.monomial(inverses)
            terms = {m - full: c for m, c in e.terms.items()}
            names = tuple(name for name, _ in ring.exponents(inverses))
            groups[names].append(Element(ring, terms, e.below, e.bits, e.under + inverses))
        return ring.joined([*map(ring.joined, groups.values())])

    def with_terms(self, terms: Terms) -> Element:
        """Other terms, of numbers no larger than here, over the same."""
        return Element(self.ring, terms, self.below, self.bits, self.under)

    def numerator(self) -> Element:
        """The element times the divisors below it."""
        whole = self.cleared()
        return Element(self.ring, whole.terms, whole.below, whole.bits)

    def generators(self) -> list[str]:
        """The generators that occur."""
        return self.cleared().written()

    def written(self) -> list[str]:
        """The generators that occur as it is written."""
        self.ring.spend(1 + (len(self.terms) >> 3))
        return [name for name, _ in self.ring.exponents(reduce(or_, self.terms, self.under))]

    def split(self, name: str) -> dict[int, Element]:
        """The coefficients as a polynomial in one generator."""
        found = defaultdict[int, Terms](dict)
        shift, unit, whole = self.ring.at[name], self.ring.unit[name], self.cleared()
        for m, c in whole.terms.items():
            e = m >> shift & MASK
            found[e][m - e * unit] = c
        return {e: whole.with_terms(terms) for e, terms in found.items()}

    def partial(self, name: str) -> Element:
        """The derivative by one generator, while the others stay."""
        self.ring.spend(len(self.terms))
        shift, unit = self.ring.at[name], self.ring.unit[name]
        under, power = self.under, self.under >> shift & MASK
        if power:
            powers = ((m, c, power + (m >> shift & MASK)) for m, c in self.terms.items())
            terms, under = {m: c * e for m, c, e in powers}, under - unit + 1
        else:
            terms = {m - unit: c * e for m, c in self.terms.items() if (e := m >> shift & MASK)}
        return Element(self.ring, terms, self.below, self.bits + WIDTH + 1, under)

    def normed(self) -> tuple[Element, Element]:
        """The product of the other values for all signs of the roots, and with it the norm."""
        above, norm, roots = self.ring.number(1), self.cleared(), self.ring.roots
        for name in reversed(roots) if roots.keys() & norm.written() else ():
            if name in norm.written():
                bit = 1 << self.ring.at[name]
                terms = {m: -c if m & bit else c for m, c in norm.terms.items()}
                other = norm.with_terms(terms)
                above, norm = above * other, (norm * other).cleared()
        return above, norm

    def vanishes(self) -> bool:
        """Whether it is zero wherever it is defined: what is before each product of roots."""
        if not self.is_mixed():
            return not self.terms
        return not any(e.cleared().terms for e in self.by(self.ring.once).values())

    def differs(self) -> bool:
        """Whether a number is certainly not zero, whatever the signs of its roots."""
        return bool(self.normed()[1].terms)

    def is_generator(self, name: str) -> bool:
        """Whether it is this very generator."""
        return self.terms == {self.ring.unit[name]: 1} and self.below == 1 and not self.under

    def value(self) -> Fraction | None:
        """The number that it is, if it is one."""
        whole = self.cleared()
        if whole.terms and (len(whole.terms) > 1 or 0 not in whole.terms or whole.under):
            return None
        return Fraction(whole.terms.get(0, 0), whole.below)
