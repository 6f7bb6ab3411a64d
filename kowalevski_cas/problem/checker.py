"""Check certificates (docs/certificate.md), with nothing but Python's standard library.

A certificate states a problem, spaces and goals, and gives evidence. Everything in it but the
problem was found by a search that is not trusted: here it is all computed again, by exact
polynomials over the integers. What is not understood is rejected.

Exit codes: 0 all files are certified, 5 one is rejected, 6 there is none.
"""

from __future__ import annotations

import copy
import hashlib
import json
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial, reduce
from itertools import combinations, compress, product
from math import gcd, lcm, prod
from operator import not_
from typing import Any

FORMAT, VERSION = "kowalevski-cas certificate", 2
SIZE = 1_000_000  # characters of a file
WORK = 5_000_000  # steps of arithmetic in the check of a file, by the terms and the size of numbers
BITS = 6_000  # of an integer
DEGREE = 1_000  # total, of a polynomial
NAMES = 150  # generators of a ring

Json = Any


class Rejected(Exception):
    """The certificate does not prove what it states."""


def need(condition: object, message: str) -> None:
    """Reject the certificate unless the condition holds."""
    if not condition:
        raise Rejected(message)


# -- reading -----------------------------------------------------------------------

_WORD = r"[\w\\^*()+\-/.,']"
NAME = re.compile(
    rf"(?:[A-Za-z]|\\(?=[A-Za-z]))(?:\w|\\(?=[A-Za-z])|\^(?=[A-Za-z*{{\\])|(?<=\^)\*|\{{{_WORD}+\}})*",
    re.ASCII,
)


def record(data: Json, required: str, optional: str = "") -> Json:
    """A JSON object that has all of the required keys, and no others but the optional ones."""
    need(type(data) is dict, "an object is expected")
    need(set(required.split()) <= data.keys(), f"a key is missing, one of: {required}")
    need(data.keys() <= {*required.split(), *optional.split()}, "a key is unknown")
    return data


def items(data: Json, *sizes: int) -> list[Json]:
    """A JSON list, of one of the sizes."""
    need(type(data) is list, "a list is expected")
    need(not sizes or len(data) in sizes, "a list has another length")
    return data  # type: ignore[no-any-return]


def pairs(data: Json) -> list[list[Json]]:
    """A list of lists of two."""
    return [items(pair, 2) for pair in items(data)]


def integer(data: Json, least: int, most: int) -> int:
    """An integer between two bounds."""
    need(type(data) is int and least <= data <= most, "a number is odd")
    return data  # type: ignore[no-any-return]


def label(data: Json) -> str:
    """A name."""
    need(type(data) is str and NAME.fullmatch(data), f"a name is odd: {data!a}")
    return data  # type: ignore[no-any-return]


def labels(data: Json) -> list[str]:
    """A list of names, all different."""
    found = [label(name) for name in items(data)]
    need(len({*found}) == len(found), "a name is given twice")
    return found


def names_in(tree: Json) -> set[str]:
    """The names in a formula."""
    if type(tree) is list:
        return {name for part in tree[1:] for name in names_in(part)}
    return {tree} if type(tree) is str else set()


def factors(tree: Json) -> list[Json]:
    """The factors of a formula that is a product or a power; numbers do not count."""
    op, *parts = tree if type(tree) is list and tree else [""]
    if op == "*" and len(parts) > 1:
        kept = [part for part in parts if type(part) is not int or part == 0]
        return [factor for part in kept for factor in factors(part)]
    if op == "^" and len(parts) == 2 and type(parts[1]) is int and 0 < parts[1] <= 64:
        return factors(parts[0])
    return [tree]


# -- numbers and polynomials -------------------------------------------------------

WIDTH = 11  # bits of an exponent in a monomial; the highest of them stays free
MASK = (1 << WIDTH) - 1
Terms = dict[int, int]


class Ring:
    """Polynomials over the rational numbers in generators, of which some obey relations.

    A monomial is an integer: the total degree in its lowest bits, then the exponents of the
    generators, in the order in which these were adjoined. Such integers add and compare as
    monomials multiply and compare.
    """

    def __init__(self, work: list[int]) -> None:
        self.work = work  # what is left: one number for the whole check of a file
        self.at: dict[str, int] = {}
        self.unit: dict[str, int] = {}
        self.roots: dict[str, Element] = {}  # the squares of generators
        self.divisors: dict[str, Element] = {}  # of which generators are the inverses
        self.powers: dict[str, tuple[Element, Element]] = {}  # bases and exponents
        self.unknown: set[str] = set()  # what may depend on all other names
        self.squares, self.guard = 0, 1 << WIDTH - 1

    def another(self) -> Ring:
        """A ring without generators; the work in both is counted together."""
        return Ring(self.work)

    def spend(self, steps: int) -> None:
        """Count work."""
        self.work[0] -= steps
        need(self.work[0] > 0, "it takes too much work")

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
        return reduce(Element.__mul__, [self] * exponent) if exponent else self.ring.number(1)

    def degree(self) -> int:
        """The total degree."""
        return max([m & MASK for m in self.terms], default=0)

    def reduced(self) -> Element:
        """The same with each root in the first power at most."""
        ring, value = self.ring, self
        for name in reversed(ring.roots):
            if not any([m & ring.squares for m in value.terms]):
                return value
            shift, square, low, high = ring.at[name], 2 * ring.unit[name], Terms(), Terms()
            for m, c in value.terms.items():
                if m >> shift & MASK > 1:
                    high[m - square] = c
                else:
                    low[m] = c
            if high:
                more = Element(ring, high, value.below) * ring.roots[name]
                value = Element(ring, low, value.below) + more
        return value

    def generators(self) -> list[str]:
        """The generators that occur."""
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
        shown = []
        for m, c in sorted(self.terms.items(), reverse=True):
            powers = [(name, m >> shift & MASK) for name, shift in self.ring.at.items()]
            parts = [name if e == 1 else f"{name} ^ {e}" for name, e in powers if e]
            shown.append(" * ".join([str(c), *parts] if c != 1 or not parts else parts))
        return f"({' + '.join(shown)})"


# -- spaces ------------------------------------------------------------------------

MANY = 1_000_000
OPERATIONS = {  # how many formulas they take
    "+": (2, MANY), "*": (2, MANY), "/": (2, MANY), "-": (1, 1), "^": (2, 2), "sqrt": (1, 1),
    "D": (1, 1), "d": (2, 2), "conj": (1, 1), "vector": (1, MANY), "diag": (1, MANY),
    "dot": (2, 2), "cross": (2, 2),
}  # fmt: skip
Value = tuple[Element, ...]  # a number, or the components of a vector
Rates = dict[str, Element]


