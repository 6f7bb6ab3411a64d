"""Check certificates, with nothing but Python's standard library (docs/certificate.md).

Nothing that can be computed is taken from a file, and what is not understood is rejected.
Exit codes: 0 all files are certified, 5 one is rejected, 6 there is none.
"""

from __future__ import annotations

import hashlib
import json
import sys
from fractions import Fraction
from functools import partial, reduce
from itertools import combinations_with_replacement
from typing import Any

FORMAT, VERSION = "kowalevski-cas certificate", 1
WIDTH, DEGREE, WORK, SIZE = 16, 1000, 3_000_000, 1_000_000
MASK = (1 << WIDTH) - 1
SPACE = {"variables", "constants", "nonzero", "steps", "change", "field", "conjugates"}
FILE = {"format", "version", "claim", "statement", "spaces", "parts", "digest"}
Json = Any
Terms = dict[int, Fraction | int]
Elements = dict[str, "Element"]
Value = tuple["Element", ...]  # a number, or the components of a vector or of a diagonal matrix


class Rejected(Exception):
    """The certificate does not prove what it states."""


def need(condition: object, message: str, *about: object) -> None:
    """Reject the certificate unless the condition holds."""
    if not condition:
        raise Rejected(message, *about)


class Element:
    """A polynomial; a monomial is an integer, bits for each exponent below the total degree."""

    def __init__(self, space: Space, terms: Terms) -> None:
        self.space, self.terms = space, {m: c for m, c in terms.items() if c}

    def __add__(self, other: Element) -> Element:
        a, b = self.terms, other.terms
        return Element(self.space, {m: a.get(m, 0) + b.get(m, 0) for m in {**a, **b}})

    def __sub__(self, other: Element) -> Element:
        return self + Element(self.space, {m: -c for m, c in other.terms.items()})

    def __mul__(self, other: Element) -> Element:
        space, out = self.space, Terms()
        space.work += len(self.terms) * len(other.terms)
        need(space.work < WORK, "it takes too much work")
        for m, c in self.terms.items():
            for n, d in other.terms.items():
                out[m + n] = out.get(m + n, 0) + c * d
        need(max(out, default=0) >> space.top <= DEGREE, "a degree is too large")
        for name in reversed(space.roots):
            shift, square = space.at[name], 2 * space.unit[name]
            if high := [m for m in out if m >> shift & MASK > 1]:
                inner = Element(space, {m - square: out.pop(m) for m in high})
                out = (Element(space, out) + inner * space.roots[name]).terms
        return Element(space, out)

    def __pow__(self, exponent: int) -> Element:
        need(type(exponent) is int and 0 <= exponent <= 64, "an exponent is odd")
        return reduce(Element.__mul__, [self] * exponent, self.space.number(1))

    def __str__(self) -> str:
        at, terms = self.space.at.items(), self.terms.items()
        shown = ([str(c), *(f"{n}^{e}" for n, s in at if (e := m >> s & MASK))] for m, c in terms)
        return " + ".join(map(" ".join, shown)) or "0"

    def split(self, name: str) -> dict[int, Element]:
        """The coefficients of the powers of a name."""
        parts: dict[int, Terms] = {}
        for m, c in self.terms.items():
            e = m >> self.space.at[name] & MASK
            parts.setdefault(e, {})[m - e * self.space.unit[name]] = c
        return {e: Element(self.space, terms) for e, terms in parts.items()}

    def flipped(self, name: str) -> Element:
        """The element with the sign of one root changed."""
        odd = self.split(name).get(1, self.space.number(0)) * self.space.generator(name)
        return self - odd - odd

    def vanishes(self) -> bool:
        """Whether the element is zero wherever the divisors are not: times them, it is zero."""
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
                ratio = Element(space, {0: Fraction(divisor.terms[top]) / norm.terms[top]})
                if not (norm * ratio - divisor).terms:
                    return above * powers * ratio * (space.generator(name) if name else divisor)
        raise Rejected(f"division by {norm}, which may be zero", norm)

    def along(self, rates: Elements) -> Element:
        """The derivative; what has no rate is constant, or a root, or one over a divisor."""
        space, change = self.space, self.space.number(0)
        for name in space.at:
            for e in (parts := self.split(name)).keys() - {0}:
                own = space.generator(name)
                rates[name] = rates[name] if name in rates else space.rate(own, name, rates)
                change = change + space.number(e) * parts[e] * own ** (e - 1) * rates[name]
        return change

    def image(self, images: Elements, space: Space) -> Element:
        """The value when the names take values in a space."""
        value, at = space.number(0), self.space.at.items()
        for m, c in self.terms.items():
            factors = (images[name] ** e for name, shift in at if (e := m >> shift & MASK))
            value = value + reduce(Element.__mul__, factors, Element(space, {0: c}))
        return value


