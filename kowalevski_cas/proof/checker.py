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


class Space:
    """Generators with relations, a conjugation, definitions, and a vector field."""

    def __init__(self, data: Any, spaces: list[Space]) -> None:
        optional = ("constants", "powers", "steps", "nonzero", "conjugates", "field", "change", "clock")
        record(data, ("variables",), optional)
        self.variables, constants = names(data["variables"]), names(data.get("constants", []))
        steps, powers = rows(data.get("steps", []), 3, 5), rows(data.get("powers", []), 3, 3)
        roots = [text(step[1]) for step in steps if step[0] == "root"]
        plain = [*self.variables, *constants, *(text(p[0]) for p in powers)]
        ring = self.ring = Ring([*plain, *roots])
        self.env: dict[str, Value] = {name: ring.generator(name) for name in plain}
        self.used: set[str] = set()
        self.lets: dict[str, Any] = {}
        self.roots: list[tuple[Poly, Element]] = []
        self.conjugates: dict[str, Element] | None = None
        self.rates: dict[str, Element] | None = None
        self.powers = {(text(base), text(exponent)): text(n) for n, base, exponent in powers}
        self.nonzero = items(data.get("nonzero", []))
        for tree in self.nonzero:
            ring.assume(self.scalar(tree))
        self.used.clear()
        for step in steps:
            self.step(*step)
        self.clock = self.scalar(data["clock"]) if "clock" in data else None
        need(not ("field" in data and "change" in data), "there are two fields")
        if "field" in data:
            self.printed_field(rows(data["field"], 3, 3), constants)
        if "change" in data:
            self.change(data["change"], spaces)
        if "conjugates" in data:
            self.conjugation(rows(data["conjugates"], 2, 2))
            if "change" in data:
                self.conjugation_of_change(data["change"], spaces)

    def step(self, kind: Any, name: Any, tree: Any, *sides: Any) -> None:
        """A definition; or a root, perhaps with the printed equation that it obeys."""
        need(text(name) not in self.env, f"{name} is defined twice")
        if kind == "let":
            need(not sides, "a definition has one side")
            self.env[name], self.lets[name] = self.value(tree), tree
            return
        need(kind == "root" and len(sides) in (0, 2), "a step is a definition or a root")
        radicand = self.scalar(tree)
        need(radicand.num, f"the square of {name} is zero")
        self.env[name] = self.ring.adjoin(name, radicand)
        self.roots.append((self.ring.radicands[name], self.ring.generator(name)))
        if sides:
            for left, right in pairwise(self.value(sides[0]), self.value(sides[1])):
                need(not (left - right).num, f"the square of {name} is not what the equation says")

    # -- the field -----------------------------------------------------------

    def printed_field(self, equations: list[Any], constants: list[str]) -> None:
        """Components from equations: factor times derivative = right side."""
        rates: dict[str, Element] = {}
        for left, factor, right in equations:
            below, above = components(self.value(factor)), components(self.value(right))
            need(len(names(left)) == len(below) == len(above), "an equation of motion has a gap")
            for name, divisor, rate in zip(left, below, above, strict=True):
                need(name not in rates and name not in constants, f"{name} moves twice, or not")
                rates[name] = rate * divisor.inverse()
        self.use_field(rates)

    def change(self, data: Any, spaces: list[Space]) -> None:
        """The field of another space through a change of variables and its inverse."""
        record(data, ("from", "formulas", "time"), ())
        old, ring = spaces[index(data["from"], spaces)], self.ring
        need(old.rates is not None, "there is no field to be changed")
        formulas = {text(n): tree for n, tree in rows(data["formulas"], 2, 2)}
        need(len(formulas) == len(data["formulas"]), "a variable is changed twice")
        new = {name: old.scalar(tree) for name, tree in formulas.items()}
        for name in old.ring.shift:
            need(isinstance(self.env.get(name), Element), f"{name} is not given back by the inverse")
        images = {name: self.env[name] for name in old.ring.shift}
        for name, radicand in old.ring.radicands.items():
            square = Element(old.ring, radicand).image(images, ring)
            need(not (images[name] * images[name] - square).num, f"{name} changes its square")
        for name, element in new.items():
            need(not (element.image(images, ring) - self.env[name]).num, f"{name} is not given back")
        shared = {n: old.env[n] for n in old.ring.shift if n not in old.variables}
        for name in old.variables:
            back = old.scalar(self.lets.get(name, name), {**shared, **new})
            need(not (back - old.env[name]).num, f"the inverse for {name} is wrong")
        self.used.update(images)
        per_time = old.scalar(data["time"]).image(images, ring).inverse()
        rates = {n: e.along(old.rate).image(images, ring) * per_time for n, e in new.items()}
        self.use_field(rates)

    def use_field(self, rates: dict[str, Element]) -> None:
        """Take a field: each variable moves, and relations are preserved."""
        generators = {n: r for n, r in rates.items() if n in self.ring.shift}
        need(not set(self.variables) - set(generators), "a variable has no equation of motion")
        self.used.update(rates)
        self.rates = generators
        for name, rate in rates.items():
            if name in self.ring.radicands:
                root = self.ring.generator(name)
                square = Element(self.ring, self.ring.radicands[name])
                twice = root * rate + root * rate
                need(not (twice - square.along(self.rate)).num, f"{name} leaves its relation")
            elif name not in generators:
                need(name in self.env, f"{name} has an equation of motion and no meaning")
                need(not (self.env[name].along(self.rate) - rate).num, f"{name} moves otherwise")

    def rate(self, name: str) -> Element:
        """The derivative of a generator along the field."""
        need(self.rates is not None, "there is no vector field")
        rates: dict[str, Element] = self.rates or {}
        if name not in rates:
            rates[name] = self.root_rate(name, self.rate)
            for (base, exponent), power in self.powers.items():
                if name == power:
                    value = self.scalar(base)
                    speed = value.along(self.rate) * value.inverse()
                    rates[name] = speed * self.scalar(exponent) * self.env[name]
        return rates[name]

    def root_rate(self, name: str, rate: Rate) -> Element:
        """The derivative of a root by that of its square; other generators are constant."""
        if name not in self.ring.radicands:
            return self.ring.number(0)
        square = Element(self.ring, self.ring.radicands[name])
        change = square.along(rate)
        return change * self.ring.generator(name) * (square + square).inverse() if change.num else change

    def partial(self, element: Element, name: str) -> Element:
        """The partial derivative by a variable or constant that is no root."""
        need(name in self.ring.shift and name not in self.ring.radicands, f"{name} is no variable")

        def rate(other: str) -> Element:
            return self.ring.number(1) if other == name else self.root_rate(other, rate)

        return element.along(rate)

    # -- the conjugation -----------------------------------------------------

    def conjugation(self, pairs: list[Any]) -> None:
        """The conjugation swaps pairs, turns i into -i, and preserves all relations."""
        swap: dict[str, str] = {}
        for a, b in pairs:
            need({text(a), text(b)} <= set(self.ring.shift) and not {a, b} & set(swap), "a pair is odd")
            swap |= {a: b, b: a}
        images = {n: self.ring.generator(swap.get(n, n)) for n in self.ring.shift}
        if "i" in images:
            images["i"] = -images["i"]
        for name, radicand in self.ring.radicands.items():
            square = Element(self.ring, radicand).image(images, self.ring)
            need(not (images[name] * images[name] - square).num, f"{name} has no conjugate")
        self.conjugates = images

    def conjugation_of_change(self, data: Any, spaces: list[Space]) -> None:
        """The conjugation is the one of the old variables."""
        old, new = spaces[data["from"]], dict(data["formulas"])
        back = {n: self.env[n] for n in old.ring.shift}
        for name in new:
            bar = old.conjugate(old.scalar(new[name])).image(back, self.ring)
            need(not (bar - self.conjugate(self.env[name])).num, f"{name} has another conjugate")

    def conjugate(self, element: Element) -> Element:
        """The complex conjugate."""
        need(self.conjugates is not None, "there is no conjugation")
        return element.image(self.conjugates or {}, self.ring)

    # -- the meaning of formulas ---------------------------------------------

    def scalar(self, tree: Any, env: Mapping[str, Value] | None = None) -> Element:
        """The value of a formula that is no vector."""
        value = self.value(tree, env)
        need(isinstance(value, Element), "a vector stands where a number is expected")
        return value  # type: ignore[no-any-return]

    def value(self, tree: Any, env: Mapping[str, Value] | None = None) -> Value:
        """The value of a formula."""
        if isinstance(tree, str):
            self.used.add(tree)
            known = self.env if env is None else env
            need(tree in known, f"{tree} is not defined")
            return known[tree]
        if isinstance(tree, int) and not isinstance(tree, bool):
            return self.ring.number(tree)
        need(isinstance(tree, list) and len(tree) > 1, "a formula is expected")
        op, *rest = tree
        if op == "^":
            need(len(rest) == 2, "a power has a base and an exponent")
            return self.power(rest[0], rest[1], env)
        if op in ("d", "flip"):
            need(len(rest) == 2, f"{op} takes a name and a formula")
            element = self.scalar(rest[1], env)
            self.used.add(text(rest[0]))
            need(op == "d" or rest[0] in self.ring.radicands, f"{rest[0]} is no root")
            return self.partial(element, rest[0]) if op == "d" else element.flipped(rest[0])
        if op == "/":
            need(len(rest) == 2, "a quotient has two parts")
            return times(self.value(rest[0], env), self.inverse(rest[1], env))
        values = [self.value(part, env) for part in rest]
        if op in ("+", "*") and len(values) > 1:
            first, *others = values
            for other in others:
                first = times(first, other) if op == "*" else plus(first, other)
            return first
        if op in ("vector", "diag"):
            need(all(isinstance(v, Element) for v in values), "a component is no number")
            return tuple(values)
        if op in ("dot", "cross"):
            need(len(values) == 2 and all(isinstance(v, tuple) and len(v) == 3 for v in values),
                 "two vectors are expected")  # fmt: skip
            (a1, a2, a3), (b1, b2, b3) = values
            if op == "dot":
                return a1 * b1 + a2 * b2 + a3 * b3
            return (a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1)
        need(len(values) == 1, f"{op} is not understood")
        return self.unary(op, values[0])

    def unary(self, op: Any, value: Value) -> Value:
        """The meaning of an operation on one value."""
        if isinstance(value, tuple):
            return tuple(self.unary(op, part) for part in value)
        if op == "-":
            return -value
        if op == "D":
            return value.along(self.rate)
        if op == "D/clock" and self.clock is not None:
            return value.along(self.rate) * self.clock.inverse()
        if op == "conj":
            return self.conjugate(value)
        if op == "Re":
            return (value + self.conjugate(value)) * self.ring.number(2).inverse()
        if op == "Im":
            self.used.add("i")
            need("i" in self.ring.radicands, "there is no imaginary unit")
            return (value - self.conjugate(value)) * (self.env["i"] + self.env["i"]).inverse()
        need(op == "sqrt", f"{op} is not understood")
        below = Element(self.ring, self.ring.below(value))
        for radicand, root in self.roots:
            if not total(radicand, self.ring.product(value.num, below.num), 1, -1):
                self.used.update(n for n, e in self.env.items() if e is root)
                return root * below.inverse()
        raise Rejected("a root is taken that is not declared")

    def inverse(self, tree: Any, env: Mapping[str, Value] | None) -> Element:
        """One over a formula, factor by factor."""
        if isinstance(tree, list) and len(tree) > 1 and tree[0] == "*":
            result = self.ring.number(1)
            for factor in tree[1:]:
                result = result * self.inverse(factor, env)
            return result
        if isinstance(tree, list) and len(tree) == 3 and tree[0] == "^" and type(tree[2]) is int:
            return self.inverse(tree[1], env) ** tree[2]
        return self.scalar(tree, env).inverse()

    def power(self, base: Any, exponent: Any, env: Mapping[str, Value] | None) -> Element:
        """A power; its exponent is an integer, or linear in declared symbols."""
        value, result = self.scalar(base, env), self.ring.number(1)
        for symbol, multiple in linear(exponent).items():
            if symbol:
                need((base, symbol) in self.powers, "a power is not declared")
                self.used.update((symbol, self.powers[base, symbol]))
                value = self.env[self.powers[base, symbol]]
            result = result * (value if symbol else self.scalar(base, env)) ** multiple
        return result