class Map:
    """What elements of a ring become in a space where its generators have values."""

    def __init__(self, ring: Ring, images: dict[str, Element], space: Space) -> None:
        self.ring, self.images, self.space = ring, images, space
        for name in ring.roots.keys() & images.keys():
            square = ring.roots[name]
            rest = images[name] * images[name] - self(square)
            need(rest.vanishes(), f"{name} does not keep its square")
        for name in ring.powers.keys() & images.keys():
            base, exponent = ring.powers[name]
            same = space.is_power(images[name], self(base), self(exponent))
            need(same, f"{name} may be no power of its base")

    def __call__(self, element: Element) -> Element:
        at = [(name, self.ring.at[name]) for name in element.generators()]
        for name, _ in at:
            if name not in self.images:
                need(name in self.ring.divisors, f"{name} has no value")
                self.images[name] = self.space.inverse(self(self.ring.divisors[name]))
        ring, found = self.space.ring, list[Element]()
        powers: dict[tuple[str, int], Element] = {}
        for m, c in element.terms.items():
            term = Element(ring, {0: c}, element.below)
            for name, shift in at:
                if e := m >> shift & MASK:
                    if (name, e) not in powers:
                        powers[name, e] = self.images[name] ** e
                    term = term * powers[name, e]
            found.append(term)
        return ring.total(found)


