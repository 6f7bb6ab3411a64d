"""Check certificates with nothing but Python's standard library.

    python -I -S checker.py CERTIFICATE.json ...

The format is described in docs/certificate.md. Nothing that can be computed is
taken from a file: the checker evaluates the printed formulas, differentiates
along the vector field, carries the field through changes of variables, and
inverts denominators by itself, in exact integers. What it does not understand
it rejects. Exit codes: 0 all certified, 5 something rejected, 6 nothing given.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from itertools import combinations_with_replacement
from math import gcd
from typing import Any

FORMAT, VERSION = "kowalevski-cas certificate", 1
WIDTH, DEGREE, WORK, SIZE = 16, 1000, 4_000_000, 1_000_000
MASK = (1 << WIDTH) - 1

Poly = dict[int, int]
Value = Any  # an Element, or a tuple of Elements for a vector or a diagonal matrix
Rate = Callable[[str], "Element"]


class Rejected(Exception):
    """The certificate does not prove what it states."""


class Undivided(Rejected):
    """A division by a polynomial that is not among those assumed to be non-zero."""

    def __init__(self, ring: Ring, poly: Poly) -> None:
        super().__init__(f"division by {shown(ring, poly)}, which is not assumed to be non-zero")
        self.ring, self.poly = ring, poly


def need(condition: object, message: str) -> None:
    """Reject the certificate unless the condition holds."""
    if not condition:
        raise Rejected(message)


class Ring:
    """Integer polynomials in named generators, some of them square roots of earlier ones.

    A monomial is one integer: a field of bits for each exponent, and on top the
    total degree, whose bound keeps the fields apart.
    """

    def __init__(self, names: list[str]) -> None:
        need(len(set(names)) == len(names), "a generator is named twice")
        self.shift = {name: WIDTH * k for k, name in enumerate(names)}
        self.top = WIDTH * len(names)
        self.unit = {name: (1 << s) + (1 << self.top) for name, s in self.shift.items()}
        self.radicands: dict[str, Poly] = {}
        self.nonzero: dict[frozenset[tuple[int, int]], int] = {}
        self.divisors: list[Poly] = []
        self.used: set[int] = set()
        self.work, self.high = 0, 0

    def number(self, value: int) -> Element:
        """An integer."""
        return Element(self, {0: value} if value else {})

    def generator(self, name: str) -> Element:
        """A generator."""
        return Element(self, {self.unit[name]: 1})

    def product(self, a: Poly, b: Poly) -> Poly:
        """The product, with the squares of roots replaced."""
        self.work += len(a) * len(b)
        need(self.work < WORK, "it takes too much work")
        out: Poly = {}
        get = out.get
        for m, c in a.items():
            for n, d in b.items():
                out[m + n] = get(m + n, 0) + c * d
        out = {m: c for m, c in out.items() if c}
        need(not out or max(out) >> self.top <= DEGREE, "a degree is too large")
        high = self.high
        return self.reduced(out) if high and any(m & high for m in out) else out

    def reduced(self, p: Poly) -> Poly:
        """Replace the squares of roots, those of the last one first."""
        for name in reversed(self.radicands):
            shift, unit = self.shift[name], self.unit[name]
            halves: dict[int, Poly] = {}
            for m, c in p.items():
                half = (m >> shift & MASK) >> 1
                halves.setdefault(half, {})[m - 2 * half * unit] = c
            p = halves.pop(0, {})
            for half, q in halves.items():
                for _ in range(half):
                    q = self.product(q, self.radicands[name])
                p = total(p, q)
        return p

    def adjoin(self, name: str, radicand: Element) -> Element:
        """Let a generator be the root of a radicand n/d: it is the root of nd, over d."""
        below = self.below(radicand)
        self.radicands[name] = self.product(radicand.num, below)
        self.high |= (MASK - 1) << self.shift[name]
        return self.generator(name) * make(self, {0: 1}, radicand.den, radicand.q)

    def below(self, element: Element) -> Poly:
        """The denominator as a polynomial."""
        result = {0: element.q}
        for index, exponent in element.den.items():
            for _ in range(exponent):
                result = self.product(result, self.divisors[index])
        return result

    def assume(self, element: Element) -> None:
        """Take a polynomial without roots as non-zero."""
        p = primitive(element.num)
        key = frozenset(p.items())
        need(not element.den and p.keys() - {0}, "a constant is assumed to be non-zero")
        need(key not in self.nonzero, "something is assumed to be non-zero twice")
        self.nonzero[key] = len(self.divisors)
        self.divisors.append(p)

    def listed(self, p: Poly) -> int:
        """The place of a primitive polynomial among the divisors."""
        index = self.nonzero.get(frozenset(p.items()))
        if index is None:
            raise Undivided(self, p)
        self.used.add(index)
        return index

    def inverse(self, p: Poly) -> Element:
        """One over a polynomial without roots: its generators, its content, and the rest."""
        need(p, "division by zero")
        den: dict[int, int] = {}
        for name, shift in self.shift.items():
            least = min(m >> shift & MASK for m in p)
            if least:
                den[self.listed({self.unit[name]: 1})] = least
                p = {m - least * self.unit[name]: c for m, c in p.items()}
        rest = primitive(p)
        if rest != {0: 1}:
            den[self.listed(rest)] = 1
        content = p[max(p)] // rest[max(p)]
        return make(self, {0: 1 if content > 0 else -1}, den, abs(content))


def total(a: Poly, b: Poly, x: int = 1, y: int = 1) -> Poly:
    """The sum x a + y b."""
    out = {m: c * x for m, c in a.items()}
    for m, c in b.items():
        out[m] = out.get(m, 0) + c * y
    return {m: c for m, c in out.items() if c}


def primitive(p: Poly) -> Poly:
    """The polynomial without its content, the leading coefficient positive."""
    content = gcd(*p.values()) * (1 if p and p[max(p)] > 0 else -1)
    return {m: c // content for m, c in p.items()}


class Element:
    """A fraction: a polynomial over an integer and powers of the ring's divisors."""

    __slots__ = ("den", "num", "q", "ring")

    def __init__(
        self, ring: Ring, num: Poly, den: dict[int, int] | None = None, q: int = 1
    ) -> None:
        self.ring, self.num, self.den, self.q = ring, num, den or {}, q

    def __add__(self, other: Element) -> Element:
        if not self.num or not other.num:
            return self if self.num else other
        ring, (a, b) = self.ring, (self.num, other.num)
        den = {k: max(self.den.get(k, 0), other.den.get(k, 0)) for k in {**self.den, **other.den}}
        if self.den != other.den:
            a, b = (
                ring.product(
                    x.num, ring.below(Element(ring, {}, {k: e - x.den.get(k, 0) for k, e in den.items()}))
                )
                for x in (self, other)
            )  # fmt: skip
        q = self.q * other.q // gcd(self.q, other.q)
        return make(ring, total(a, b, q // self.q, q // other.q), den, q)

    def __neg__(self) -> Element:
        return Element(self.ring, {m: -c for m, c in self.num.items()}, self.den, self.q)

    def __sub__(self, other: Element) -> Element:
        return self + (-other)

    def __mul__(self, other: Element) -> Element:
        den = {k: self.den.get(k, 0) + other.den.get(k, 0) for k in {**self.den, **other.den}}
        return make(self.ring, self.ring.product(self.num, other.num), den, self.q * other.q)

    def __pow__(self, exponent: int) -> Element:
        need(abs(exponent) <= 64, "an exponent is too large")
        result, base = self.ring.number(1), self if exponent >= 0 else self.inverse()
        for _ in range(abs(exponent)):
            result = result * base
        return result

    def flipped(self, name: str) -> Element:
        """The element with the sign of one root changed."""
        shift = self.ring.shift[name]
        num = {m: -c if m >> shift & 1 else c for m, c in self.num.items()}
        return Element(self.ring, num, self.den, self.q)

    def inverse(self) -> Element:
        """One over the element: over its norm, which has no roots."""
        ring, norm = self.ring, Element(self.ring, self.num)
        above = Element(ring, ring.below(self))
        for name in reversed(ring.radicands):
            if any(m >> ring.shift[name] & 1 for m in norm.num):
                other = norm.flipped(name)
                above, norm = above * other, norm * other
        return above * ring.inverse(norm.num)

    def along(self, rate: Rate) -> Element:
        """The derivative, given those of the generators."""
        ring, change = self.ring, self.ring.number(0)
        for name, shift in ring.shift.items():
            unit = ring.unit[name]
            part = {m - unit: c * (m >> shift & MASK) for m, c in self.num.items() if m >> shift & MASK}
            if part and (speed := rate(name)).num:
                change = change + make(ring, part, self.den, self.q) * speed
        for index, exponent in self.den.items():
            moved = Element(ring, ring.divisors[index]).along(rate)
            if moved.num:
                over = Element(ring, {0: -exponent}, {index: 1})
                change = change + self * moved * over
        return change

    def image(self, images: Mapping[str, Element], ring: Ring) -> Element:
        """The value when the generators take values in another ring."""
        powers: dict[tuple[str, int], Element] = {}

        def polynomial(p: Poly) -> Element:
            result = ring.number(0)
            for m, c in p.items():
                term = ring.number(c)
                for name, shift in self.ring.shift.items():
                    exponent = m >> shift & MASK
                    if exponent:
                        if (name, exponent) not in powers:
                            need(name in images, f"{name} has no value")
                            powers[name, exponent] = images[name] ** exponent
                        term = term * powers[name, exponent]
                result = result + term
            return result

        value = polynomial(self.num) * Element(ring, {0: 1}, {}, self.q)
        for index, exponent in self.den.items():
            value = value * polynomial(self.ring.divisors[index]).inverse() ** exponent
        return value


def make(ring: Ring, num: Poly, den: dict[int, int], q: int) -> Element:
    """A fraction, cancelled where that is cheap: numbers and single generators."""
    if not num:
        return Element(ring, num)
    if q != 1 and (common := gcd(q, *num.values())) != 1:
        num, q = {m: c // common for m, c in num.items()}, q // common
    for index, exponent in den.items():
        if len(ring.divisors[index]) == 1 and exponent:
            (unit,) = ring.divisors[index]
            shift = (unit & ((1 << ring.top) - 1)).bit_length() - 1
            least = min(exponent, *(m >> shift & MASK for m in num), MASK)
            if least:
                num = {m - least * unit: c for m, c in num.items()}
                den = {**den, index: exponent - least}
    return Element(ring, num, {k: e for k, e in den.items() if e}, q)