class Space:
    """Names with relations and definitions, a vector field, and a conjugation."""

    def __init__(self, spaces: list[Space], data: Json) -> None:
        need(data.keys() <= SPACE, "a key of a space is not understood")
        self.variables, self.nonzero = data["variables"], data.get("nonzero", [])
        plain, steps = [*self.variables, *data.get("constants", [])], data.get("steps", [])
        divided = [f"1/{k}" for k in range(len(self.nonzero))]
        names = [*plain, *divided, *(name for kind, name, *_ in steps if kind == "root")]
        need(len(set(names)) == len(names), "a name is given twice")
        self.names = [name for name in names if name not in divided]
        self.at = {name: WIDTH * k for k, name in enumerate(names)}
        self.top, self.work, self.old = WIDTH * len(names), 0, list[Element]()
        self.unit = {name: (1 << shift) + (1 << self.top) for name, shift in self.at.items()}
        self.roots, self.divisors, self.rates, self.bar = (Elements() for _ in range(4))
        self.env: dict[str, Value] = {n: (self.generator(n),) for n in plain}
        for name, tree in zip(divided, self.nonzero, strict=True):
            self.divisors[name] = self.scalar(tree)
            need(self.divisors[name].terms.keys() - {0}, "a number is assumed to be non-zero")
        for kind, name, tree in steps:
            if kind == "where":
                rests = self.differences([[name, tree]])
                need(all(rest.vanishes() for rest in rests), "a relation does not hold")
                continue
            need(name not in self.env and kind in ("let", "root"), f"{name} is defined twice")
            self.env[name] = self.value(tree) if kind == "let" else (self.generator(name),)
            if kind == "root":
                self.roots[name] = self.scalar(tree)
        rates = self.rates = self.changed(spaces, **data["change"]) if "change" in data else {}
        for names, factor, right in data.get("field", []):
            for n, below, above in zip(names, self.value(factor), self.value(right), strict=True):
                need(n not in rates, "a variable moves twice")
                rates[n] = above * below.inverse()
        self.rates = {name: rate for name, rate in rates.items() if name in self.at}
        known = {*self.variables, *self.roots, *(self.env.keys() - self.at.keys())}
        need(not rates or set(self.variables) <= rates.keys() <= known, "a constant moves")
        for name, rate in rates.items():
            own, square = self.scalar(name), self.roots.get(name, self.number(0))
            rest = own * rate + own * rate - square.along(self.rates)
            need(name not in self.roots or rest.vanishes(), f"{name} does not move with its square")
            need((own.along(self.rates) - rate).vanishes(), f"{name} moves otherwise")
        if "conjugates" in data:
            swap = {a: b for pair in data["conjugates"] for a, b in (pair, pair[::-1])}
            bar = {name: self.generator(swap.get(name, name)) for name in self.names}
            bar |= {"i": self.number(-1) * bar["i"]} if "i" in bar else {}
            self.bar = self.carried(bar, self)
            real = ((own - own.image(self.bar, self)).vanishes() for own in self.old)
            need(all(real), "an old variable is not real")

    def number(self, value: int) -> Element:
        """An integer."""
        return Element(self, {0: value})

    def generator(self, name: str) -> Element:
        """A name that stands for itself."""
        return Element(self, {self.unit[name]: 1})

    def rate(self, own: Element, name: str, rates: Elements) -> Element:
        """The derivative of a name that follows from those of others."""
        if name in self.divisors:
            return self.number(-1) * own * own * self.divisors[name].along(rates)
        if name in self.roots and not (change := self.roots[name].along(rates)).vanishes():
            if (parts := change.split(name)).keys() == {1}:
                return parts[1] * Element(self, {0: Fraction(1, 2)})
            return own * change * (self.roots[name] + self.roots[name]).inverse()
        return self.number(0)

    def changed(self, spaces: Json, old: Json, formulas: Json, time: Json) -> Elements:
        """The rates of new variables, by the chain rule; the inverse has to be one."""
        source = spaces[old]
        new = {name: source.scalar(tree) for name, tree in formulas}
        need(len(new) == len(formulas) == len(source.variables), "the change is not one to one")
        images = source.carried({name: self.scalar(name) for name in source.names}, self)
        back = ((e.image(images, self) - self.scalar(name)).vanishes() for name, e in new.items())
        need(all(back), "the inverse does not give the variables back")
        self.old = [images[name] for name in source.variables]
        scale = source.scalar(time).image(images, self)
        return {n: source.unary("D", e).image(images, self) * scale for n, e in new.items()}

    def carried(self, images: Elements, space: Space) -> Elements:
        """Images of the names in a space, with those of inverses; they obey the relations."""
        for name, divisor in self.divisors.items():
            images[name] = divisor.image(images, space).inverse()
        for name, square in self.roots.items():
            rest = images[name] * images[name] - square.image(images, space)
            need(rest.vanishes(), f"{name} does not keep its square")
        return images

    def scalar(self, tree: Json) -> Element:
        """The value of a formula that is no vector."""
        (value,) = self.value(tree)
        return value

    def value(self, tree: Json) -> Value:
        """The components of the value of a formula."""
        if type(tree) is str:
            need(tree in self.env, f"{tree} is not defined")
            return self.env[tree]
        if type(tree) is int:
            return (self.number(tree),)
        need(type(tree) is list and len(tree) > 1, "no formula")
        op, first, *rest = tree
        if op == "^":
            return (self.scalar(first).__pow__(*rest),)
        if op == "d":
            need(first in self.names and first not in self.roots, f"{first} is no variable")
            return (self.scalar(*rest).along({first: self.number(1)}),)
        values = [self.value(part) for part in tree[1:]]
        if op in ("vector", "diag"):
            return tuple(value for (value,) in values)
        if rest and op in ("+", "*", "/", "dot", "cross")[: 5 if len(rest) == 1 else 3]:
            return reduce(partial(self.binary, op), values)
        need(not rest, f"{op} is not understood")
        return tuple(self.unary(op, value) for value in values[0])

    def binary(self, op: str, a: Value, b: Value) -> Value:
        """The meaning of an operation on two values."""
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
        """The meaning of an operation on one number."""
        if op == "D":
            need(self.rates, "there is no vector field")
            return value.along(self.rates)
        if op == "sqrt":
            found = [n for n, square in self.roots.items() if (square - value).vanishes()]
            need(found, "a root is taken that is not declared")
            return self.generator(found[0])
        need(op in ("-", "conj"), f"{op} is not understood")
        return self.number(0) - value if op == "-" else value.image(self.bar, self)

    def differences(self, equations: Json) -> list[Element]:
        """Left minus right sides, component by component."""
        pairs = [zip(self.value(a), self.value(b), strict=True) for a, b in equations]
        return [left - right for pair in pairs for left, right in pair]

    def point(self, given: Json, roots: Json, values: Json) -> tuple[Elements, Space]:
        """An exact point where equations hold: its numbers, checked against all relations."""
        need(all(type(d) is int and d > 1 for d in roots), "a root of a point is not real")
        steps = [["root", "i", ["-", 1]], *(["root", f"{d}^(1/2)", d] for d in roots)]
        numbers = Space([], {"variables": [], "steps": steps, "conjugates": []})
        need(sorted(name for name, _ in values) == sorted(self.names), "a value is missing")
        images = self.carried({name: numbers.scalar(tree) for name, tree in values}, numbers)
        off = [d for d in self.differences(given) if d.image(images, numbers).terms]
        need(not off, "the point is not where it should be")
        for name in self.names if self.bar else ():
            bar = self.unary("conj", self.generator(name)).image(images, numbers)
            need(not (bar - numbers.unary("conj", images[name])).terms, f"{name} is not real there")
        return images, numbers

    def follows(self, equations: Json, given: Json = (), cofactors: Json = (), **more: Json) -> str:
        """Equations hold: always, or where given ones do, perhaps for one value of a root."""
        need(equations and more.keys() <= ({"point", "root"} if given else set()), "an odd part")
        targets, known = self.differences(equations), self.differences(given)
        root = more.get("root")
        if given:
            self.point(given, **more["point"])
        if root is not None:
            alone = root in self.roots and all(1 not in r.split(root) for r in self.roots.values())
            free = not any((g - g.flipped(root)).terms for g in known)
            need(alone and free, f"the sign of {root} is not free")
            targets = [a * b.flipped(root) for a, b in combinations_with_replacement(targets, 2)]
        for target, row in zip(targets, cofactors or [[]] * len(targets), strict=True):
            for tree, g in zip(row, known, strict=True):
                target = target - self.scalar(tree) * g
            need(target.vanishes(), "the two sides are not equal")
        choice = f", for one of the two values of {say(root)}" if root is not None else ""
        return say_all(equations) + (f" wherever {say_all(given)}" if given else "") + choice

    def rank(self, levels: Json, functions: Json, given: Json, point: Json, dimension: Json) -> str:
        """Differentials are independent at a point, so that a set has a dimension near it."""
        images, numbers = self.point(given, **point)
        chosen = [*map(self.scalar, [*levels, *functions]), *self.differences(given)]
        one, v = self.number(1), self.variables
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
        a, b = next(ab for ab in zip(*sides, strict=True) if (ab[0] - ab[1]).terms)
        need((a - b).inverse().terms, "the two sides may be equal")
        where = f"where {say_all([*given, *point['values']])}: {a} is not {b}"
        return f"it is false that {say_all([equation])} {where}"