class Space:
    """Names with relations and definitions, a vector field, and a conjugation.

    A formula of a statement may divide by all that does not vanish identically: it is about the
    points where its formulas are defined, and what it divides by becomes one more divisor that
    is known not to vanish there. A formula of the evidence divides by known divisors only.
    """

    def __init__(self, data: Json, before: list[Space], ring: Ring) -> None:
        record(data, "variables", "constants nonzero steps field change conjugates")
        need(not {"field", "change"} <= data.keys(), "a space has a field, or a change")
        self.data, self.ring, self.stating = data, ring, True
        self.known: dict[str, str] = {}  # inverses of divisors, with words for these
        self.env: dict[str, Value] = {}
        self.bar: dict[str, Element] = {}
        self.mirror: Map | None = None
        self.rates: Rates | None = None
        self.old: Space | None = None
        self.granted: list[Element] = []  # what does not vanish where a change comes from
        self.waiting: set[str] = set()  # variables that have no rate yet
        self.variables, self.constants = (
            labels(data.get(k, [])) for k in ("variables", "constants")
        )
        steps, conditions = items(data.get("steps", [])), items(data.get("nonzero", []))
        self.generate(steps, pairs(data.get("conjugates", [])))
        conditions = self.assume(conditions)
        for step in steps:
            self.step(*step)
            conditions = self.assume(conditions)
        need(not conditions, "a condition has a name that is not defined")
        self.mirror = None
        old = self.change(before, data["change"]) if "change" in data else []
        self.move(items(data.get("field", [])), old)
        printed = [step[3] for step in steps if step[0] == "root" and len(step) == 4]
        need(all(e.vanishes() for e in self.differences(printed)), "a root has another square")
        self.stating = False

    def generate(self, steps: list[Json], both: list[list[Json]]) -> None:
        """Adjoin all names that are generators, with their conjugates."""
        for step in steps:
            need(len(items(step, 3, 4)) == 3 or step[0] in ("root", "power"), "a step is odd")
        adjoined = [label(step[1]) for step in steps if step[0] in ("root", "power")]
        plain = [*self.variables, *self.constants]
        self.bar = {name: self.ring.adjoin(name) for name in (*plain, *adjoined)}
        self.env = {name: (self.bar[name],) for name in plain}
        roots = {step[1] for step in steps if step[0] == "root"}
        swap = {label(a): label(b) for pair in both for a, b in (pair, pair[::-1])}
        kinds = [{*self.variables}, {*self.constants}, roots]
        need(len(swap) == 2 * len(both), "a name is in two pairs of conjugates")
        for a, b in swap.items():
            need(a != b and any({a, b} <= kind for kind in kinds), "a pair of conjugates is odd")
            self.bar[a] = self.ring.generator(b)

    def step(self, kind: Json, name: Json, tree: Json, more: Json = None) -> None:
        """A definition, a root or a power."""
        need(label(name) not in self.env, f"{name} is defined twice")
        if kind == "let":
            self.env[name] = self.value(tree)
            return
        own, value = self.ring.generator(name), self.scalar(tree)
        if kind == "root":
            self.ring.relate(name, value)
            if (value.value() or 0) < 0:
                need(self.bar[name].terms == own.terms, "an imaginary number is its own pair")
                self.bar[name] = -own
        else:
            need(kind == "power" and more in self.constants, "a step is not understood")
            exponent = self.scalar(more)
            need(self.is_real(value) and self.is_real(exponent), "a power of what is not real")
            self.ring.powers[name] = value, exponent
            self.enter(value, say(tree))
            self.enter(own, name)
        self.env[name] = (own,)

    def local(self) -> Space:
        """A copy for one goal: what the goal brings in is forgotten with it."""
        other = copy.copy(self)
        other.env, other.known = dict(self.env), dict(self.known)
        other.rates = None if self.rates is None else dict(self.rates)
        return other

    def carried(self, ring: Ring, images: dict[str, Element]) -> Map:
        """What elements of a ring become here, where its generators have values."""
        return Map(ring, images, self)

    @contextmanager
    def statement(self, stating: bool = True) -> Iterator[None]:
        """Formulas that are read here belong to the statement, or do not."""
        before, self.stating = self.stating, stating
        yield
        self.stating = before

    def bind(self, name: Json) -> tuple[str, Element]:
        """A new generator for a name that is bound in a goal."""
        own = f":{label(name)}"
        need(name not in self.env, "a bound name has another meaning")
        if own not in self.ring.at:
            self.ring.adjoin(own)
        self.env[name] = (self.ring.generator(own),)
        return own, self.ring.generator(own)

    # conjugation

    def conj(self, element: Element) -> Element:
        """The complex conjugate; that of a divisor does not vanish either."""
        if self.mirror is None:
            space = self.local()
            space.stating = True
            self.mirror = space.carried(self.ring, dict(self.bar))
        conjugate = self.mirror(element)
        defined = self.env.keys() | self.ring.divisors.keys()
        need({*conjugate.generators()} <= defined, "a conjugate is not defined yet")
        return conjugate

    def is_real(self, element: Element) -> bool:
        """Whether an element is its own conjugate."""
        return (self.conj(element) - element).vanishes()

    def all_real(self) -> bool:
        """Whether all names are."""
        return all(e.terms == {self.ring.unit[name]: 1} for name, e in self.bar.items())

    def is_power(self, value: Element, base: Element, exponent: Element) -> bool:
        """Whether a value is known to be a power: this very generator, or a power of 1."""
        for name, (own, to) in self.ring.powers.items():
            if value.terms == {self.ring.unit[name]: 1} and value.below == 1:
                return (own - base).vanishes() and (to - exponent).vanishes()
        return value.value() == base.value() == 1

    # divisors

    def assume(self, trees: list[Json]) -> list[Json]:
        """Know that formulas do not vanish; returns those with names that are not defined yet."""
        ready = [names_in(tree) <= self.env.keys() for tree in trees]
        for tree in compress(trees, ready):
            for factor in factors(tree) or [0]:
                with self.statement(False):
                    element = self.scalar(factor)
                need(element.value() is None, "a number is assumed not to vanish")
                self.enter(element, say(factor))
        return [*compress(trees, map(not_, ready))]

    def enter(self, element: Element, words: str) -> None:
        """Know that an element does not vanish."""
        with self.statement():
            self.inverse(element, words)

    def inverse(self, element: Element, words: str = "") -> Element:
        """One over the element: the other values over its norm, a product of divisors.

        The words are for the case that a new divisor has to be entered.
        """
        above, norm = element.normed()
        words = words if above.value() == 1 else ""
        norm, powers = norm.cleared()
        need(norm.terms, "it divides by zero")
        above = above * powers
        for name in self.known:
            while (quotient := norm.over(self.ring.divisors[name])) is not None:
                norm, above = quotient, above * self.ring.generator(name)
        if norm.value() is None:
            content, norm = norm.primitive()
            return above * self.part(norm, words) * self.ring.number(1 / content)
        return above * self.ring.number(1 / Fraction(norm.value() or 0))

    def part(self, norm: Element, words: str) -> Element:
        """One over a polynomial that divides a known divisor, or becomes one."""
        for name in self.known:
            if (quotient := self.ring.divisors[name].over(norm)) is not None:
                return quotient * self.ring.generator(name)
        if not self.stating:
            raise Rejected(f"it divides by what may be zero: {norm.words():.200}")
        same = (n for n, divisor in self.ring.divisors.items() if divisor.terms == norm.terms)
        if not (name := next(same, "")):
            name = f"1/{len(self.ring.divisors)}"
            self.ring.adjoin(name)
            self.ring.divisors[name] = norm
        self.known[name] = words or norm.words()
        return self.ring.generator(name)

    # motion

    def move(self, rows: list[Json], others: list[tuple[Element, Element]]) -> None:
        """Enter the rows of a field, and check that all names move as they have to."""
        rates: Rates = {} if self.rates is None else self.rates
        if rows:
            self.rates, self.waiting = rates, {*self.variables}
        moved = set[str]()
        for row in rows:
            names, mass, force = items(row, 3)
            mass, force = self.value(mass), self.value(force)
            need(len(items(names)) == len(mass) == len(force), "a row of the field is odd")
            new = {
                label(n): f * self.inverse(m) for n, m, f in zip(names, mass, force, strict=True)
            }
            twice = moved & new.keys() or len(new) < len(names)
            need(not twice and new.keys() <= self.env.keys(), "a name moves twice, or is none")
            fixed = {*self.constants, *self.ring.powers}
            need(not new.keys() & fixed, "a constant moves, or a power by itself")
            others += [(self.scalar(name), rate) for name, rate in new.items()]
            rates |= {name: rate for name, rate in new.items() if name in self.ring.at}
            moved |= new.keys()
            self.waiting -= moved
        need(not self.waiting, "a variable does not move")
        for own, rate in others:
            twice_rate = own * rate + own * rate
            same = (self.along(own, rates) - rate).vanishes()
            square = (self.along(own * own, rates) - twice_rate).vanishes()
            need(same and square, "a name moves otherwise")

    def change(self, before: list[Space], data: Json) -> list[tuple[Element, Element]]:
        """Enter the rates of new variables, by the chain rule; the inverse has to be one.

        Returns the old names in terms of the new ones, and their rates.
        """
        record(data, "old formulas time")
        self.old = before[integer(data["old"], 0, len(before) - 1)]
        source = self.old.local()
        source.stating, formulas = True, pairs(data["formulas"])
        new = {label(name): source.scalar(tree) for name, tree in formulas}
        need(len(new) == len(formulas) == len(source.variables), "the change is not one to one")
        need({*self.variables} <= new.keys() <= self.env.keys(), "a new variable has no formula")
        fixed = {*self.constants, *self.ring.powers}
        need(not new.keys() & fixed, "a constant moves, or a power by itself")
        here = self.carried(source.ring, {name: self.scalar(name) for name in source.bar})
        back = ((here(e) - self.scalar(name)).vanishes() for name, e in new.items())
        need(all(back), "the inverse does not give the variables back")
        for name, conjugate in source.bar.items():
            both = here(conjugate) - self.conj(here.images[name])
            need(both.vanishes(), f"{name} does not keep its conjugate, it is not real")
        granted = [*source.granted, *map(source.scalar, source.data.get("nonzero", []))]
        self.granted = [here(e) for e in granted]
        time = here(source.scalar(data["time"]))
        self.inverse(time)
        rates = {name: here(source.derivative(e)) * time for name, e in new.items()}
        self.rates = {name: rate for name, rate in rates.items() if name in self.ring.at}
        old = {name: here(source.derivative(source.scalar(name))) * time for name in source.bar}
        own = [(self.scalar(name), rate) for name, rate in rates.items()]
        return [*own, *((here.images[name], rate) for name, rate in old.items())]

    def along(self, element: Element, rates: Rates) -> Element:
        """The derivative; what has no rate is constant, or follows from its relation."""
        found = list[Element]()
        for name in element.generators():
            if name not in rates:
                rates[name] = self.rate(name, rates)
            if rates[name].terms:
                found.append(element.partial(name) * rates[name])
        return self.ring.total(found)

    def rate(self, name: str, rates: Rates) -> Element:
        """The derivative of a generator without a rate of its own."""
        ring, own = self.ring, self.ring.generator(name)
        need(name not in ring.unknown, f"{name} is unknown, and so is its derivative")
        need(name not in self.waiting, f"the derivative of {name} is not known yet")
        if name in ring.divisors:
            return -own * own * self.along(ring.divisors[name], rates)
        if name in ring.powers:
            base, exponent = ring.powers[name]
            return exponent * own * self.along(base, rates) * self.inverse(base)
        change = self.along(ring.roots[name], rates) if name in ring.roots else ring.number(0)
        half = change.partial(name) * ring.number(Fraction(1, 2))
        if (change - own * (half + half)).vanishes():
            return half
        return change * own * self.inverse(own * own + own * own)

    def derivative(self, element: Element) -> Element:
        """The derivative along the vector field."""
        if self.rates is None:
            raise Rejected("there is no vector field")
        return self.along(element, self.rates)

    # formulas

    def scalar(self, tree: Json) -> Element:
        """The value of a formula that is no vector."""
        value = self.value(tree)
        need(len(value) == 1, "a number is expected, no vector")
        return value[0]

    def value(self, tree: Json) -> Value:
        """The value of a formula."""
        if type(tree) is str:
            need(tree in self.env, f"{tree:.80} is not defined")
            return self.env[tree]
        if type(tree) is int:
            return (self.ring.number(tree),)
        op, *parts = items(tree) or [""]
        need(type(op) is str and op in OPERATIONS, "an operation is not understood")
        least, most = OPERATIONS[op]
        need(least <= len(parts) <= most, f"{op} is one of another number of formulas")
        if op == "^":
            return (self.scalar(parts[0]) ** integer(parts[1], 0, 64),)
        if op == "d":
            return (self.partial(*parts),)
        if op in ("vector", "diag"):
            return tuple(map(self.scalar, parts))
        values = [self.value(part) for part in parts]
        if len(values) == 1:
            return tuple(self.unary(op, e) for e in values[0])
        if op == "+":
            need(len({*map(len, values)}) == 1, "a number is added to a vector")
            return tuple(map(self.ring.total, zip(*values, strict=True)))
        return reduce(partial(self.binary, op), values)

    def partial(self, name: Json, tree: Json) -> Element:
        """A partial derivative; other variables and constants stay."""
        need(type(name) is str and name in self.bar, "it is no variable")
        related = {*self.ring.roots, *self.ring.powers}
        related |= {n for _, exponent in self.ring.powers.values() for n in exponent.generators()}
        need(name not in related, f"{name} is no variable")
        fixed = dict.fromkeys((*self.variables, *self.constants), self.ring.number(0))
        return self.along(self.scalar(tree), fixed | {name: self.ring.number(1)})

    def unary(self, op: str, element: Element) -> Element:
        """An operation on a component."""
        if op == "-":
            return -element
        if op == "D":
            return self.derivative(element)
        if op == "conj":
            return self.conj(element)
        found = [n for n, square in self.ring.roots.items() if (square - element).vanishes()]
        need(found, "a root is taken that is not declared")
        return self.ring.generator(found[0])

    def binary(self, op: str, a: Value, b: Value) -> Value:
        """A product or a quotient, by components, or a product of vectors."""
        if op == "cross":
            need(len(a) == len(b) == 3, "a vector product is one of vectors in space")
            return tuple(a[j] * b[k] - a[k] * b[j] for j, k in ((1, 2), (2, 0), (0, 1)))
        need(op != "dot" or len(a) == len(b) > 1, "a scalar product is one of two vectors")
        b = tuple(map(self.inverse, b)) if op == "/" else b
        a, b = (a * len(b) if len(a) == 1 else a), (b * len(a) if len(b) == 1 else b)
        need(len(a) == len(b), "vectors have different lengths")
        products = tuple(x * y for x, y in zip(a, b, strict=True))
        return (self.ring.total(products),) if op == "dot" else products

    def differences(self, equations: Json) -> list[Element]:
        """Left minus right sides, by components."""
        both = [(self.value(left), self.value(right)) for left, right in pairs(equations)]
        need(all(len(a) == len(b) for a, b in both), "a number is equal to a vector")
        return [x - y for a, b in both for x, y in zip(a, b, strict=True)]


