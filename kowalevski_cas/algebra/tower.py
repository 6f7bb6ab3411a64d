r"""Fractions in a tower of square roots over a ring of polynomials.

An element is :math:`\bigl(\sum_m p_m \prod_{k\in m} g_k\bigr) / \prod_j u_j^{e_j}` with
polynomials :math:`p_m`, roots :math:`g_k` with :math:`g_k^2 = r_k` (among them
:math:`i^2=-1` and :math:`s^2=x_1x_2`), and polynomials :math:`u_j` that were
divided by. Nothing is ever cancelled and no gcd is taken: the denominators are
remembered, for they are what a statement assumes to be non-zero. A numerator
has one form only, because the roots appear to the powers 0 and 1, so the test
for zero is the test that every :math:`p_m` vanishes.

A common denominator is large where sums have many: so an element is kept as a sum of
fractions, which have different :math:`u_j` of more than one term below them, until its numerator
is asked for. Often, as in the energy of n bodies, each of the fractions vanishes by itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import product
from operator import add, sub

from kowalevski_cas.algebra.polynomials import Coefficients, Polynomial, Polynomials, Terms

Parts = dict[int, Polynomial]
Summand = tuple[Parts, dict[int, int]]
"""A numerator, and the exponents of the divisors below it."""
Combine = Callable[[Polynomial, Polynomial], Polynomial]
"""The sum of two polynomials, or their difference."""


class Ring:
    """A tower of roots over ``polynomials``; it makes the elements.

    ``divisors`` lists the polynomials that were divided by, in the order in which
    they were met.
    """

    def __init__(self, polynomials: Polynomials) -> None:
        self.polynomials = polynomials
        self.roots: list[str] = []
        self.radicands: list[Element] = []
        self.below: list[Element | None] = []
        """What each root is over, as an element: the generator is this times the root."""
        self.divisors: list[Polynomial] = []
        self._large = 0
        """The divisors of more than one term, as bits."""
        self._squares: dict[int, Parts] = {}
        self._numbers: dict[int | Fraction, Element] = {}
        self.zero = Element(self, {}, {})
        self.one = self.number(1)

    @property
    def names(self) -> tuple[str, ...]:
        """Generators of the polynomials, then the roots."""
        return (*self.polynomials.generators, *self.roots)

    def number(self, value: int | Fraction) -> Element:
        """A rational number, which is made once."""
        if value not in self._numbers:
            self._numbers[value] = self.element({0: self.polynomials.constant(value)}, {})
        return self._numbers[value]

    def generator(self, name: str) -> Element:
        """The generator or root with this name; raises ``ValueError`` if there is none."""
        if name in self.roots:
            return Element(self, {1 << self.roots.index(name): self.polynomials.one}, {})
        index = self.polynomials.generators.index(name)
        return Element(self, {0: self.polynomials.generator(index)}, {})

    def adjoin(self, name: str, radicand: Element) -> Element:
        """Add a square root of ``radicand`` and return it.

        A radicand n/d with a denominator gives the generator of the root of nd,
        and the element that is this root over d.
        """
        divisor = self.divisor_product(radicand.denominator)
        if divisor is not None:
            factor = Element(self, {0: divisor}, {})
            radicand = Element(self, radicand.parts, {}) * factor
        self.roots.append(name)
        self.radicands.append(radicand)
        self.below.append(None if divisor is None else factor)
        root = self.generator(name)
        return root if divisor is None else root * factor.inverse()

    def element(self, parts: Parts, denominator: dict[int, int]) -> Element:
        """An element, with vanishing parts dropped."""
        return Element(self, _nonzero(parts), denominator)

    def multiply(self, left: Polynomial, right: Polynomial) -> Polynomial:
        """The product of two polynomials."""
        one = self.polynomials.one
        if left is one or right is one:
            return right if left is one else left
        return left * right

    def add_numerators(self, left: Parts, right: Parts, combine: Combine) -> Parts:
        """The sum or the difference of two numerators, without what vanishes."""
        result = dict(left)
        for mask, p in right.items():
            if mask not in result:
                result[mask] = p if combine is add else -p
            elif total := combine(result[mask], p):
                result[mask] = total
            else:
                del result[mask]
        return result

    def add_summands(self, left: Summand, right: Summand, combine: Combine) -> Summand:
        """The sum or the difference of two summands, over a common denominator."""
        if left[1] == right[1]:
            return self.add_numerators(left[0], right[0], combine), left[1]
        common = least_common(left[1], right[1])
        one, other = self.expanded(left, common), self.expanded(right, common)
        return self.add_numerators(one, other, combine), common

    def expanded(self, summand: Summand, denominator: Mapping[int, int]) -> Parts:
        """The numerator of a summand over a larger denominator."""
        parts, below = summand
        factor = self.divisor_product({k: e - below.get(k, 0) for k, e in denominator.items()})
        if factor is None:
            return parts
        return {m: self.multiply(p, factor) for m, p in parts.items()}

    def multiply_summands(self, left: Summand, right: Summand) -> Summand:
        """The product of two summands."""
        (one, denominator), (other, more) = left, right
        if more:
            denominator = dict(denominator)
            for index, exponent in more.items():
                denominator[index] = denominator.get(index, 0) + exponent
        if len(one) == len(other) == 1:
            # One product, which cannot vanish: polynomials have no divisors of zero.
            ((mask, p),), ((other_mask, q),) = one.items(), other.items()
            if not mask & other_mask:
                return {mask | other_mask: self.multiply(p, q)}, denominator
        return _nonzero(self.multiply_parts(one, other)), denominator

    def multiply_parts(self, left: Parts, right: Parts) -> Parts:
        """The product of two numerators, the roots reduced by their squares."""
        products: dict[int, Parts] = {}
        for mask, p in left.items():
            for other, q in right.items():
                if left is right and mask > other:
                    continue  # the pair comes once more, the other way round
                product = self.multiply(p, q)
                if left is right and mask < other:
                    product = product + product
                _add(products.setdefault(mask & other, {}), mask ^ other, product)
        result = products.pop(0, {})
        for twice, parts in products.items():
            for mask, product in self.multiply_parts(parts, self._square(twice)).items():
                _add(result, mask, product)
        return result

    def _square(self, mask: int) -> Parts:
        """The product of the radicands of the roots in ``mask``."""
        if mask not in self._squares:
            bit = mask.bit_length() - 1
            rest = mask ^ (1 << bit)
            parts = self.radicands[bit].parts
            self._squares[mask] = self.multiply_parts(parts, self._square(rest)) if rest else parts
        return self._squares[mask]

    def divisor(self, polynomial: Polynomial) -> int:
        """The index of a polynomial among the divisors, where it is entered if it is new."""
        if polynomial not in self.divisors:
            if not self.polynomials.is_monomial(polynomial):
                self._large |= 1 << len(self.divisors)
            self.divisors.append(polynomial)
        return self.divisors.index(polynomial)

    def large_below(self, summand: Summand) -> int:
        """The divisors of more than one term below a summand, as bits."""
        return sum(1 << index for index in summand[1]) & self._large

    def divisor_product(self, exponents: Mapping[int, int]) -> Polynomial | None:
        """The product of divisors to these positive exponents; ``None`` for the empty one."""
        product = None
        for index, exponent in exponents.items():
            for _ in range(exponent):
                factor = self.divisors[index]
                product = factor if product is None else self.multiply(product, factor)
        return product

    def inverse_of_polynomial(self, polynomial: Polynomial) -> Element:
        """One over a polynomial; a monomial is taken apart into its generators."""
        if polynomial in self.divisors or not self.polynomials.is_monomial(polynomial):
            return Element(self, {0: self.polynomials.one}, {self.divisor(polynomial): 1})
        ((exponents, value),) = self.polynomials.terms(polynomial).items()
        denominator = {
            self.divisor(self.polynomials.generator(index)): exponent
            for index, exponent in enumerate(exponents)
            if exponent
        }
        return Element(self, {0: self.polynomials.constant(1 / value)}, denominator)

    def divisors_of(self, elements: Iterable[Element]) -> list[Element]:
        """What elements are divided by, each polynomial once."""
        return [self.divisor_at(index) for index in indices_below(elements)]

    def divisor_at(self, index: int) -> Element:
        """The divisor with an index, as an element."""
        return Element(self, {0: self.divisors[index]}, {})

    def from_terms(self, parts: Mapping[int, Coefficients]) -> Element:
        """An element without denominator, from the coefficients of its numerator."""
        convert = self.polynomials.from_terms
        return self.element({m: convert(t) for m, t in parts.items()}, {})


def indices_below(elements: Iterable[Element]) -> list[int]:
    """The indices of what elements are divided by, in ascending order."""
    return sorted({index for element in elements for index in element.denominator})


def least_common(left: Mapping[int, int], right: Mapping[int, int]) -> dict[int, int]:
    """The exponents of the least common multiple of two denominators."""
    return {k: max(left.get(k, 0), right.get(k, 0)) for k in (*left, *right)}


def _nonzero(parts: Parts) -> Parts:
    return {m: p for m, p in parts.items() if p}


def _add(parts: Parts, mask: int, polynomial: Polynomial) -> None:
    parts[mask] = parts[mask] + polynomial if mask in parts else polynomial


class Element:
    """An element of a :class:`Ring`: numerator by roots, denominator by divisors.

    It is made as one fraction, or is the sum of ``summands``, which have different large divisors.
    """

    __slots__ = ("_parts", "_summands", "denominator", "ring")

    def __init__(self, ring: Ring, parts: Parts, denominator: dict[int, int]) -> None:
        self.ring = ring
        self.denominator = denominator
        self._parts: Parts | None = parts
        self._summands: tuple[Summand, ...] = ()

    @classmethod
    def _of(cls, ring: Ring, summands: Sequence[Summand], denominator: dict[int, int]) -> Element:
        """The sum of summands, whose denominators have this least common multiple."""
        if len(summands) == 1:
            return cls(ring, *summands[0])
        whole = cls(ring, {}, denominator)
        whole._parts, whole._summands = None, (*summands,)
        return whole

    @property
    def parts(self) -> Parts:
        """The numerator over the common denominator."""
        if self._parts is None:
            sums = (self.ring.expanded(one, self.denominator) for one in self._by_root())
            self._parts = {mask: p for parts in sums for mask, p in parts.items()}
        return self._parts

    def _by_root(self) -> list[Summand]:
        """What is before each product of roots, if it does not vanish, over what is below it."""
        found: dict[int, Summand] = {}
        for parts, below in self._summands:
            for mask, p in parts.items():
                before = found.get(mask, ({}, below))
                found[mask] = self.ring.add_summands(before, ({mask: p}, below), add)
        return [one for one in found.values() if one[0]]

    @property
    def summands(self) -> tuple[Summand, ...]:
        """The fractions of which it is the sum."""
        return self._summands or ((self.parts, self.denominator),)

    @property
    def is_zero(self) -> bool:
        """Whether the numerator vanishes identically."""
        if self._parts is None:
            masks = [mask for parts, _ in self._summands for mask in parts]
            if any(masks.count(mask) == 1 for mask in masks) or self._by_root():
                return False
            self._parts = {}
        return not self._parts

    def __add__(self, other: Element) -> Element:
        # a zero that was divided by something is added all the same: the sum remembers it
        return self._add(other, add) if self.denominator or self.parts else other

    def __sub__(self, other: Element) -> Element:
        return self._add(other, sub)

    def _add(self, other: Element, combine: Combine) -> Element:
        ring = self.ring
        if not other.denominator and not other.parts:
            return self
        if self.denominator == other.denominator and not self._summands and not other._summands:
            parts = ring.add_numerators(self.parts, other.parts, combine)
            return Element(ring, parts, self.denominator)
        found = {ring.large_below(one): one for one in self.summands}
        for one in other.summands:
            below = ring.large_below(one)
            before = found.get(below, ({}, one[1]))
            found[below] = ring.add_summands(before, one, combine)
        common = least_common(self.denominator, other.denominator)
        return Element._of(ring, [*found.values()], common)

    def over(self, denominator: Mapping[int, int]) -> Parts:
        """The numerator over a larger denominator."""
        return self.ring.expanded((self.parts, self.denominator), denominator)

    def __neg__(self) -> Element:
        negative = [({m: -p for m, p in parts.items()}, below) for parts, below in self.summands]
        return Element._of(self.ring, negative, self.denominator)

    def __mul__(self, other: Element) -> Element:
        ring = self.ring
        if other is ring.one:
            return self
        if self is ring.one:
            return other
        if not self._summands and not other._summands:
            return Element(ring, *ring.multiply_summands(*self.summands, *other.summands))
        found: dict[int, Summand] = {}
        for pair in product(self.summands, other.summands):
            one = ring.multiply_summands(*pair)
            below = ring.large_below(one)
            found[below] = ring.add_summands(found[below], one, add) if below in found else one
        more = {k: self.denominator.get(k, 0) + e for k, e in other.denominator.items()}
        return Element._of(ring, [*found.values()], self.denominator | more)

    def __pow__(self, exponent: int) -> Element:
        if exponent < 0:
            return self.inverse() ** -exponent
        result = self.ring.one
        base = self
        while exponent:
            if exponent & 1:
                result = base if result is self.ring.one else result * base
            exponent >>= 1
            if exponent:
                base = base * base
        return result

    def conjugate_root(self, bit: int) -> Element:
        """The element with the sign of one root changed."""
        parts = {m: -p if m >> bit & 1 else p for m, p in self.parts.items()}
        return Element(self.ring, parts, self.denominator)

    def inverse(self) -> Element:
        """One over the element, by norms; raises ``ZeroDivisionError`` for zero."""
        if self is self.ring.one:
            return self
        if self.is_zero:
            raise ZeroDivisionError("division by an expression that vanishes identically")
        numerator = Element(self.ring, self.parts, {})
        result = self.ring.one
        if (factor := self.ring.divisor_product(self.denominator)) is not None:
            result = Element(self.ring, {0: factor}, {})
        # from the top of the tower: the norm by a root has only roots below it
        for bit in reversed(range(len(self.ring.roots))):
            if any(mask >> bit & 1 for mask in numerator.parts):
                conjugate = numerator.conjugate_root(bit)
                result, numerator = result * conjugate, numerator * conjugate
        if numerator.is_zero:
            raise ZeroDivisionError("division by a divisor of zero")
        return result * self.ring.inverse_of_polynomial(numerator.parts[0])

    def __truediv__(self, other: Element) -> Element:
        return self * other.inverse()

    def terms(self) -> dict[int, Terms]:
        """The neutral form of the numerator: a polynomial for each product of roots."""
        return {m: self.ring.polynomials.terms(p) for m, p in self.parts.items()}
