"""Check certificates (docs/certificate.md), with nothing but Python's standard library.

Exit codes: 0 all files are certified, 5 one is rejected, 6 there is none.
"""

from __future__ import annotations

import hashlib
import json
import re
import sys
from fractions import Fraction
from functools import partial, reduce
from itertools import combinations_with_replacement
from math import gcd
from typing import Any

FORMAT, VERSION = "kowalevski-cas certificate", 1
WIDTH, DEGREE, WORK, SIZE, LARGEST = 16, 1000, 5_000_000, 1_000_000, 10**2000
MASK = (1 << WIDTH) - 1
NAME = re.compile(r"[A-Za-z\\](?:[\w\\^*]|\{[!-z]*\})*", re.ASCII)
SPACE = ("constants", "nonzero", "steps", "field", "conjugates")
FILE = {"format", "version", "claim", "statement", "spaces", "parts", "notes", "digest"}
Json = Any
Terms = dict[int, int]
Elements = dict[str, "Element"]


class Rejected(Exception):
    """The certificate does not prove what it states."""


def need(condition: object, message: str, *about: object) -> None:
    """Reject the certificate unless the condition holds."""
    if not condition:
        raise Rejected(message, *about)


class Element:
    """A polynomial over an integer; a monomial is an integer: exponents, then the degree."""

    def __init__(self, space: Space, terms: Terms, below: int = 1) -> None:
        common = gcd(below, *terms.values()) if below > 1 else 1
        self.space, self.below = space, below // common
        self.terms = {m: c // common for m, c in terms.items() if c}
        Space.left -= len(terms)
        need(Space.left > 0, "it takes too much work")

    def __add__(self, other: Element) -> Element:
        (a, p), (b, q) = (self.terms, self.below), (other.terms, other.below)
        total = {m: q * a.get(m, 0) + p * b.get(m, 0) for m in {**a, **b}}
        return Element(self.space, total, p * q)

    def __sub__(self, other: Element) -> Element:
        return self + Element(self.space, {m: -c for m, c in other.terms.items()}, other.below)

    def __mul__(self, other: Element) -> Element:
        space, out, below = self.space, Terms(), self.below * other.below
        Space.left -= len(self.terms) * len(other.terms)
        need(Space.left > 0, "it takes too much work")
        for m, c in self.terms.items():
            for n, d in other.terms.items():
                out[m + n] = out.get(m + n, 0) + c * d
        size = max(map(abs, out.values()), default=0) + below
        need(size < LARGEST and max(out, default=0) >> space.top <= DEGREE, "it is too large")
        for name in reversed(space.roots):
            shift, square = space.at[name], 2 * space.unit[name]
            if high := [m for m in out if m >> shift & MASK > 1]:
                inner = Element(space, {m - square: out.pop(m) for m in high}, below)
                total = Element(space, out, below) + inner * space.roots[name]
                out, below = total.terms, total.below
        return Element(space, out, below)

    def __pow__(self, exponent: int) -> Element:
        need(type(exponent) is int and 0 <= exponent <= 64, "an exponent is odd")
        return reduce(Element.__mul__, [self] * exponent, self.space.number(1))

    def split(self, name: str) -> dict[int, Element]:
        parts: dict[int, Terms] = {}
        for m, c in self.terms.items():
            e = m >> self.space.at[name] & MASK
            parts.setdefault(e, {})[m - e * self.space.unit[name]] = c
        return {e: Element(self.space, terms, self.below) for e, terms in parts.items()}

    def flipped(self, name: str) -> Element:
        odd = self.split(name).get(1, self.space.number(0)) * self.space.generator(name)
        return self - odd - odd

    def vanishes(self) -> bool:
        return not self.cleared()[0].terms

    def cleared(self) -> tuple[Element, Element]:
        """The element times powers of the divisors that clear it of them, and these powers."""
        value, powers, zero = self, self.space.number(1), self.space.number(0)
        for name, divisor in self.space.divisors.items():
            top = max(parts := value.split(name), default=0)
            value = sum((p * divisor ** (top - e) for e, p in parts.items()), zero)
            powers = powers * divisor**top
        return value, powers

    def inverse(self) -> Element:
        """One over the element: its conjugates over its norm, a multiple of a divisor."""
        space, above, norm = self.space, self.space.number(1), self
        for name in reversed(space.roots):
            if 1 in norm.split(name):
                above, norm = above * norm.flipped(name), norm * norm.flipped(name)
        norm, powers = norm.cleared()
        top = max(norm.terms, default=0)
        for name, divisor in (("", space.number(1)), *space.divisors.items()):
            if top in norm.terms and top in divisor.terms:
                value = Fraction(divisor.terms[top], divisor.below) / norm.terms[top] * norm.below
                ratio = Element(space, {0: value.numerator}, value.denominator)
                if not (norm * ratio - divisor).terms:
                    return above * powers * ratio * (space.generator(name) if name else divisor)
        raise Rejected("it divides by what may be zero", norm)

    def along(self, rates: Elements) -> Element:
        """The derivative; what has no rate is constant, or a root, or one over a divisor."""
        space, change = self.space, self.space.number(0)
        for name, parts in [(name, self.split(name)) for name in space.at]:
            own, moves = space.generator(name), parts.keys() - {0} and name not in rates
            if moves and name in space.divisors:
                rates[name] = space.number(-1) * own * own * space.divisors[name].along(rates)
            elif moves:
                rates[name] = space.roots.get(name, space.number(0)).along(rates)
                if (odd := rates[name].split(name)).keys() == {1}:
                    rates[name] = odd[1] * Element(space, {0: 1}, 2)
                elif not rates[name].vanishes():
                    rates[name] = rates[name] * own * (own * own + own * own).inverse()
            for e in parts.keys() - {0}:
                change = change + space.number(e) * parts[e] * own ** (e - 1) * rates[name]
        return change

    def image(self, images: Elements, space: Space) -> Element:
        """The value when the names take values in a space."""
        value, at = space.number(0), self.space.at.items()
        for m, c in self.terms.items():
            factors = (images[name] ** e for name, shift in at if (e := m >> shift & MASK))
            value = value + reduce(Element.__mul__, factors, Element(space, {0: c}, self.below))
        return value


class Space:
    """Names with relations and definitions, a vector field, and a conjugation."""

    left = WORK

    def __init__(self, before: Json, variables: Json, change: Json = None, **data: Json) -> None:
        constants, self.nonzero, steps, field, pairs = (data.pop(k, []) for k in SPACE)
        self.variables, plain = variables, [*variables, *constants]
        need(not data, "a space is not understood")
        divided = [f"1/{k}" for k in range(len(self.nonzero))]
        self.names = plain + [name for kind, name, _ in steps if kind == "root"]
        names = [*plain, *divided, *self.names[len(plain) :]]
        need(len(set(names)) == len(names) < 100, "a name is given twice, or there are too many")
        known = {*plain, *(name for _, name, _ in steps)} - {*constants}
        need(all(map(NAME.fullmatch, [*known, *constants])), "a name is odd")
        self.at, self.top = {n: WIDTH * k for k, n in enumerate(names)}, WIDTH * len(names)
        self.unit = {name: (1 << shift) + (1 << self.top) for name, shift in self.at.items()}
        self.roots, self.divisors, self.rates = Elements(), Elements(), Elements()
        self.env: dict[str, tuple[Element, ...]] = {n: (self.generator(n),) for n in plain}
        swap = {a: b for pair in pairs for a, b in (pair, pair[::-1])}
        self.bar = {name: self.generator(swap.get(name, name)) for name in self.names}
        for name, tree in zip(divided, self.nonzero, strict=True):
            self.divisors[name] = self.scalar(tree)
            need(self.divisors[name].terms.keys() - {0}, "a number is assumed to be non-zero")
        for kind, name, tree in steps:
            need(name not in self.env and kind in ("let", "root"), f"{name} is defined twice")
            self.env[name] = self.value(tree) if kind == "let" else (self.generator(name),)
            if kind == "root":
                self.roots[name] = self.scalar(tree)
                self.bar[name] *= self.number(-1 if self.roots[name].terms == {0: -1} else 1)
        self.complex, self.old = bool(swap or self.roots), list[tuple[Element, Element]]()
        rates = Elements() if change is None else self.changed(before, **change)
        moved, self.rates = {*rates, *(n for names, *_ in field for n in names)}, rates
        for names, mass, force in field:
            for name, m, f in zip(names, self.value(mass), self.value(force), strict=True):
                need(name not in rates, "a variable moves twice")
                rates[name] = f * m.inverse()
        self.rates = {name: rate for name, rate in rates.items() if name in self.at}
        need(not rates or {*variables} <= moved <= known, "a constant moves, or not all else")
        for own, rate in [*((self.scalar(name), rates[name]) for name in moved), *self.old]:
            rest = own * rate + own * rate - (own * own).along(self.rates)
            same = (own.along(self.rates) - rate).vanishes()
            need(same and rest.vanishes(), "a name moves otherwise")

    def number(self, value: int) -> Element:
        return Element(self, {0: value})

    def generator(self, name: str) -> Element:
        return Element(self, {self.unit[name]: 1})

    def changed(self, spaces: Json, old: Json, formulas: Json, time: Json) -> Elements:
        """The rates of new variables, by the chain rule; the inverse has to be one."""
        source = spaces[old]
        new = {name: source.scalar(tree) for name, tree in formulas}
        need(len(new) == len(formulas) == len(source.variables), "the change is not one to one")
        images = source.carried({name: self.scalar(name) for name in source.names}, self)
        back = ((e.image(images, self) - self.scalar(name)).vanishes() for name, e in new.items())
        need(all(back), "the inverse does not give the variables back")
        bar, old = self.carried({**self.bar}, self), [images[name] for name in source.variables]
        need(all((e - e.image(bar, self)).vanishes() for e in old), "an old variable is not real")
        scale = source.scalar(time).image(images, self)
        known = {name: source.scalar(name) for name in source.names}
        moved = {n: source.unary("D", e).image(images, self) for n, e in {**known, **new}.items()}
        self.old = [(images[name], moved[name] * scale) for name in known]
        return {name: moved[name] * scale for name in new}

    def carried(self, images: Elements, space: Space) -> Elements:
        """Images of the names in a space, with those of inverses; they obey the relations."""
        for name, divisor in self.divisors.items():
            images[name] = divisor.image(images, space).inverse()
        for name, square in self.roots.items():
            rest = images[name] * images[name] - square.image(images, space)
            need(rest.vanishes(), f"{name} does not keep its square")
        return images

    def scalar(self, tree: Json) -> Element:
        (value,) = self.value(tree)
        return value

    def value(self, tree: Json) -> tuple[Element, ...]:
        if type(tree) is str:
            need(tree in self.env, f"{tree!a} is not defined")
            return self.env[tree]
        if type(tree) is int:
            return (self.number(tree),)
        need(type(tree) is list and len(tree) > 1, "no formula")
        op, first, *rest = tree
        if op == "^":
            return (self.scalar(first).__pow__(*rest),)
        if op == "d":
            need(first in self.names and first not in self.roots, f"{first!a} is no variable")
            return (self.scalar(*rest).along({first: self.number(1)}),)
        values = [self.value(part) for part in tree[1:]]
        if op in ("vector", "diag"):
            return tuple(value for (value,) in values)
        if rest and op in ("+", "*", "/", "dot", "cross")[: 5 if len(rest) == 1 else 3]:
            return reduce(partial(self.binary, op), values)
        need(not rest, f"{op!a} is not understood")
        return tuple(self.unary(op, value) for value in values[0])

    def binary(
        self, op: str, a: tuple[Element, ...], b: tuple[Element, ...]
    ) -> tuple[Element, ...]:
        if op == "+":
            return tuple(x + y for x, y in zip(a, b, strict=True))
        if op == "cross":
            (p, q, r), (x, y, z) = a, b
            return (q * z - r * y, r * x - p * z, p * y - q * x)
        need(op != "dot" or len(a) == len(b) > 1, "a scalar product is one of two vectors")
        b = tuple(divisor.inverse() for divisor in b) if op == "/" else b
        a, b = (a * len(b) if len(a) == 1 else a), (b * len(a) if len(b) == 1 else b)
        products = tuple(x * y for x, y in zip(a, b, strict=True))
        return (sum(products, self.number(0)),) if op == "dot" else products

    def unary(self, op: str, value: Element) -> Element:
        if op == "D":
            need(self.rates, "there is no vector field")
            return value.along(self.rates)
        if op == "sqrt":
            found = [n for n, square in self.roots.items() if (square - value).vanishes()]
            need(found, "a root is taken that is not declared")
            return self.generator(found[0])
        need(op in ("-", "conj"), f"{op!a} is not understood")
        bar = self.carried({**self.bar}, self) if op == "conj" else self.bar
        return value.image(bar, self) if op == "conj" else self.number(0) - value

    def differences(self, equations: Json) -> list[Element]:
        both = [zip(self.value(a), self.value(b), strict=True) for a, b in equations]
        return [left - right for sides in both for left, right in sides]

    def point(self, given: Json, roots: Json, values: Json) -> tuple[Elements, Space]:
        """An exact point where equations hold: its numbers, checked against all relations."""
        need(all(type(d) is int and d > 1 for d in roots), "a root of a point is not real")
        steps = [["root", "i", ["-", 1]], *(["root", f"\\sqrt{{{d}}}", d] for d in roots)]
        numbers = Space([], [], steps=steps)
        need(sorted(name for name, _ in values) == sorted(self.names), "a value is missing")
        images = self.carried({name: numbers.scalar(tree) for name, tree in values}, numbers)
        off = [d for d in self.differences(given) if d.image(images, numbers).terms]
        need(not off, "the point is not where it should be")
        for name in self.names:
            bar = self.bar[name].image(images, numbers)
            need(not (bar - numbers.unary("conj", images[name])).terms, f"{name} is not real there")
        return images, numbers

    def settle(self, goals: list[Element], known: list[Element], **proof: Json) -> None:
        """Goals vanish where known elements do: combined, or in all cases of a product."""
        product, cases, rows = (proof.pop(key, []) for key in ("product", "cases", "cofactors"))
        need(goals and not proof and not (product and self.complex), "an odd proof")
        groups, zero = [[*map(self.scalar, group)] for group in product], self.number(0)
        for group, case in zip(groups, cases, strict=True):
            self.settle(goals, known + group, **case)
        if groups:
            factors = (sum((t * t for t in g), zero) if g[1:] else g[0] for g in groups)
            goals = [reduce(Element.__mul__, factors)]
        for goal, row in zip(goals, rows or [[]] * len(goals), strict=True):
            for tree, element in zip(row, known, strict=True):
                goal = goal - self.scalar(tree) * element
            need(goal.vanishes(), "the two sides are not equal")

    def follows(self, equations: Json, given: Json = (), **proof: Json) -> str:
        """Equations hold: always, or where given ones do, perhaps for one value of a root."""
        goals, known = self.differences(equations), self.differences(given)
        root = proof.pop("root", None)
        if given:
            self.point(given, **proof.pop("point"))
        if root is not None:
            alone = root in self.roots and all(1 not in r.split(root) for r in self.roots.values())
            free = not any((g - g.flipped(root)).terms for g in known)
            need(alone and free, f"the sign of {root!a} is not free")
            goals = [a * b.flipped(root) for a, b in combinations_with_replacement(goals, 2)]
        self.settle(goals, known, **proof)
        choice = f", for one of the two values of {say(root)}" if root is not None else ""
        return say_all(equations) + (f" wherever {say_all(given)}" if given else "") + choice

    def rank(self, levels: Json, functions: Json, given: Json, point: Json, dimension: Json) -> str:
        """Differentials are independent at a point, so that a set has a dimension near it."""
        (images, numbers), one, v = self.point(given, **point), self.number(1), self.variables
        chosen = [*map(self.scalar, [*levels, *functions]), *self.differences(given)]
        rows = [[f.along({n: one}).image(images, numbers) for n in v] for f in chosen]
        while rows:
            row = rows.pop()
            k = next((k for k, entry in enumerate(row) if entry.terms), 0)
            over = row[k].inverse()
            rows = [[a - r[k] * over * b for a, b in zip(r, row, strict=True)] for r in rows]
        size = len(v) - len(chosen)
        need(dimension in (None, size), f"the dimension is {size}")
        shown = ", ".join(map(say, [*levels, *functions, *(["-", *sides] for sides in given)]))
        near = f"where {say_all(point['values'])} the differentials of {shown} are independent"
        return f"{near}, and their level through this point has dimension {size} near it"

    def differ(self, equation: Json, point: Json, given: Json = ()) -> str:
        """An equation fails at a point, perhaps one where given equations hold."""
        images, numbers = self.point(given, **point)
        sides = ([x.image(images, numbers) for x in self.value(side)] for side in equation)
        gap = next(a - b for a, b in zip(*sides, strict=True) if (a - b).terms)
        need(gap.inverse().terms, "the two sides may be equal")
        return f"it is false that {say_all([equation])} where {say_all([*given, *point['values']])}"


def say(tree: Json) -> str:
    """A formula in plain letters."""
    if not isinstance(tree, list):
        return str(tree)
    op, *shown = tree[0], *map(say, tree[1:])
    if len(shown) > 1 and op in ("+", "-", "*", "/", "^"):
        return f"({f' {op} '.join(shown)})"
    return f"(-{shown[0]})" if op == "-" else f"{op}({', '.join(shown)})"


def say_all(equations: Json) -> str:
    """Equations in plain letters."""
    return ", ".join(f"{say(left)} = {say(right)}" for left, right in equations)


def check(text: str) -> tuple[str, list[str]]:
    """The claim of a certificate, and what was proved, in words."""
    need(len(text) < SIZE, "it is too long")
    unique: Json = lambda p: dict(p) if len(dict(p)) == len(p) else None  # noqa: E731
    data = json.loads(text, object_pairs_hook=unique)
    need(data and data.keys() == FILE and data["parts"], "a key is missing, unknown or repeated")
    need(
        data["format"] == FORMAT and repr(data["version"]) == repr(VERSION), "it has another format"
    )
    need(re.fullmatch(r"[\w.-]+", data["claim"], re.ASCII), "the claim has an odd name")
    canonical = json.dumps({**data, "digest": ""}, sort_keys=True)
    need(data["digest"] == hashlib.sha256(canonical.encode()).hexdigest(), "the digest is wrong")
    spaces, said, Space.left = list[Space](), list[str](), WORK
    for space in data["spaces"]:
        spaces.append(Space(spaces, **space))
    kinds: Json = {"follows": Space.follows, "rank": Space.rank, "differ": Space.differ}
    for part in data["parts"]:
        space = spaces[part.pop("space")]
        words = kinds[part.pop("shows")](space, **part)
        where = ", ".join(f"{say(tree)} != 0" for tree in space.nonzero)
        said.append(words + (f", for {where}" if where else ""))
    return data["claim"], said + [f"argued in words, not checked: {n!a}" for n in data["notes"]]


def main(paths: list[str]) -> int:
    """Check files; the last line says how many are certified."""
    digests: set[str] = set()
    for path in paths:
        try:
            with open(path, encoding="utf-8") as file:
                claim, said = check(text := file.read(SIZE))
            need(f"/{path}".endswith(f"/{claim}.json"), f"it is about the claim {claim}")
            need((digest := json.loads(text)["digest"]) not in digests, "it was certified before")
            print(*(f"{claim}: {words}" for words in said), sep="\n")
            digests.add(digest)
        except Exception as error:  # whatever goes wrong, nothing is certified
            print(f"REJECTED {path!a}: {error or type(error).__name__}")
    print(f"CERTIFIED {len(digests)} of {len(paths)}")
    return 6 if not paths else 0 if len(digests) == len(paths) else 5


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