# -- points and proofs -------------------------------------------------------------


def rational(space: Space, tree: Json) -> Fraction:
    """The value of a formula of integers."""
    number = Space({"variables": []}, [], Ring(space.ring.work)).scalar(tree).value()
    if number is None:
        raise Rejected("a rational number is expected")
    return number


def numbers_of(space: Space, points: list[Json]) -> Space:
    """The numbers in which points are given: i and square roots of positive integers."""
    lists = [items(record(point, "roots values")["roots"]) for point in points]
    roots = {integer(d, 2, 10**12) for roots in lists for d in roots}
    squares = {"i": ["-", 1], **{f"\\sqrt{{{d}}}": d for d in sorted(roots)}}
    steps = [["root", name, tree] for name, tree in squares.items()]
    return type(space)({"variables": [], "steps": steps}, [], space.ring.another())


def locate(space: Space, data: Json, given: list[Element], numbers: Space | None = None) -> Map:
    """A real point of the setting, where elements vanish and no known divisor does."""
    numbers = numbers or numbers_of(space, [data])
    values = {label(name): numbers.scalar(tree) for name, tree in pairs(data["values"])}
    whole = values.keys() == space.bar.keys() and len(values) == len(data["values"])
    need(whole, "a value of the point is missing, or unknown, or given twice")
    at = numbers.carried(space.ring, values)
    for name, conjugate in space.bar.items():
        real = (at(conjugate) - numbers.conj(at.images[name])).vanishes()
        need(real, f"{name} is not real there")
    need(all(at(e).vanishes() for e in given), "the point is not where it should be")
    need(all(at(e).differs() for e in space.granted), "a condition fails before the change")
    for name, words in space.known.items():
        try:
            at(space.ring.generator(name))
        except Rejected:
            raise Rejected(f"a condition fails at the point: {words:.200}") from None
    return at


def combined(space: Space, goal: Element, row: Json, known: list[Element]) -> bool:
    """Whether a goal is the combination of known elements that a row of formulas gives."""
    need(len(items(row)) in (0, len(known)), "a row has another length")
    parts = (space.scalar(tree) * e for tree, e in zip(row, known, strict=False))
    return (goal - space.ring.total(parts)).vanishes()


def squares_of(space: Space, data: Json) -> Element:
    """A sum of squares of real elements, with positive numbers."""
    found = list[Element]()
    for tree, base in pairs(data):
        number, element = rational(space, tree), space.scalar(base)
        need(number > 0, "a square is taken away")
        need(space.is_real(element), "a square is one of what is not real")
        found.append(space.ring.number(number) * element * element)
    return space.ring.total(found)


PROOF = "product cofactors cases power"


def settle(space: Space, goals: list[Element], known: list[Element], proof: Json) -> None:
    """Goals vanish where known elements do: as combinations, or in all cases of a product."""
    record(proof, "", PROOF)
    need(("product" in proof) == ("cases" in proof), "cases belong to a product")
    if "product" in proof:
        need(space.all_real(), "cases are for real names")
        groups = [[*map(space.scalar, items(group))] for group in items(proof["product"])]
        need(groups and all(groups), "a product is empty")
        for group, case in zip(groups, items(proof["cases"], len(groups)), strict=True):
            settle(space, goals, known + group, case)
        whole = space.ring.number(1)
        for group in groups:
            whole = whole * (space.ring.total(e * e for e in group) if group[1:] else group[0])
        goals = [whole]
    power = integer(proof.get("power", 1), 1, 16)
    rows = items(proof["cofactors"], len(goals)) if "cofactors" in proof else [[]] * len(goals)
    for goal, row in zip(goals, rows, strict=True):
        need(combined(space, goal**power, row, known), "the two sides are not equal")


def minors(ring: Ring, matrix: list[list[Element]]) -> list[Element]:
    """The maximal minors of a matrix with no more rows than columns, column by column."""
    found: dict[tuple[int, ...], Element] = {(): ring.number(1)}
    width = len(matrix[0])
    for size, row in enumerate(matrix, 1):
        smaller, found = found, {}
        for columns in combinations(range(width), size):
            parts = list[Element]()
            for k, column in enumerate(columns):
                part = row[column] * smaller[columns[:k] + columns[k + 1 :]]
                parts.append(-part if (size - k) % 2 == 0 else part)
            found[columns] = ring.total(parts)
    return [*found.values()]


# -- goals -------------------------------------------------------------------------
#
# Each function takes a space with the conditions of the goal in it, and the data of the goal
# and of the evidence. It returns if the evidence shows the goal, or denies it.


