"""Check certificates with nothing but Python's standard library.

    python -I -S checker.py CERTIFICATE.json ...

docs/certificate.md describes the format. Nothing that can be computed is taken
from a file: the checker evaluates the printed formulas, differentiates along the
vector field, carries the field through a change of variables and inverts
denominators, exactly. What it does not understand it rejects. It exits with 0 if
all files are certified, 5 if one is rejected, 6 if there is none.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Mapping
from itertools import combinations_with_replacement
from math import gcd
from typing import Any

FORMAT, VERSION = "kowalevski-cas certificate", 1
WIDTH, DEGREE, WORK, SIZE = 16, 1000, 3_000_000, 1_000_000
MASK = (1 << WIDTH) - 1
Value = Any  # an Element, or a tuple of them: a vector, or the diagonal of a matrix

TREE, PAIR = object(), (object, object)
SPACE = {
    "variables": [str], "constants?": [str], "powers?": [(str, str, str)], "nonzero?": [TREE],
    "steps?": [[TREE]], "field?": [([str], TREE, TREE)], "conjugates?": [(str, str)],
    "change?": {"from": int, "formulas": [(str, TREE)], "time": TREE},
}  # fmt: skip
POINT = {"roots": [int], "values": [(str, TREE)]}
EQUATIONS, GIVEN = [(TREE, TREE)], {"given": [(TREE, TREE)], "point": POINT}
PARTS: dict[str, dict[str, Any]] = {
    "equal": {"equations": EQUATIONS},
    "follows": {"equations": EQUATIONS, "cofactors": [[TREE]], "root?": str, **GIVEN},
    "invariant": {"functions": [TREE], "matrix": [[TREE]], "point": POINT},
    "equivalent": {"equation": (TREE, TREE), "to": (TREE, TREE), "factor": TREE},
    "rank": {"levels": [TREE], "functions": [TREE], "dimension?": int, **GIVEN},
    "differ": {"equation": (TREE, TREE), **GIVEN},
}


class Rejected(Exception):
    """The certificate does not prove what it states."""


class Undivided(Rejected):
    """A division by a polynomial that is not assumed to be non-zero."""

    def __init__(self, divisor: Element) -> None:
        super().__init__(f"division by {divisor}, which is not assumed to be non-zero")
        self.divisor = divisor


def need(condition: object, message: str) -> None:
    """Reject the certificate unless the condition holds."""
    if not condition:
        raise Rejected(message)


class Ring:
    """Polynomials in generators, among them square roots and inverses of polynomials.

    A monomial is one integer: a field of bits for each exponent and, on top, the
    total degree; bounding it keeps the fields apart.
    """

    def __init__(self, names: list[str]) -> None:
        need(len(set(names)) == len(names), "a name is given twice")
        self.at = {name: WIDTH * k for k, name in enumerate(names)}
        self.top, self.work = WIDTH * len(names), 0
        self.unit = {name: (1 << s) + (1 << self.top) for name, s in self.at.items()}
        self.roots: dict[str, Element] = {}
        self.inverses: dict[str, Element] = {}
        self.single: list[tuple[int, int, int]] = []
        self.powers: dict[str, tuple[Element, Element]] = {}
        self.used: set[str] = set()

    def number(self, value: int) -> Element:
        """An integer."""
        return Element(self, {0: value} if value else {})

    def generator(self, name: str) -> Element:
        """A generator."""
        return Element(self, {self.unit[name]: 1})

    def product(self, a: dict[int, int], b: dict[int, int]) -> dict[int, int]:
        """A product of polynomials: inverses are cancelled, squares of roots replaced."""
        self.work += len(a) * len(b)
        need(self.work < WORK, "it takes too much work")
        out: dict[int, int] = {}
        for m, c in a.items():
            for n, d in b.items():
                k = m + n
                for x, v, both in self.single:
                    if k >> v & MASK and k >> x & MASK:
                        k -= both * min(k >> v & MASK, k >> x & MASK)
                out[k] = out.get(k, 0) + c * d
        need(not out or max(out) >> self.top <= DEGREE, "a degree is too large")
        for name in reversed(self.roots):
            shift, square = self.at[name], 2 * self.unit[name]
            high = [m for m in out if m >> shift & MASK > 1]
            if high:
                inner = {m - square: out.pop(m) for m in high}
                root = self.roots[name]
                for m, c in self.product(inner, root.terms).items():
                    out[m] = out.get(m, 0) + c
        return {m: c for m, c in out.items() if c}

    def inverse(self, p: Element) -> Element:
        """One over a polynomial in the plain generators: a number, generators, and the rest."""
        need(p.terms, "division by zero")
        result, terms = Element(self, {0: p.q}), p.terms
        for name, s in self.at.items():
            least = min(m >> s & MASK for m in terms)
            terms = {m - least * self.unit[name]: c for m, c in terms.items()}
            result = result * self.listed(self.generator(name)) ** least if least else result
        size = gcd(*terms.values()) * (1 if terms[max(terms)] > 0 else -1)
        rest = Element(self, {m: c // size for m, c in terms.items()})
        result = result if rest.terms == {0: 1} else result * self.listed(rest)
        return result * Element(self, {0: 1 if size > 0 else -1}, abs(size))

    def listed(self, divisor: Element) -> Element:
        """The inverse of a polynomial that is assumed to be non-zero."""
        for name, known in self.inverses.items():
            if known.terms == divisor.terms:
                self.used.add(name)
                return self.generator(name)
        raise Undivided(divisor)


class Element:
    """A polynomial of a ring over a positive integer."""

    def __init__(self, ring: Ring, terms: dict[int, int], q: int = 1) -> None:
        common = gcd(q, *terms.values()) if q > 1 else 1
        self.ring, self.q = ring, q // common
        self.terms = terms if common == 1 else {m: c // common for m, c in terms.items()}

    def __add__(self, other: Element) -> Element:
        q = self.q * other.q // gcd(self.q, other.q)
        out = {m: c * (q // self.q) for m, c in self.terms.items()}
        for m, c in other.terms.items():
            out[m] = out.get(m, 0) + c * (q // other.q)
        return Element(self.ring, {m: c for m, c in out.items() if c}, q)

    def __neg__(self) -> Element:
        return Element(self.ring, {m: -c for m, c in self.terms.items()}, self.q)

    def __sub__(self, other: Element) -> Element:
        return self + -other

    def __mul__(self, other: Element) -> Element:
        return Element(self.ring, self.ring.product(self.terms, other.terms), self.q * other.q)

    def __pow__(self, exponent: int) -> Element:
        need(abs(exponent) <= 64, "an exponent is too large")
        result, base = self.ring.number(1), self if exponent >= 0 else self.inverse()
        for _ in range(abs(exponent)):
            result = result * base
        return result

    def __str__(self) -> str:
        terms = []
        for m, c in sorted(self.terms.items(), reverse=True):
            powers = [(say(n), m >> s & MASK) for n, s in self.ring.at.items()]
            shown = "".join(n if e == 1 else f"{n}^{e}" for n, e in powers if e)
            terms.append(shown if shown and c == 1 else f"{c}{' ' if shown else ''}{shown}")
        shown = " + ".join(terms).replace("+ -", "- ") or "0"
        return shown if self.q == 1 else f"{shown if len(terms) < 2 else f'({shown})'}/{self.q}"

    def split(self, name: str) -> dict[int, Element]:
        """The coefficients of the powers of a generator."""
        parts: dict[int, dict[int, int]] = {}
        for m, c in self.terms.items():
            e = m >> self.ring.at[name] & MASK
            parts.setdefault(e, {})[m - e * self.ring.unit[name]] = c
        return {e: Element(self.ring, terms, self.q) for e, terms in parts.items()}

    def cleared(self) -> tuple[Element, Element]:
        """The element times a factor that frees it of inverses, and this factor."""
        value, factor = self, self.ring.number(1)
        for name, divisor in self.ring.inverses.items():
            parts = value.split(name)
            if most := max(parts, default=0):
                value = sum((p * divisor ** (most - e) for e, p in parts.items()), self.ring.number(0))
                factor = factor * divisor**most
        return value, factor

    def vanishes(self) -> bool:
        """Whether the element is zero, where the divisors are not."""
        return not self.terms or not self.cleared()[0].terms

    def flipped(self, name: str) -> Element:
        """The element with the sign of one root changed."""
        s = self.ring.at[name]
        terms = {m: -c if m >> s & 1 else c for m, c in self.terms.items()}
        return Element(self.ring, terms, self.q)

    def inverse(self) -> Element:
        """One over the element: its conjugates over its norm, which is free of roots."""
        norm, above = self.cleared()
        for name in reversed(self.ring.roots):
            if any(norm.split(name).keys()):
                other = norm.flipped(name)
                norm, factor = (norm * other).cleared()
                above = above * other * factor
        return above * self.ring.inverse(norm)

    def along(self, rates: dict[str, Element]) -> Element:
        """The derivative, given the derivatives of generators; the others follow."""
        ring, change = self.ring, self.ring.number(0)
        for name, s in ring.at.items():
            unit = ring.unit[name]
            part = {m - unit: c * (m >> s & MASK) for m, c in self.terms.items() if m >> s & MASK}
            if part:
                change = change + Element(ring, part, self.q) * self.rate(name, rates)
        return change

    def rate(self, name: str, rates: dict[str, Element]) -> Element:
        """The derivative of a generator; a plain one that is not named is constant."""
        ring, own = self.ring, self.ring.generator(name)
        if name not in rates:
            rates[name] = ring.number(0)
            if name in ring.inverses:
                rates[name] = -own * own * ring.inverses[name].along(rates)
            if name in ring.powers:
                base, exponent = ring.powers[name]
                change = base.along(rates)
                if not change.vanishes():
                    rates[name] = exponent * own * change * base.inverse()
        return rates[name]

    def image(self, images: Mapping[str, Element], ring: Ring) -> Element:
        """The value when the generators take values in a ring."""
        value, powers = ring.number(0), dict[tuple[str, int], Element]()
        for m, c in self.terms.items():
            term = Element(ring, {0: c}, self.q)
            for name, s in self.ring.at.items():
                if e := m >> s & MASK:
                    if (name, e) not in powers:
                        need(name in images, f"{name} has no value")
                        powers[name, e] = images[name] ** e
                    term = term * powers[name, e]
            value = value + term
        return value


class Space:
    """Generators with relations, definitions, a vector field, and a conjugation."""

    def __init__(self, data: dict[str, Any], spaces: list[Space]) -> None:
        steps, powers = data.get("steps", []), data.get("powers", [])
        for step in steps:
            need(len(step) > 2 and step[0] in STEPS and fits(step[1], str), "a step is odd")
        self.variables, self.nonzero = data["variables"], data.get("nonzero", [])
        plain = [*self.variables, *data.get("constants", []), *(n for n, _, _ in powers)]
        divided = [f"1/{k}" for k in range(len(self.nonzero))]
        ring = self.ring = Ring([*plain, *(s[1] for s in steps if s[0] == "root"), *divided])
        self.env: dict[str, Value] = {name: ring.generator(name) for name in plain}
        self.powers = {(base, exponent): name for name, base, exponent in powers}
        self.rates: dict[str, Element] | None = None
        self.bar: dict[str, Element] | None = None
        self.real: list[Element] = []
        self.used: set[str] = set()
        for name, tree in zip(divided, self.nonzero, strict=True):
            ring.assume(name, self.scalar(tree))
        self.used.clear()
        for step in steps:
            self.step(*step)
        for (base, exponent), name in self.powers.items():
            ring.powers[name] = (self.scalar(base), self.scalar(exponent))
        need(not {"field", "change"} <= data.keys(), "there are two fields")
        if "field" in data:
            self.move(self.printed(data["field"]))
        if "change" in data:
            self.move(self.changed(spaces, **data["change"]))
        if "conjugates" in data:
            self.conjugation(data["conjugates"])

    def step(self, kind: str, name: str, tree: Any, *sides: Any) -> None:
        """A definition; or a root, perhaps with the printed equation that it obeys."""
        need(name not in self.env and len(sides) in STEPS[kind], f"the step for {name} is odd")
        if kind == "let":
            self.env[name] = self.value(tree)
            return
        square, self.env[name] = self.scalar(tree), self.ring.generator(name)
        need(square.terms, f"the square of {name} is zero")
        self.ring.roots[name] = square
        self.ring.powers[name] = (square, Element(self.ring, {0: 1}, 2))
        if sides:
            need(self.equal(*sides), f"the equation for the square of {name} does not hold")

    def printed(self, equations: list[Any]) -> dict[str, Element]:
        """The field by printed equations: a factor times derivatives, and the right side."""
        rates: dict[str, Element] = {}
        for names, factor, right in equations:
            below, above = components(self.value(factor)), components(self.value(right))
            need(len(names) == len(below) == len(above), "an equation of motion has a gap")
            for name, divisor, rate in zip(names, below, above, strict=True):
                need(name not in rates, f"{name} moves twice")
                rates[name] = rate * divisor.inverse()
        return rates

    def changed(self, spaces: list[Space], **change: Any) -> dict[str, Element]:
        """The field of an earlier space, through a change of variables and its inverse."""
        need(0 <= change["from"] < len(spaces), "there is no such space")
        old = spaces[change["from"]]
        need(old.rates is not None and not any(old.pairs), "there is no field to be changed")
        new = {name: old.scalar(tree) for name, tree in change["formulas"]}
        need(len(new) == len(change["formulas"]), "a variable is changed twice")
        given = [n for n in old.ring.at if n not in old.ring.inverses]
        images = old.ring.carried({n: self.scalar(n) for n in given}, self.ring)
        for name, element in new.items():
            back = element.image(images, self.ring) - self.scalar(name)
            need(back.vanishes(), f"the inverse does not give {name} back")
        self.real = [images[n] for n in old.variables]
        old.used.add("its field")
        time = old.scalar(change["time"]).image(images, self.ring).inverse()
        speeds = {name: element.along(old.rates or {}) for name, element in new.items()}
        return {name: speed.image(images, self.ring) * time for name, speed in speeds.items()}

    def move(self, rates: dict[str, Element]) -> None:
        """Take a field; it has to move every variable, and to preserve the relations."""
        need(set(self.variables) <= set(rates), "a variable has no equation of motion")
        self.rates = {name: rate for name, rate in rates.items() if name in self.ring.at}
        self.used.update(rates)
        for name, rate in rates.items():
            own = self.scalar(name)
            if name in self.ring.roots:
                rest = own * rate + own * rate - self.ring.roots[name].along(self.rates)
                need(rest.vanishes(), f"{name} does not move with its square")
            elif name not in self.variables:
                need(name not in self.ring.at, f"the constant {name} moves")
                need((own.along(self.rates) - rate).vanishes(), f"{name} moves otherwise")

    def conjugation(self, pairs: list[Any]) -> None:
        """Swap pairs, turn i into -i; the old variables of a change have to stay real."""
        swap = {a: b for pair in pairs for a, b in (pair, pair[::-1])}
        need(len(swap) == 2 * len(pairs) and swap.keys() <= self.ring.at.keys(), "a pair is odd")
        names = [n for n in self.ring.at if n not in self.ring.inverses]
        bar = {n: self.ring.generator(swap.get(n, n)) for n in names}
        bar |= {"i": -bar["i"]} if "i" in bar else {}
        self.bar = self.ring.carried(bar, self.ring)
        for own in self.real:
            need((self.conjugate(own) - own).vanishes(), "an old variable is not real")
        self.used.discard("its conjugation")

    def conjugate(self, element: Element) -> Element:
        """The complex conjugate."""
        need(self.bar is not None, "there is no conjugation")
        self.used.add("its conjugation")
        return element.image(self.bar or {}, self.ring)

    def unused(self) -> list[str]:
        """What nothing in the certificate needs."""
        wanted = {*self.env, *self.ring.inverses}
        wanted |= {"its field"} if self.rates is not None else set()
        wanted |= {"its conjugation"} if self.bar is not None else set()
        return sorted(wanted - self.used - self.ring.used)

    # -- the meaning of formulas ---------------------------------------------

    def scalar(self, tree: Any) -> Element:
        """The value of a formula that is no vector."""
        value = self.value(tree)
        need(isinstance(value, Element), "a vector stands where a number is expected")
        return value  # type: ignore[no-any-return]

    def value(self, tree: Any) -> Value:
        """The value of a formula."""
        if isinstance(tree, str):
            need(tree in self.env, f"{tree} is not defined")
            self.used.add(tree)
            return self.env[tree]
        if fits(tree, int):
            return self.ring.number(tree)
        need(isinstance(tree, list) and len(tree) > 1 and isinstance(tree[0], str), "no formula")
        op, first, *rest = tree
        if op in ("d", "flip") and len(rest) == 1 and isinstance(first, str):
            return self.by_name(op, first, self.scalar(rest[0]))
        if op == "^" and len(rest) == 1:
            return self.power(first, rest[0])
        if op == "/" and len(rest) == 1:
            return times(self.value(first), self.inverse(rest[0]))
        if op == "D" and len(rest) == 1:
            return times(self.value(["D", first]), self.inverse(rest[0]))
        if op == "Re" and not rest:
            return self.value(["/", ["+", first, ["conj", first]], 2])
        if op == "Im" and not rest:
            return self.value(["/", ["+", first, ["-", ["conj", first]]], ["*", 2, "i"]])
        values = [self.value(part) for part in (first, *rest)]
        if op in ("+", "*") and rest:
            total, *others = values
            for other in others:
                total = times(total, other) if op == "*" else plus(total, other)
            return total
        if op in ("vector", "diag"):
            need(all(isinstance(v, Element) for v in values), "a component is no number")
            return tuple(values)
        if op in ("dot", "cross"):
            need([isinstance(v, tuple) and len(v) for v in values] == [3, 3], "no two vectors")
            (a, b, c), (x, y, z) = values
            return a * x + b * y + c * z if op == "dot" else (b * z - c * y, c * x - a * z, a * y - b * x)
        need(not rest, f"{op} is not understood")
        results = tuple(self.unary(op, part) for part in components(values[0]))
        return results if isinstance(values[0], tuple) else results[0]

    def unary(self, op: str, value: Element) -> Element:
        """The meaning of an operation on one number."""
        if op == "-":
            return -value
        if op == "conj":
            return self.conjugate(value)
        if op == "D":
            need(self.rates is not None, "there is no field")
            self.used.add("its field")
            return value.along(self.rates or {})
        need(op == "sqrt", f"{op} is not understood")
        for name, square in self.ring.roots.items():
            if (square - value).vanishes():
                return self.scalar(name)
        raise Rejected("a root is taken that is not declared")

    def by_name(self, op: str, name: str, value: Element) -> Element:
        """A partial derivative, or the sign of a root changed."""
        self.used.add(name)
        need(name in self.env and name in self.ring.at, f"{name} is no generator")
        need((name in self.ring.roots) == (op == "flip"), f"{op} cannot be taken by {name}")
        return value.flipped(name) if op == "flip" else value.along({name: self.ring.number(1)})

    def inverse(self, tree: Any) -> Element:
        """One over a formula, factor by factor."""
        if isinstance(tree, list) and tree[:1] == ["*"] and len(tree) > 2:
            result = self.ring.number(1)
            for factor in tree[1:]:
                result = result * self.inverse(factor)
            return result
        if isinstance(tree, list) and tree[:1] == ["^"] and len(tree) == 3 and fits(tree[2], int):
            return self.inverse(tree[1]) ** tree[2]
        return self.scalar(tree).inverse()

    def power(self, base: Any, exponent: Any) -> Element:
        """A power; its exponent is an integer, or linear in declared symbols."""
        result = self.ring.number(1)
        for symbol, multiple in linear(exponent).items():
            if symbol:
                need((base, symbol) in self.powers, "a power is not declared")
                self.used.update((symbol, base))
            value = self.scalar(self.powers[base, symbol] if symbol else base)
            result = result * value**multiple
        return result

    def differences(self, left: Any, right: Any) -> list[Element]:
        """Left minus right side, component by component."""
        a, b = self.value(left), self.value(right)
        return list(components(plus(a, self.unary("-", b) if isinstance(b, Element) else tuple(-x for x in b))))

    def equal(self, left: Any, right: Any) -> bool:
        """Whether both sides are equal wherever the space has its points."""
        return all(d.vanishes() for d in self.differences(left, right))

    def point(self, data: Any) -> tuple[dict[str, Element], Ring]:
        """An exact point: the values of all generators, checked against all relations."""
        steps = [["root", "i", ["-", 1]], *(["root", f"{d}^(1/2)", d] for d in data["roots"])]
        need(all(d > 1 for d in data["roots"]), "a root of a point is not positive")
        numbers = Space({"variables": [], "steps": steps, "conjugates": []}, [])
        values = {name: numbers.scalar(tree) for name, tree in data["values"]}
        names = [n for n in self.ring.at if n not in self.ring.inverses]
        need(sorted(n for n, _ in data["values"]) == sorted(names), "a value is missing or extra")
        need(len(set(numbers.unused()) - {"i", "its conjugation"}) == 0, "a root is not needed")
        images = self.ring.carried(values, numbers.ring)
        for name in names if self.bar is not None else ():
            bar = self.conjugate(self.ring.generator(name)).image(images, numbers.ring)
            need((bar - numbers.conjugate(values[name])).vanishes(), f"{name} is not real there")
        return images, numbers.ring