def say(tree: Json) -> str:
    """A formula in plain letters."""
    if not isinstance(tree, list):
        return str(tree)
    op, *shown = tree[0], *map(say, tree[1:])
    if len(shown) > 1 and op in ("+", "-", "*", "/", "^"):
        return f"({f' {op} '.join(shown)})"
    return f"-{shown[0]}" if op == "-" else f"{op}({', '.join(shown)})"


def say_all(equations: Json) -> str:
    """Equations in plain letters."""
    return ", ".join(f"{say(left)} = {say(right)}" for left, right in equations)


def unique(pairs: list[tuple[str, Json]]) -> dict[str, Json] | None:
    """An object; nothing, if a key is given twice."""
    return dict(pairs) if len(dict(pairs)) == len(pairs) else None


def check(text: str) -> tuple[str, list[str]]:
    """The claim of a certificate, and what was proved, in words."""
    need(len(text) < SIZE, "it is too long")
    data = json.loads(text, object_pairs_hook=unique, parse_float=str, parse_constant=str)
    need(data and data.keys() == FILE and data["parts"], "a key is missing or unknown")
    need([data["format"], data["version"]] == [FORMAT, VERSION], "it has another format")
    canonical = json.dumps({**data, "digest": ""}, sort_keys=True)
    need(data["digest"] == hashlib.sha256(canonical.encode()).hexdigest(), "the digest is wrong")
    spaces: list[Space] = []
    for space in data["spaces"]:
        spaces.append(Space(spaces, space))
    kinds: Json = {"follows": Space.follows, "rank": Space.rank, "differ": Space.differ}
    said = []
    for part in data["parts"]:
        space = spaces[part.pop("space")]
        words = kinds[part.pop("shows")](space, **part)
        where = ", ".join(f"{say(tree)} != 0" for tree in space.nonzero)
        said.append(words + (f", for {where}" if where else ""))
    return str(data["claim"]), said


def main(paths: list[str]) -> int:
    """Check files; the last line says how many are certified."""
    claims: set[str] = set()
    for path in paths:
        try:
            with open(path, encoding="utf-8") as file:
                claim, said = check(file.read())
            need(f"/{path}".endswith(f"/{claim}.json"), f"it is about the claim {claim}")
            need(claim not in claims, "the claim was certified before")
            print("\n".join(f"{claim}: {words}" for words in said))
            claims.add(claim)
        except Exception as error:  # whatever goes wrong, nothing is certified
            print(f"REJECTED {path}: {error or type(error).__name__}")
    print(f"CERTIFIED {len(claims)} of {len(paths)}")
    return 6 if not paths else 0 if len(claims) == len(paths) else 5


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