def part_of(data: Json, keys: str) -> Json:
    """The part of an object under some keys."""
    return {key: data[key] for key in keys.split() if key in data}


def follows(space: Space, goal: Json, evidence: Json) -> None:
    """Where the given equations hold, one of the conclusions does."""
    with space.statement():
        given = space.differences(goal["given"])
        conclusions = [space.differences(one) for one in items(goal["conclusions"])]
    need(all(conclusions), "nothing is stated")
    # for an empty set, a condition that holds nowhere on it would be the whole proof
    record(evidence, "point", f"away {PROOF}" if conclusions else PROOF)
    locate(space, evidence["point"], given if conclusions else [])
    goals = [prod(choice, start=space.ring.number(1)) for choice in product(*conclusions)]
    settle(space, goals, given, part_of(evidence, PROOF))


def fails(space: Space, goal: Json, evidence: Json) -> None:
    """At a point where the given equations hold, each conclusion fails."""
    record(evidence, "point", "away")
    with space.statement():
        given = space.differences(goal["given"])
        conclusions = [space.differences(one) for one in items(goal["conclusions"])]
    need(all(conclusions) and (conclusions or given), "nothing is stated")
    at = locate(space, evidence["point"], given)
    for conclusion in conclusions:
        need(any(at(e).differs() for e in conclusion), "the two sides may be equal")


def differentials(space: Space, goal: Json) -> tuple[list[Element], list[list[Element]]]:
    """The given equations, and the partial derivatives of functions and of these."""
    one = space.ring.number(1)
    with space.statement():
        given = space.differences(goal["given"])
        chosen = [e for tree in items(goal["functions"]) for e in space.value(tree)] + given
        need(chosen and space.variables, "nothing is stated")
        return given, [[space.along(e, {v: one}) for v in space.variables] for e in chosen]


def independent(space: Space, goal: Json, evidence: Json) -> int:
    """The number of differentials, which are independent at a point of the given equations."""
    record(evidence, "point", "away")
    given, matrix = differentials(space, goal)
    at = locate(space, evidence["point"], given)
    rows = [[at(e) for e in row] for row in matrix]
    while rows:
        row = rows.pop()
        k = next((k for k, e in enumerate(row) if e.differs()), None)
        if k is None:
            raise Rejected("the differentials may depend on each other")
        over = at.space.inverse(row[k])
        rows = [[a - r[k] * over * b for a, b in zip(r, row, strict=True)] for r in rows]
    return len(matrix)


def rank(space: Space, goal: Json, evidence: Json) -> None:
    """At a point the differentials are independent, and as many as stated."""
    size = independent(space, goal, evidence)
    need(size == goal["rank"], f"the rank is {size}")


def no_rank(space: Space, goal: Json, evidence: Json) -> None:
    """Their number is another one, or they depend on each other everywhere."""
    if "minors" not in evidence:
        need(independent(space, goal, evidence) != goal["rank"], "the rank is as stated")
        return
    record(evidence, "minors")
    given, matrix = differentials(space, goal)
    found = minors(space.ring, matrix) if len(matrix) <= len(space.variables) else []
    for minor, row in zip(found, items(evidence["minors"], len(found)), strict=True):
        need(combined(space, minor, row, given), "a minor may differ from zero")


def positive(space: Space, goal: Json, evidence: Json) -> None:
    """A formula is a sum of squares where the given equations hold, and not zero."""
    record(evidence, "point squares cofactors", "away zero")
    with space.statement():
        given, formula = space.differences(goal["given"]), space.scalar(goal["formula"])
    locate(space, evidence["point"], given)
    (row,) = items(evidence["cofactors"], 1)
    rest = formula - squares_of(space, evidence["squares"])
    need(combined(space, rest, row, given), "the two sides are not equal")
    if "zero" in evidence:
        settle(space, [space.ring.number(1)], [*given, formula], evidence["zero"])
    else:
        space.inverse(formula)


def not_positive(space: Space, goal: Json, evidence: Json) -> None:
    """At a point where the given equations hold, a formula is a number that is not positive."""
    record(evidence, "point", "away")
    with space.statement():
        given, formula = space.differences(goal["given"]), space.scalar(goal["formula"])
    value = locate(space, evidence["point"], given)(formula).value()
    need(value is not None and value <= 0, "it is positive, or no rational number")


def only(element: Element, names: Iterable[str]) -> Element:
    """An element, if nothing but some generators, and what is divided by them, is in it."""
    divisors = element.ring.divisors
    for name in element.generators():
        inside = divisors[name].generators() if name in divisors else [name]
        need({*inside} <= {*names}, "there is another name in a formula")
    return element


def equations_of(space: Space, goal: Json) -> list[Element]:
    """The equations whose solutions are counted: in some variables and the constants."""
    names = labels(goal["names"])
    need(names and {*names} <= {*space.variables}, "what is counted are values of variables")
    need("conjugates" not in space.data, "what is counted has to be real")
    with space.statement():
        equations = space.differences(goal["equations"])
    divisors = [name for known in space.known for name in space.ring.divisors[known].generators()]
    need(not {*names} & {*divisors}, "a condition is about what is counted")
    return [only(e, [*names, *space.constants]) for e in equations]


