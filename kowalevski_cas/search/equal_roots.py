r"""Products of printed roots that are equal, since none is negative and their squares are equal.

As :math:`\sqrt a\sqrt b=\sqrt{ab}`, where both roots on the left are real; with
:math:`\sqrt{a^2b}=a\sqrt b` it is so where something says that a is not negative, as another
printed root :math:`\sqrt a` does.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from math import isqrt, prod
from typing import NamedTuple

from kowalevski_cas.algebra.factors import exact_quotient, irreducible_factors
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.present import formula_rows
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name, Number, Power, Product, Quotient, Sum
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Proof
from kowalevski_cas.problem.examine import is_real
from kowalevski_cas.search.combinations import complete

Sides = tuple[Formula, Formula]
Factor = tuple[tuple[tuple[int, ...], Fraction], ...]
"""An irreducible polynomial, as a key."""


class Magnitude(NamedTuple):
    """The absolute value of a product of roots: a number and polynomials, times the root of one."""

    number: Fraction
    exponents: Mapping[Factor, int]
    under: tuple[Fraction, frozenset[Factor]]


def proof_by_equal_roots(goals: Sequence[Element], at: Evaluation) -> Proof | None:
    """A proof that elements vanish, by products of printed roots that are equal."""
    if not is_real(at.setting) or not any(map(_has_several_roots, goals)):
        return None
    found = _EqualRoots(at)
    rows = complete(map(found.row, goals))
    if rows is None:
        return None
    width, zero = len(found.equal), at.ring.zero
    whole = [[*row, *[zero] * (width - len(row))] for row in rows]
    return Proof(formula_rows(whole), equal=tuple(found.equal))


def equal_products(at: Evaluation) -> tuple[list[Sides], list[Element]]:
    r"""The roots of products that are products of printed roots, with the differences of both.

    So :math:`\sqrt{ab}` is :math:`\sqrt a\sqrt b` where these two are real.
    """
    found = _EqualRoots(at)
    bits = found.bits(found.signed)
    under = {bit: found.magnitude(1 << bit).under for bit in bits}
    single = {min(factors): bit for bit, (_, factors) in under.items() if len(factors) == 1}
    for bit, (_, factors) in under.items():
        if len(factors) > 1 and single.keys() >= factors:
            product_ = sum(1 << single[factor] for factor in factors)
            if found.magnitude(product_).under == under[bit]:
                found.place(1 << bit, product_)
    return found.equal, found.differences


def _has_several_roots(goal: Element) -> bool:
    return len(goal.parts) > 1


class _EqualRoots:
    """The equalities that have been needed, and how elements are made of them."""

    def __init__(self, at: Evaluation) -> None:
        self.at, self.ring = at, at.ring
        self.equal: list[Sides] = []
        self.differences: list[Element] = []
        self._magnitudes: dict[int, Magnitude] = {}

    def row(self, goal: Element) -> list[Element] | None:
        """An element as a combination of differences of equal products; none if it is not."""
        row = [self.ring.zero for _ in self.equal]
        classes: dict[tuple[int, object], list[int]] = {}
        for mask in goal.parts:
            signed = mask & self.signed
            key = mask ^ signed, self.magnitude(signed).under
            classes.setdefault(key, []).append(mask)
        rest = goal
        for masks in classes.values():
            first, *others = sorted(masks, key=self._weight)
            for mask in others:
                place = self.place(mask & self.signed, first & self.signed)
                if place is None:
                    return None
                entry = self._entry(goal, mask, place)
                row += [self.ring.zero] * (len(self.equal) - len(row))
                row[place] += entry
                rest -= entry * self.differences[place]
        return row if rest.is_zero else None

    @cached_property
    def signed(self) -> int:
        """The bits of the roots that are not negative, and whose squares are polynomials."""
        return sum(
            1 << bit
            for bit, (name, radicand) in enumerate(
                zip(self.ring.roots, self.ring.radicands, strict=True)
            )
            if name.startswith(r"\sqrt") and {*radicand.parts} <= {0}
        )

    def _weight(self, mask: int) -> int:
        return sum(map(abs, self.magnitude(mask & self.signed).exponents.values()))

    def bits(self, mask: int) -> list[int]:
        return [bit for bit in range(len(self.ring.roots)) if mask >> bit & 1]

    def magnitude(self, mask: int) -> Magnitude:
        """The absolute value of the printed roots in a mask, taken together."""
        if mask not in self._magnitudes:
            number, exponents = Fraction(1), Counter[Factor]()
            for bit in self.bits(mask):
                own, factors = _factors(self.ring.radicands[bit].terms()[0])
                number *= own
                exponents.update(factors)
                below = self.ring.below[bit]
                if below is not None:
                    over, factors = _factors(below.terms()[0])
                    number /= over * over
                    exponents.subtract({factor: 2 * e for factor, e in factors.items()})
            root, left = _square_part(number)
            odd = frozenset(factor for factor, e in exponents.items() if e % 2)
            halves = {f: (e - (f in odd)) // 2 for f, e in exponents.items()}
            self._magnitudes[mask] = Magnitude(root, halves, (left, odd))
        return self._magnitudes[mask]

    def place(self, mask: int, other: int) -> int | None:
        """The place of the equality of two products of roots, up to what is not negative."""
        left, right = self.magnitude(mask), self.magnitude(other)
        factors = {*left.exponents, *right.exponents}
        ratio = {f: left.exponents.get(f, 0) - right.exponents.get(f, 0) for f in factors}
        number = left.number / right.number
        one = self._side(mask, number.denominator, {f: -e for f, e in ratio.items() if e < 0})
        two = self._side(other, number.numerator, {f: e for f, e in ratio.items() if e > 0})
        if one is None or two is None:
            return None
        if (one, two) not in self.equal:
            self.equal.append((one, two))
            self.differences.append(self.at.scalar(one) - self.at.scalar(two))
        return self.equal.index((one, two))

    def _side(self, mask: int, number: int, exponents: Mapping[Factor, int]) -> Formula | None:
        """A product that is not negative: a number, absolute values of polynomials, and roots."""
        factors: list[Formula] = [Number(number)] if number != 1 else []
        for factor, exponent in exponents.items():
            base = self._formula(factor) if exponent % 2 == 0 else self._absolute(factor)
            if base is None:
                return None
            factors.append(base if exponent == 1 else Power(base, Number(exponent)))
        factors += [Name(self.ring.roots[bit]) for bit in self.bits(mask)]
        return _product(factors)

    def _absolute(self, factor: Factor) -> Formula | None:
        """The absolute value of a polynomial, if something says which sign it has."""
        if factor in self._signs:
            return self._signs[factor]
        names, letters = self.ring.polynomials.generators, self._letters
        sign = 1 if factor[0][1] > 0 else -1
        terms: list[Formula] = []
        for exponents, coefficient in factor:
            value = coefficient * sign
            parts = [_number(abs(value))] if abs(value) != 1 else []
            for place, exponent in enumerate(exponents):
                if exponent % 2 and place in letters:
                    value *= letters[place][0]
                    parts.append(_power(letters[place][1], exponent))
                elif exponent % 2:
                    return None
                elif exponent:
                    parts.append(_power(Name(names[place]), exponent))
            if value < 0:
                return None
            terms.append(_product(parts))
        return terms[0] if len(terms) == 1 else Sum(tuple(terms))

    @cached_property
    def _signs(self) -> dict[Factor, Formula]:
        """The absolute values of what printed roots are taken of, up to numbers."""
        found: dict[Factor, Formula] = {}
        for bit in self.bits(self.signed):
            number, factors = _factors(self.ring.radicands[bit].terms()[0])
            if self.ring.below[bit] is None and [*factors.values()] == [1]:
                (factor,) = factors
                square = Power(Name(self.ring.roots[bit]), Number(2))
                size = abs(number)
                found[factor] = square if size == 1 else Quotient(square, _number(size))
        return found

    @cached_property
    def _letters(self) -> dict[int, tuple[int, Formula]]:
        """The generators of which the sign is known: it, and the absolute value."""
        found = {}
        for bit in self.bits(self.signed):
            number, factors = _factors(self.ring.radicands[bit].terms()[0])
            for factor in factors:
                ((exponents, _), *others) = factor
                if not others and sum(exponents) == 1 and factor in self._signs:
                    sign = 1 if number > 0 else -1
                    found[exponents.index(1)] = (sign, self._signs[factor])
        return found

    def _formula(self, factor: Factor) -> Formula:
        element = self.ring.from_terms({0: dict(factor)})
        ((formula,),) = formula_rows([[element]])
        return formula

    def _entry(self, goal: Element, mask: int, place: int) -> Element:
        """What an equality is multiplied by, so that it takes a part of an element away."""
        left = self.at.scalar(self.equal[place][0])
        (own,) = (part for bits, part in left.parts.items() if bits == mask & self.signed)
        polynomials, under = self.ring.polynomials, mask & ~self.signed
        quotient = exact_quotient(polynomials.terms(goal.parts[mask]), polynomials.terms(own))
        if quotient is not None:
            part = self.ring.from_terms({under: quotient})
        else:
            part = Element(self.ring, {under: goal.parts[mask]}, {})
            part *= self.ring.inverse_of_polynomial(own)
        below = self.ring.divisor_product(left.denominator)
        part *= self.ring.one if below is None else Element(self.ring, {0: below}, {})
        return part * Element(self.ring, {0: polynomials.one}, goal.denominator)


def _factors(terms: Terms) -> tuple[Fraction, Counter[Factor]]:
    """A polynomial as a number times irreducible ones."""
    factors = irreducible_factors(terms)
    leading = prod(factor[max(factor)] ** e for factor, e in factors)
    number = terms[max(terms)] / leading
    return number, Counter({tuple(sorted(f.items(), reverse=True)): e for f, e in factors})


def _square_part(number: Fraction) -> tuple[Fraction, Fraction]:
    """A positive number of which the square is a part of another one, and what is left."""
    whole = number.numerator * number.denominator
    root = max(k for k in range(1, isqrt(abs(whole)) + 1) if whole % (k * k) == 0)
    return Fraction(root, number.denominator), Fraction(whole // root**2)


def _number(value: Fraction) -> Formula:
    above = Number(value.numerator)
    return above if value.denominator == 1 else Quotient(above, Number(value.denominator))


def _power(base: Formula, exponent: int) -> Formula:
    return base if exponent == 1 else Power(base, Number(exponent))


def _product(factors: list[Formula]) -> Formula:
    if not factors:
        return Number(1)
    return factors[0] if len(factors) == 1 else Product(tuple(factors))