class Solutions:
    """Equations, and evidence that they have exactly so many real solutions.

    A form s in the variables obeys an eliminant, a polynomial over the constants, and determines
    the variables: solutions are roots. Each root gives a solution. By Hermite, all roots are
    real and distinct if the matrix of their power sums has positive leading minors.
    """

    def __init__(self, space: Space, goal: Json, evidence: Json) -> None:
        keys = "point root form eliminant solved cofactors quotients factors minors"
        record(evidence, keys, "away")
        self.space, self.evidence = space, evidence
        self.equations = equations_of(space, goal)
        locate(space, evidence["point"], self.equations)
        self.form = only(space.scalar(evidence["form"]), [*goal["names"], *space.constants])
        self.eliminant = [self.constant(tree) for tree in items(evidence["eliminant"])]
        need(self.eliminant, "there is no eliminant")
        solved = [items(row, 3) for row in items(evidence["solved"])]
        need([row[0] for row in solved] == goal["names"], "the solved names are others")
        self.below = [self.constant(row[2]) for row in solved]
        self.root, self.generator = space.bind(evidence["root"])
        self.above = [self.polynomial(row[1]) for row in solved]
        self.own = [space.scalar(row[0]) for row in solved]

    def constant(self, tree: Json) -> Element:
        """The value of a formula in the constants."""
        return only(self.space.scalar(tree), self.space.constants)

    def polynomial(self, tree: Json) -> Element:
        """The value of a formula in the root and the constants."""
        return only(self.space.scalar(tree), [self.root, *self.space.constants])

    def eliminated(self, value: Element) -> Element:
        """The value of the eliminant."""
        terms = (c * value**k for k, c in enumerate(self.eliminant))
        return self.space.ring.total((*terms, value ** len(self.eliminant)))

    def put(self, element: Element, values: dict[str, Element]) -> Element:
        """An element with values for some generators."""
        own = {name: self.space.ring.generator(name) for name in element.generators()}
        return self.space.carried(self.space.ring, own | values)(element)

    def solutions_are_roots(self) -> None:
        """The equations imply the eliminant of the form, and give the variables by the form."""
        goals = [self.eliminated(self.form)]
        for own, above, below in zip(self.own, self.above, self.below, strict=True):
            goals.append(below * own - self.put(above, {self.root: self.form}))
        rows = items(self.evidence["cofactors"], len(goals))
        for goal, row in zip(goals, rows, strict=True):
            need(combined(self.space, goal, row, self.equations), "the two sides are not equal")

    def roots_are_solutions(self) -> None:
        """The eliminant implies the equations, and that the form is the root."""
        inverses = map(self.space.inverse, self.below)
        solved = (above * inverse for above, inverse in zip(self.above, inverses, strict=True))
        names = [name for own in self.own for name in own.generators()]
        values = dict(zip(names, solved, strict=True))
        goals = [self.put(e, values) for e in (*self.equations, self.form)]
        goals[-1] = goals[-1] - self.generator
        quotients = items(self.evidence["quotients"], len(goals))
        for goal, tree in zip(goals, quotients, strict=True):
            rest = goal - self.polynomial(tree) * self.eliminated(self.generator)
            need(rest.vanishes(), "a root of the eliminant is no solution")

    def all_roots_are_real(self) -> None:
        """The leading minors of the matrix of power sums are products of positive factors."""
        factors = [self.positive(data) for data in items(self.evidence["factors"])]
        sums, size = self.power_sums(), len(self.eliminant)
        rows = [items(row, 2) for row in items(self.evidence["minors"], size)]
        for k, (tree, exponents) in enumerate(rows, 1):
            (minor,) = minors(self.space.ring, [sums[j : j + k] for j in range(k)])
            need((number := rational(self.space, tree)) > 0, "a minor is not positive")
            powers = [integer(e, 0, 64) for e in items(exponents, len(factors))]
            parts = (factor**e for factor, e in zip(factors, powers, strict=True))
            whole = prod(parts, start=self.space.ring.number(number))
            need((minor - whole).vanishes(), "a minor is another product")

    def positive(self, data: Json) -> Element:
        """A factor over the constants that is positive wherever there is a solution."""
        record(data, "factor squares", "cofactors granted")
        factor = self.constant(data["factor"])
        rest = factor - squares_of(self.space, data["squares"])
        row = data.get("cofactors", [])
        need(combined(self.space, rest, row, self.equations), "a factor is no sum of squares")
        self.space.inverse(factor)
        if "granted" in data:  # where the factor vanishes, something granted would
            place, row = items(data["granted"], 2)
            granted = self.space.data.get("nonzero", [])
            gone = self.space.scalar(granted[integer(place, 0, len(granted) - 1)])
            bases = [self.space.scalar(base) for _, base in pairs(data["squares"])]
            same = combined(self.space, gone, row, [*bases, *self.equations])
            need(same, "what is granted need not vanish with a factor")
        return factor

    def power_sums(self) -> list[Element]:
        """The sums of the powers of all roots, by Newton's identities."""
        ring, size = self.space.ring, len(self.eliminant)
        signed, sums = [-c for c in reversed(self.eliminant)], [ring.number(size)]
        for k in range(1, 2 * size - 1):
            parts = [signed[j - 1] * sums[k - j] for j in range(1, min(k - 1, size) + 1)]
            parts += [signed[k - 1] * ring.number(k)] if k <= size else []
            sums.append(ring.total(parts))
        return sums


def counted(space: Space, goal: Json, evidence: Json) -> int:
    """The number of real solutions that the evidence shows."""
    found = Solutions(space, goal, evidence)
    found.solutions_are_roots()
    found.roots_are_solutions()
    found.all_roots_are_real()
    return len(found.eliminant)


def count(space: Space, goal: Json, evidence: Json) -> None:
    """There are as many real solutions as stated."""
    size = counted(space, goal, evidence)
    need(size == goal["number"], f"the number of solutions is {size}")


def no_count(space: Space, goal: Json, evidence: Json) -> None:
    """There is one solution more for some constants, or another number for all."""
    if "points" not in evidence:
        size = counted(space, goal, evidence)
        need(size != goal["number"], "the number of solutions is as stated")
        return
    points = items(record(evidence, "points", "away")["points"], goal["number"] + 1)
    equations, numbers = equations_of(space, goal), numbers_of(space, points)
    found = [locate(space, point, equations, numbers).images for point in points]
    others = {*space.variables, *space.constants} - {*goal["names"]}
    for one, other in combinations(found, 2):
        same = all((one[name] - other[name]).vanishes() for name in others)
        need(same, "the points belong to different constants")
        apart = any((one[name] - other[name]).differs() for name in goal["names"])
        need(apart, "two points may be the same")


# -- a problem ---------------------------------------------------------------------

Judge = Callable[[Space, Json, Json], None]
KINDS: dict[str, tuple[str, Judge, Judge]] = {
    "follows": ("given conclusions", follows, fails),
    "fails": ("given conclusions", fails, follows),
    "rank": ("functions given rank", rank, no_rank),
    "positive": ("given formula", positive, not_positive),
    "count": ("equations names number", count, no_count),
}


class Problem:
    """Spaces and goals."""

    def __init__(self, spaces: Json, goals: Json, ring: Ring, kind: type[Space] = Space) -> None:
        self.spaces = list[Space]()
        for data in items(spaces):
            self.spaces.append(kind(data, self.spaces, ring.another()))
        self.goals = items(goals)
        need(self.goals, "there is no goal")
        for goal in self.goals:
            self.look(goal)

    def look(self, goal: Json, inner: bool = False) -> None:
        """Look at the shape of a goal."""
        need(type(goal) is dict and type(goal.get("goal")) is str, "a goal is expected")
        if goal["goal"] == "exists" and not inner:
            record(goal, "goal numbers expressions goals")
            labels([*items(goal["numbers"]), *items(goal["expressions"])])
            need(items(goal["goals"]), "nothing is stated")
            need(goal["numbers"] or goal["expressions"], "no name is bound")
            for one in goal["goals"]:
                self.look(one, inner=True)
            return
        need(
            goal["goal"] in KINDS and not (inner and goal["goal"] == "count"), "the goal is unknown"
        )
        record(goal, f"goal space {KINDS[goal['goal']][0]}")
        integer(goal["space"], 0, len(self.spaces) - 1)
        for key in {"rank", "number"} & goal.keys():
            integer(goal[key], 0, 1000)

    def holds(self, goal: Json, evidence: Json) -> Theorem:
        """What the evidence proves."""
        if goal["goal"] == "exists":
            return self.exists(goal, evidence)
        space = self.stage(goal, evidence)
        KINDS[goal["goal"]][1](space, goal, evidence)
        return theorem(sentence(goal), space, evidence)

    def denied(self, goal: Json, evidence: Json) -> Theorem:
        """What the evidence refutes."""
        if goal["goal"] == "exists":
            return self.exists_not(goal, evidence)
        space = self.stage(goal, evidence)
        KINDS[goal["goal"]][2](space, goal, evidence)
        return theorem(sentence(goal, holds=False), space, evidence)

    def stage(self, goal: Json, evidence: Json, values: Json = ()) -> Space:
        """The space of a goal, with its conditions, and bound names that stand for values."""
        need(type(evidence) is dict, "evidence is expected")
        space: Space = self.spaces[goal["space"]].local()
        need(not space.assume(items(evidence.get("away", []))), "a condition has an unknown name")
        found = {name: space.value(tree) for name, tree in values}
        need(not found.keys() & space.env.keys(), "a bound name has another meaning")
        space.env |= found
        return space

    def exists(self, goal: Json, evidence: Json) -> Theorem:
        """Values for the bound names, with which all goals hold."""
        record(evidence, "values evidence")
        bound = goal["numbers"] + goal["expressions"]
        values = {label(name): tree for name, tree in pairs(evidence["values"])}
        need([name for name, _ in evidence["values"]] == bound, "values are for other names")
        entries = items(evidence["evidence"], len(goal["goals"]))
        used, found = set[str](), list[Theorem]()
        for one, entry in zip(goal["goals"], entries, strict=True):
            names = [name for name in bound if name in names_of_goal(one)]
            used |= {*names}
            space = self.stage(one, entry, [(name, values[name]) for name in names])
            for name in {*names} & {*goal["numbers"]}:
                rational(space, values[name])
            KINDS[one["goal"]][1](space, one, entry)
            found.append(theorem(sentence(one), space, entry))
        need(used == {*bound}, "a bound name is not used")
        shown = ", ".join(f"{name} = {say(tree)}" for name, tree in values.items())
        whole = theorem(f"{sentence(goal)}, namely {shown}" if shown else sentence(goal))
        return replace(whole, parts=found)

    def exists_not(self, goal: Json, evidence: Json) -> Theorem:
        """A point where an equation fails, whatever the bound names stand for."""
        record(evidence, "inner points")
        one = goal["goals"][integer(evidence["inner"], 0, len(goal["goals"]) - 1)]
        plain = one["goal"] == "follows" and one["given"] == [] and len(one["conclusions"]) == 1
        need(plain, "no identity is denied")
        space = self.stage(one, {})
        bound = {name: space.bind(name)[0] for name in goal["numbers"] + goal["expressions"]}
        space.ring.unknown |= {bound[name] for name in goal["expressions"]}
        with space.statement():
            differences = space.differences(one["conclusions"][0])
        weighted = [
            (rational(space, weight), locate(space, point, []))
            for weight, point in pairs(evidence["points"])
        ]
        need(
            len(weighted) == 1 or not goal["expressions"],
            "expressions may differ from point to point",
        )
        fixed = any(fails_regardless(weighted, e, [*bound.values()]) for e in differences)
        need(fixed, "the two sides may be equal")
        points = [point for _, point in evidence["points"]]
        return theorem(sentence(goal, holds=False), space, {"points": points})


def fails_regardless(
    weighted: list[tuple[Fraction, Map]], element: Element, unknown: list[str]
) -> bool:
    """Whether a sum of values at points is not zero, whatever the unknown names stand for."""
    parts: dict[tuple[int, ...], Element] = {(): element}
    for name in unknown:
        parts = {(*k, e): p for k, q in parts.items() for e, p in q.split(name).items()}
    free = parts.pop((0,) * len(unknown), None)
    if free is None:
        return False
    if len(weighted) == 1:
        ((_, at),) = weighted
        return all(at(part).vanishes() for part in parts.values()) and at(free).differs()

    def total(part: Element) -> Fraction:
        values = [at(part).value() for _, at in weighted]
        need(None not in values, "a value at a point is no rational number")
        return sum((w * (v or 0) for (w, _), v in zip(weighted, values, strict=True)), Fraction(0))

    return total(free) != 0 and not any(map(total, parts.values()))


def names_of_goal(goal: Json) -> set[str]:
    """All names in the formulas of a goal."""
    conclusions = [sides for one in items(goal.get("conclusions", [])) for sides in pairs(one)]
    equations = [*conclusions, *pairs(goal.get("given", []))]
    trees = [side for sides in equations for side in sides] + items(goal.get("functions", []))
    return names_in([0, *trees, goal.get("formula", 0)])


# -- words -------------------------------------------------------------------------


def say(tree: Json) -> str:
    """A formula in plain letters."""
    if type(tree) is list:
        op, *parts = tree[0], *map(say, tree[1:])
        need(op in OPERATIONS, "an operation is not understood")
        if len(parts) > 1 and op in ("+", "*", "/", "^"):
            return f"({f' {op} '.join(parts)})"
        return f"(-{parts[0]})" if op == "-" else f"{op}({', '.join(parts)})"
    return str(tree) if type(tree) is int else label(tree)


def say_all(equations: Json, sign: str = "=") -> str:
    """Equations in plain letters."""
    return ", ".join(f"{say(left)} {sign} {say(right)}" for left, right in pairs(equations))


def wherever(goal: Json) -> str:
    """The given equations of a goal."""
    return f" wherever {say_all(goal['given'])}" if goal["given"] else ""


def say_follows(goal: Json) -> str:
    """What follows."""
    if not goal["conclusions"]:
        return f"there is no real point where {say_all(goal['given']) or '0 = 0'}"
    return " or ".join(map(say_all, goal["conclusions"])) + wherever(goal)


def say_rank(goal: Json) -> str:
    """What is independent."""
    trees = [*goal["functions"], *(["+", a, ["-", b]] for a, b in goal["given"])]
    shown, size = ", ".join(map(say, trees)), goal["rank"]
    whole = f"the differentials of {shown}, {size} in number, are independent at a real point"
    return whole + (f" with {say_all(goal['given'])}" if goal["given"] else "")


def say_positive(goal: Json) -> str:
    """What is positive."""
    return f"{say(goal['formula'])} > 0{wherever(goal)}"


def say_count(goal: Json) -> str:
    """What is counted."""
    names, number = ", ".join(goal["names"]), goal["number"]
    solutions = f"{number} real solution{'s' * (number != 1)} for {names}"
    return f"{say_all(goal['equations'])} has exactly {solutions} if it has one"


def say_exists(goal: Json) -> str:
    """What there is."""
    kinds = {"rational numbers": goal["numbers"], "expressions": goal["expressions"]}
    shown = " and ".join(f"{kind} {', '.join(names)}" for kind, names in kinds.items() if names)
    return f"there are {shown} with {'; '.join(map(sentence, goal['goals']))}"


WORDS: dict[str, Callable[[Json], str]] = {
    "follows": say_follows,
    "rank": say_rank,
    "positive": say_positive,
    "count": say_count,
    "exists": say_exists,
}


def sentence(goal: Json, holds: bool = True) -> str:
    """A goal in plain letters, or that it does not hold."""
    if goal["goal"] == "fails":
        return sentence({**goal, "goal": "follows"}, not holds)
    words = WORDS[goal["goal"]](goal)
    return words if holds else f"it is false that {words}"


@dataclass(frozen=True)
class Theorem:
    """What was proved, in plain letters: where, and about what."""

    words: str
    where: list[str]
    about: list[str]
    parts: list[Theorem]

    def summary(self) -> str:
        """The theorem in a line, with its conditions."""
        where = [*self.where, *(condition for part in self.parts for condition in part.where)]
        return self.words + (f", for {', '.join(dict.fromkeys(where))} != 0" if where else "")

    def lines(self, indent: str = "  ") -> Iterator[str]:
        """All of it."""
        yield indent + self.words
        for line in (*self.about, *(f"for {condition} != 0" for condition in self.where)):
            yield f"{indent}  {line}"
        for part in self.parts:
            yield from part.lines(f"{indent}  ")


def theorem(words: str, space: Space | None = None, evidence: Json = None) -> Theorem:
    """A theorem over a space."""
    if space is None:
        return Theorem(words, [], [], [])
    points = evidence.get("points", [evidence["point"]] if "point" in evidence else [])
    about = [*setting(space), *(f"point: {say_all(p['values'])}" for p in points)]
    return Theorem(words, [*space.known.values()], about, [])


def setting(space: Space) -> Iterator[str]:
    """The data of a space in plain letters, after those of the space that it comes from."""
    data = space.data
    if space.old is not None:
        yield from (f"before the change, {line}" for line in setting(space.old))
        yield from (f"new: {say_all([pair])}" for pair in data["change"]["formulas"])
        yield f"factor of the time: {say(data['change']['time'])}"
    for key in ("variables", "constants"):
        if data.get(key):
            yield f"{key}: {', '.join(data[key])}"
    yield from (f"conjugates: {a}, {b}" for a, b in data.get("conjugates", []))
    for kind, name, tree, *more in data.get("steps", []):
        if kind == "root":
            yield f"root: {name} ^ 2 = {say(tree)}"
            yield from (f"that is: {say_all([sides])}" for sides in more)
        else:
            power = "".join(f" ^ {say(to)}, where {say(tree)} > 0" for to in more)
            yield f"{kind}: {name} = {say(tree)}{power}"
    for names, mass, force in data.get("field", []):
        yield f"field: {say(mass)} D({', '.join(names)}) = {say(force)}"


# -- the file ----------------------------------------------------------------------


@dataclass(frozen=True)
class Certificate:
    """What a file certifies: a claim, the digest of its problem, and theorems."""

    claim: str
    digest: str
    sign: str
    theorems: list[Theorem]

    def summary(self) -> str:
        """All in a line."""
        return f"{self.claim}: {'; '.join(theorem.summary() for theorem in self.theorems)}"


def unique(both: list[tuple[str, Json]]) -> Json:
    """The keys and values of an object, in which no key stands twice."""
    data = dict(both)
    need(len(data) == len(both), "a key stands twice")
    return data


def small(digits: str) -> int:
    """An integer."""
    need(len(digits) * 3 < BITS, "a number is too large")
    return int(digits)


def no_number(digits: str) -> Json:
    """What is no number of this format."""
    raise Rejected(f"{digits:.20} is no integer")


def parsed(text: str) -> Json:
    """The data of a certificate of this format."""
    need(len(text) < SIZE, "it is too long")
    hooks: Json = {"parse_int": small, "parse_float": no_number, "parse_constant": no_number}
    data = json.loads(text, object_pairs_hook=unique, **hooks)
    need(type(data) is dict and data.get("format") == FORMAT, "it is no certificate")
    old = type(data.get("version")) is int and data["version"] == 1
    need(not old, "it is a certificate of format 1: make certificates renews it")
    need(repr(data.get("version")) == repr(VERSION), "it has another format")
    return record(data, "format version claim spaces goals sign evidence digest")


def judged(text: str) -> Certificate:
    """What the text of a certificate proves."""
    data = parsed(text)
    claim, sign, evidence = data["claim"], data["sign"], items(data["evidence"])
    need(
        type(claim) is str and re.fullmatch(r"[\w.-]+", claim, re.ASCII),
        "the claim has an odd name",
    )
    statement = {key: data[key] for key in ("spaces", "goals")}
    digest = hashlib.sha256(json.dumps(statement, sort_keys=True).encode()).hexdigest()[:16]
    need(data["digest"] == digest, "the digest is another one")
    problem = Problem(data["spaces"], data["goals"], Ring([WORK]))
    if sign == "holds":
        need(len(evidence) == len(problem.goals), "evidence is missing")
        both = zip(problem.goals, evidence, strict=True)
        return Certificate(claim, digest, sign, [problem.holds(*pair) for pair in both])
    need(sign == "denied", "it neither holds nor is denied")
    (entry,) = items(evidence, 1)
    need(type(entry) is dict, "evidence is expected")
    goal = problem.goals[integer(entry.get("goal"), 0, len(problem.goals) - 1)]
    rest = {key: value for key, value in entry.items() if key != "goal"}
    return Certificate(claim, digest, sign, [problem.denied(goal, rest)])


def check(text: str) -> Certificate:
    """What the text of a certificate proves; raises Rejected if it proves nothing."""
    try:
        return judged(text)
    except (ArithmeticError, AttributeError, LookupError, MemoryError, RecursionError) as error:
        raise Rejected(f"it is malformed: {type(error).__name__}") from None
    except (TypeError, ValueError) as error:
        raise Rejected(f"it is malformed: {type(error).__name__}") from None


# -- the command line --------------------------------------------------------------


def read(path: str) -> str:
    """The text of a file."""
    try:
        with open(path, encoding="utf-8") as file:
            return file.read(SIZE)
    except (OSError, ValueError) as error:
        raise Rejected(f"it cannot be read: {type(error).__name__}") from None


def say_line(line: str) -> None:
    """Print one line, of printable letters."""
    print(re.sub("[^ -~]", "?", line))


def main(arguments: list[str]) -> int:
    """Check files; the last line says how many are certified. With --full it says all of them."""
    paths, seen = [a for a in arguments if a != "--full"], set[tuple[str, str]]()
    for path in paths:
        try:
            found = check(read(path))
            need(os.path.basename(path) == f"{found.claim}.json", f"it is about {found.claim}")
            need((found.claim, found.digest) not in seen, "it was certified before")
        except Rejected as error:
            say_line(f"REJECTED {path!a}: {error}")
            continue
        seen.add((found.claim, found.digest))
        say_line(found.summary())
        for theorem in found.theorems if "--full" in arguments else ():
            for line in theorem.lines():
                say_line(line)
    say_line(f"CERTIFIED {len(seen)} of {len(paths)}")
    return 6 if not paths else 0 if len(seen) == len(paths) else 5


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
