"""Whether the evidence of a certificate shows its problem, by an arithmetic that is not the checker's.

Formulas are differentiated and conjugated as trees, by structural recursion, and
evaluated with python-flint at random points modulo a prime of 61 bits. A statement that
is false holds at such a point with a probability of about 1e-16.
"""

from __future__ import annotations

import json
import random
from copy import copy
from fractions import Fraction
from functools import partial, reduce
from itertools import combinations, product
from math import prod
from operator import mul

from flint import nmod, nmod_mat
from flint.utils.flint_exceptions import DomainError

from .series import solution

PRIME = 2305843009213423681  # 1 modulo 8, 3, 5, 7, 11, 13: small numbers have square roots
POINTS = 2


class Untrue(Exception):
    pass


def require(condition, what):
    if not condition:
        raise Untrue(what)


def number(value):
    return nmod(value % PRIME, PRIME)


def square_root(value):
    try:
        return nmod(int(value), PRIME).sqrt()
    except (ValueError, ZeroDivisionError, DomainError):
        return None


def part(tree, k):
    """The component k of a tree, as the tree of a number (or None for a number itself)."""
    if not isinstance(tree, list):
        return tree
    op, *rest = tree
    if op in ("vector", "diag"):
        return rest[k]
    if op == "cross":
        (a, b), (i, j) = rest, [(1, 2), (2, 0), (0, 1)][k]
        return ["+", ["*", part(a, i), part(b, j)], ["-", ["*", part(a, j), part(b, i)]]]
    if op in ("dot", "d", "^"):
        return tree
    return [op, *(part(x, k) for x in rest)]


def combine(op, first, other):
    require(op in ("+", "*", "/"), op)
    require(op != "/" or other != 0, "division by zero")
    return first + other if op == "+" else first * other if op == "*" else first / other


class Names:
    """A space: its trees with all definitions put in, its rates as trees."""

    def __init__(self, data, spaces):
        self.data = data
        self.plain = [*data["variables"], *data.get("constants", [])]
        self.lets, self.radicands = {}, {}
        self.swap = {a: b for pair in data.get("conjugates", []) for a, b in (pair, pair[::-1])}
        squares = {step[1]: step[2] for step in data.get("steps", []) if step[0] == "root"}
        self.units = {name for name, tree in squares.items() if tree in (-1, ["-", 1])}
        self.powers, self.own = {}, {}
        for kind, name, tree, *more in data.get("steps", []):
            if kind == "let":
                self.lets[name] = self.open(tree)
            elif kind == "root":
                self.radicands[name] = self.open(tree)
            else:
                require(kind == "power" and more[0] in data["constants"], "a step")
                self.powers[name] = self.open(tree), more[0]
        self.rates = {}
        if "change" in data:
            change = data["change"]
            self.old = spaces[change["old"]]
            scale = self.old.open(change["time"])
            for name, tree in change["formulas"]:
                rate = self.old.along(self.old.open(tree))
                self.rates[name] = self.moved(["*", rate, scale])
        for names, factor, right in data.get("field", []):
            factor, right = self.open(factor), self.open(right)
            for k, name in enumerate(names):
                self.rates[name] = ["/", part(right, k), part(factor, k)]

    def open(self, tree):
        """A tree with definitions put in, and vectors kept as vectors."""
        if isinstance(tree, str):
            return self.lets.get(tree, tree)
        if not isinstance(tree, list):
            return tree
        op, *rest = tree
        if op == "d":
            return self.partial(self.open(rest[1]), rest[0])
        if op == "^":
            return ["^", self.open(rest[0]), rest[1]]
        rest = [self.open(x) for x in rest]
        if op == "dot":
            a, b = rest
            require(self.wide(a) and self.wide(b) and len(a) == len(b), "no vectors")
            return ["+", *(["*", part(a, k), part(b, k)] for k in range(len(a) - 1))]
        if op == "cross":
            return ["vector", *(part(["cross", *rest], k) for k in range(3))]
        if op in ("*", "/", "+", "-", "D", "conj") and any(self.wide(x) for x in rest):
            (size,) = {len(x) - 1 for x in rest if self.wide(x)}
            rows = ([part(x, k) if self.wide(x) else x for x in rest] for k in range(size))
            return ["vector", *(self.open([op, *row]) for row in rows)]
        if op == "D":
            return self.along(rest[0])
        if op == "conj":
            return self.bar(rest[0])
        return [op, *rest]

    @staticmethod
    def wide(tree):
        return isinstance(tree, list) and tree[0] in ("vector", "diag")

    def moved(self, tree):
        """A tree in the names of the old space, in those of this one."""
        if isinstance(tree, str):
            return self.lets.get(tree, tree)
        if not isinstance(tree, list):
            return tree
        if tree[0] == "^":
            return ["^", self.moved(tree[1]), tree[2]]
        return [tree[0], *(self.moved(x) for x in tree[1:])]

    def along(self, tree):
        return self.derivative(tree, lambda n: self.rates.get(n, None))

    def partial(self, tree, name):
        return self.derivative(tree, lambda n: 1 if n == name else None)

    def derivative(self, tree, rate):
        if isinstance(tree, str):
            known = rate(tree)
            if known is None and tree in self.powers:
                base, exponent = self.powers[tree]
                return ["/", ["*", exponent, tree, self.derivative(base, rate)], base]
            if known is None and tree in self.radicands:
                return ["/", self.derivative(self.radicands[tree], rate), ["*", 2, tree]]
            return 0 if known is None else known
        if not isinstance(tree, list):
            return 0
        op, *rest = tree
        if op in ("+", "-"):
            return [op, *(self.derivative(x, rate) for x in rest)]
        if op == "*":
            terms = [
                ["*", *rest[:k], d, *rest[k + 1 :]]
                for k, x in enumerate(rest)
                if (d := self.derivative(x, rate)) != 0
            ]
            return ["+", *terms] if terms else 0
        if op == "/":
            above, *below = rest
            first = ["/", self.derivative(above, rate), *below]
            others = [["-", ["/", ["*", tree, self.derivative(x, rate)], x]] for x in below]
            return ["+", first, *others]
        if op == "^":
            base, exponent = rest
            return (
                ["*", exponent, ["^", base, exponent - 1], self.derivative(base, rate)]
                if exponent
                else 0
            )
        if op == "sqrt":
            return ["/", self.derivative(rest[0], rate), ["*", 2, tree]]
        raise Untrue(f"no derivative of {op}")

    def bar(self, tree):
        if isinstance(tree, str):
            return ["-", tree] if tree in self.units else self.swap.get(tree, tree)
        if not isinstance(tree, list):
            return tree
        if tree[0] == "^":
            return ["^", self.bar(tree[1]), tree[2]]
        return [tree[0], *(self.bar(x) for x in tree[1:])]

    # -- values ------------------------------------------------------------------

    def random_values(self, generator):
        for _ in range(400):
            values = {name: number(generator.randrange(1, PRIME)) for name in self.plain}
            exponents = {name: generator.randrange(2, 9) for _, name in self.powers.values()}
            values |= {name: number(value) for name, value in exponents.items()}
            for name, (base, exponent) in self.powers.items():
                values[name] = self.value(base, values) ** exponents[exponent]
            for name, radicand in self.radicands.items():
                root = square_root(self.value(radicand, values))
                if root is None:
                    break
                values[name] = root if generator.random() < 0.5 else -root
            else:
                return values
        raise Untrue("no point was found")

    def value(self, tree, values):
        if isinstance(tree, str):
            require(tree in values, f"{tree} is unknown")
            return values[tree]
        if isinstance(tree, int) and not isinstance(tree, bool):
            return number(tree)
        require(isinstance(tree, list), "no tree")
        op, *rest = tree
        if op == "^":
            base = self.value(rest[0], values)
            return base ** rest[1] if rest[1] >= 0 else 1 / base ** -rest[1]
        if op == "sqrt":
            wanted = self.value(rest[0], values)
            for name, radicand in sorted(
                self.radicands.items(), key=lambda one: one[0][:5] != "\\sqrt"
            ):
                if self.value(radicand, values) == wanted:
                    return values[name]
            raise Untrue("a root is not declared")
        first, *others = (self.value(x, values) for x in rest)
        return -first if op == "-" else reduce(partial(combine, op), others, first)

    def components(self, tree, values):
        opened = self.open(tree)
        if self.wide(opened):
            return [self.value(x, values) for x in opened[1:]]
        return [self.value(opened, values)]

    def differences(self, equations, values):
        result = []
        for left, right in equations:
            a, b = self.components(left, values), self.components(right, values)
            require(len(a) == len(b), "vector and number")
            result += [x - y for x, y in zip(a, b, strict=True)]
        return result

    # -- the space itself --------------------------------------------------------

    def sound(self, values, conjugating):
        """Whether relations, field, change and, if need be, conjugation are what they have to be."""
        data = self.data
        for tree in data.get("nonzero", []):
            require(self.value(self.open(tree), values) != 0, "a divisor is zero")
        self.sound_field(values)
        if "change" in data:
            self.sound_change(values)
        for step in data.get("steps", []):
            if step[0] == "root" and len(step) == 4:
                require(not any(self.differences([step[3]], values)), "the printed equation")
        if conjugating:
            for name, radicand in self.radicands.items():
                bar = self.value(self.bar(name), values)
                require(bar * bar == self.value(self.bar(radicand), values), "conjugate")

    def sound_field(self, values):
        data = self.data
        for name, rate in self.rates.items():
            if name in self.radicands:
                change = self.value(self.along(self.radicands[name]), values)
                require(2 * values[name] * self.value(rate, values) == change, "relation")
            elif name in self.lets:
                other = self.value(self.along(self.lets[name]), values)
                require(self.value(rate, values) == other, "rate")
            else:
                require(name in data["variables"], "a constant moves")
        if self.rates:
            require(set(data["variables"]) <= set(self.rates), "a variable does not move")

    def sound_change(self, values):
        change = self.data["change"]
        require(len(change["formulas"]) == len(self.old.data["variables"]), "not one to one")
        for name, tree in change["formulas"]:
            there = self.value(self.moved(self.old.open(tree)), values)
            require(there == self.value(self.open(name), values), "inverse")
        for name, radicand in self.old.radicands.items():
            here = self.value(self.moved(name), values)
            require(here * here == self.value(self.moved(radicand), values), "old relation")
        scale = self.value(self.moved(self.old.open(change["time"])), values)
        require(scale != 0, "no time")
        for name in self.old.plain:
            rate = self.value(self.moved(self.old.along(name)), values) * scale
            require(self.value(self.along(self.open(name)), values) == rate, "old rate")
            bar = self.moved(self.old.bar(name))
            here = self.value(self.bar(self.open(name)), values)
            require(here == self.value(bar, values), "real")


def number_of(roots, tree, i):
    """The value of a formula of a point."""
    if isinstance(tree, int):
        return number(tree)
    if tree == "i":
        return i
    op, first, *rest = tree
    if op == "sqrt":
        require(first in roots, "a root of a point")
        return roots[first]
    value = partial(number_of, roots)
    if op == "^":
        return value(first, i) ** rest[0]
    if op in ("-", "conj"):
        return -value(first, i) if op == "-" else value(first, -i)
    return reduce(partial(combine, op), [value(x, i) for x in rest], value(first, i))


def point_values(names, point, more=()):
    """The values of a point modulo the prime; it may share the roots of more points."""
    roots = {d: square_root(number(d)) for one in (point, *more) for d in one["roots"]}
    require(all(d > 1 for d in roots), "a root of a point")
    if any(root is None for root in roots.values()):
        return None  # this prime cannot tell
    unit, value = square_root(number(-1)), partial(number_of, roots)
    values = {name: value(tree, unit) for name, tree in point["values"]}
    require(len(values) == len(point["values"]), "a value is given twice")
    whole = {*names.plain, *names.radicands, *names.powers}
    require(set(values) == whole, "a value is missing")
    for name, (base, _) in names.powers.items():
        require(values[name] == names.value(base, values) == 1, "a power at a point")
    for name, radicand in names.radicands.items():
        require(values[name] ** 2 == names.value(radicand, values), "off a relation")
    for tree in names.data.get("nonzero", []):
        require(names.value(names.open(tree), values) != 0, "a divisor is zero")
    bars = {name: value(tree, -unit) for name, tree in point["values"]}
    for name in values:
        require(names.value(names.bar(name), values) == bars[name], "not real")
    return values


# -- evidence --------------------------------------------------------------------------


def combined(names, values, target, row, known):
    """Whether a value is the combination of known ones that a row gives."""
    require(len(row) in (0, len(known)), "row")
    for tree, value in zip(row, known, strict=False):
        target = target - scalar(names, tree, values) * value
    require(target == 0, "the two sides differ")


def scalar(names, tree, values):
    (value,) = names.components(tree, values)
    return value


def is_not_negative(names, tree):
    """Whether nothing but sums, products and quotients of roots, even powers and numbers."""
    if isinstance(tree, list) and tree[0] in ("+", "*", "/"):
        return all(is_not_negative(names, part) for part in tree[1:])
    if isinstance(tree, list):
        return tree[0] == "^" and (tree[2] % 2 == 0 or is_not_negative(names, tree[1]))
    return tree >= 0 if isinstance(tree, int) else tree[:5] == "\\sqrt" and tree in names.radicands


def settled(names, values, targets, known, proof):
    """Whether the identities of a proof hold at a point in general position."""
    keys = {"product", "cofactors", "cases", "power", "point", "away", "equal"}
    require(proof.keys() <= keys, "proof")
    for sides in proof.get("equal", []):
        require(not (names.units or names.swap), "signs are of real numbers")
        require(all(is_not_negative(names, side) for side in sides), "a sign")
        left, right = (scalar(names, side, values) for side in sides)
        require(left**2 == right**2, "the squares differ")
        known = [*known, left - right]
    power = proof.get("power", 1)
    require(type(power) is int and power > 0, "power")
    if groups := proof.get("product"):
        squares = any(len(group) > 1 for group in groups)
        require(not squares or not (names.units or names.swap), "squares are for real numbers")
        require(len(groups) == len(proof["cases"]), "a case is missing")
        whole = number(1)
        for group, case in zip(groups, proof["cases"], strict=True):
            found = [scalar(names, tree, values) for tree in group]
            settled(names, values, targets, known + found, case)
            whole *= found[0] if len(found) == 1 else sum((x * x for x in found), number(0))
        targets = [whole]
    rows = proof["cofactors"] if "cofactors" in proof else [[]] * len(targets)
    require(len(rows) == len(targets), "rows")
    for target, row in zip(targets, rows, strict=True):
        combined(names, values, target**power, row, known)


def rational(tree):
    """The value of a formula of integers, with fractions."""
    if type(tree) is int:
        return Fraction(tree)
    op, *parts = tree
    first, *rest = map(rational, parts)
    if op == "-":
        return -first
    if op == "^":
        return first ** parts[1]
    for other in rest:
        first = {"+": first + other, "*": first * other}[op] if op != "/" else first / other
    return first


def squares(names, values, data):
    total = number(0)
    for tree, base in data:
        ratio, value = rational(tree), scalar(names, base, values)
        require(ratio > 0, "a square is taken away")
        require(names.value(names.bar(names.open(base)), values) == value, "not real")
        total += number(ratio.numerator) / number(ratio.denominator) * value * value
    return total


def eliminated(coefficients, x):
    """The value of a polynomial with the leading coefficient 1."""
    lower = (c * x**k for k, c in enumerate(coefficients))
    return sum(lower, x ** len(coefficients))


class Judge:
    """A space of a goal, in which bound names stand for values."""

    def __init__(self, names, goal, evidence, bound=()):
        self.names, self.goal, self.evidence = copy(names), goal, evidence
        self.names.lets = names.lets | {name: names.open(tree) for name, tree in bound}
        require(len(self.names.lets) == len(names.lets) + len(bound), "a bound name is not fresh")
        require(not {n for n, _ in bound} & {*names.plain, *names.radicands}, "not fresh")
        self.generator = random.Random(7)

    def at(self, *, given=True, point=None, more=()):
        """The values at the point of the evidence, or None if the prime cannot tell."""
        point = point_values(self.names, point or self.evidence["point"], more)
        if point is not None:
            for tree in self.evidence.get("away", []):
                require(scalar(self.names, tree, point) != 0, "a condition fails")
            if given:
                zero = self.names.differences(self.goal["given"], point)
                require(all(d == 0 for d in zero), "off the set")
        return point

    def general(self):
        return [self.names.random_values(self.generator) for _ in range(POINTS)]

    def follows(self):
        require(all(self.goal["conclusions"]), "nothing")
        require("point" in self.evidence, "no point")
        self.at(given=bool(self.goal["conclusions"]))
        require(self.goal["conclusions"] or "away" not in self.evidence, "conditions of nothing")
        for values in self.general():
            known = self.names.differences(self.goal["given"], values)
            parts = [self.names.differences(one, values) for one in self.goal["conclusions"]]
            targets = [prod(choice, start=number(1)) for choice in product(*parts)]
            settled(self.names, values, targets, known, self.evidence)

    def fails(self):
        require(self.goal["conclusions"] or self.goal["given"], "nothing")
        require(all(self.goal["conclusions"]), "nothing")
        if (point := self.at()) is not None:
            for one in self.goal["conclusions"]:
                require(any(d != 0 for d in self.names.differences(one, point)), "equal")

    def matrix(self, values):
        trees = [*self.goal["functions"], *(["+", a, ["-", b]] for a, b in self.goal["given"])]
        variables = self.names.data["variables"]
        opened = [self.names.open(tree) for tree in trees]
        flat = [
            part(t, k) for t in opened for k in (range(len(t) - 1) if self.names.wide(t) else [0])
        ]
        return [
            [self.names.value(self.names.partial(t, v), values) for v in variables] for t in flat
        ]

    def independent(self):
        point = self.at()
        if point is None:
            return self.goal["rank"]
        rows = self.matrix(point)
        entries = [int(x) for row in rows for x in row]
        matrix = nmod_mat(len(rows), len(rows[0]), entries, PRIME)
        require(matrix.rank() == len(rows), "rank")
        return len(rows)

    def rank(self):
        require(self.independent() == self.goal["rank"], "rank")

    def no_rank(self):
        if "minors" not in self.evidence:
            return require(self.independent() != self.goal["rank"], "rank")
        for values in self.general():
            rows = self.matrix(values)
            known = self.names.differences(self.goal["given"], values)
            size, found = len(rows), []
            for columns in combinations(range(len(rows[0])), size):
                entries = [int(row[c]) for row in rows for c in columns]
                found.append(nmod_mat(size, size, entries, PRIME).det())
            require(len(found) == len(self.evidence["minors"]), "minors")
            for minor, row in zip(found, self.evidence["minors"], strict=True):
                combined(self.names, values, minor, row, known)

    def counted(self):
        names, data, goal = self.names, self.evidence, self.goal
        self.goal = {**goal, "given": goal["equations"]}
        self.at()
        self.goal, size, root = goal, len(data["eliminant"]), data["root"]
        require(root not in {*names.plain, *names.lets, *names.radicands}, "not fresh")
        require([row[0] for row in data["solved"]] == goal["names"], "solved")
        own = {*goal["names"], *names.data.get("constants", [])}
        require(not data["factors"] or size, "nothing")
        for values in self.general():
            moved = {n: v for n, v in values.items() if n in own}
            fixed = {n: v for n, v in moved.items() if n not in goal["names"]}
            coefficients = [scalar(names, c, fixed) for c in data["eliminant"]]
            known = names.differences(goal["equations"], moved)
            form = scalar(names, data["form"], moved)
            targets = [eliminated(coefficients, form)]
            for name, above, below in data["solved"]:
                value = scalar(names, above, {**fixed, root: form})
                targets.append(scalar(names, below, fixed) * values[name] - value)
            for target, row in zip(targets, data["cofactors"], strict=True):
                combined(names, values, target, row, known)
            s = number(self.generator.randrange(PRIME))
            there = {**fixed, root: s}
            put = {
                n: scalar(names, a, there) / scalar(names, b, fixed) for n, a, b in data["solved"]
            }
            goals = names.differences(goal["equations"], {**fixed, **put})
            goals.append(scalar(names, data["form"], {**fixed, **put}) - s)
            for target, tree in zip(goals, data["quotients"], strict=True):
                require(
                    target == scalar(names, tree, there) * eliminated(coefficients, s), "quotient"
                )
            self.hermite(coefficients, fixed, values, known)
        return size

    def hermite(self, coefficients, fixed, values, known):
        size, factors = len(coefficients), []
        for entry in self.evidence["factors"]:
            factors.append(scalar(self.names, entry["factor"], fixed))
            rest = factors[-1] - squares(self.names, values, entry["squares"])
            combined(self.names, values, rest, entry.get("cofactors", []), known)
        companion = [[int(r == c + 1) for c in range(size)] for r in range(size)]
        for r in range(size):
            companion[r][size - 1] = int(-coefficients[r])
        step = nmod_mat(size, size, [x for row in companion for x in row], PRIME)
        power = nmod_mat(size, size, [int(r == c) for r in range(size) for c in range(size)], PRIME)
        sums = []
        for _ in range(2 * size):
            sums.append(sum((power[k, k] for k in range(size)), number(0)))
            power = power * step
        require(len(self.evidence["minors"]) == size, "minors")
        for k, (tree, exponents) in enumerate(self.evidence["minors"], 1):
            entries = [int(sums[a + b]) for a in range(k) for b in range(k)]
            minor, ratio = nmod_mat(k, k, entries, PRIME).det(), rational(tree)
            require(ratio > 0 and len(exponents) == len(factors), "minor")
            whole = number(ratio.numerator) / number(ratio.denominator)
            for factor, exponent in zip(factors, exponents, strict=True):
                whole *= factor**exponent
            require(whole == minor, "minor")

    def count(self):
        require(self.counted() == self.goal["number"], "number")

    def no_count(self):
        if "points" not in self.evidence:
            return require(self.counted() != self.goal["number"], "number")
        points, seen = self.evidence["points"], set()
        require(len(points) == self.goal["number"] + 1, "points")
        for point in points:
            values = point_values(self.names, point, points)
            if values is None:
                return None
            require(not any(self.names.differences(self.goal["equations"], values)), "no solution")
            own = tuple(int(values[n]) for n in self.goal["names"])
            others = tuple(int(values[n]) for n in self.names.plain if n not in self.goal["names"])
            seen.add((own, others))
        require(len({own for own, _ in seen}) == len(points), "the same point")
        require(len({others for _, others in seen}) == 1, "other constants")

    def spans(self):
        """Ranks of values at random points: of the operator, of what is known, and with more."""
        names, goal, variables = self.names, self.goal, self.names.data["variables"]
        ranges = [range(goal["degree"] // w + 1) for w in goal["weights"]]
        weighed = partial(zip, goal["weights"], strict=True)
        monomials = [
            ["*", 1, 1, *(["^", v, e] for v, e in zip(variables, exponents, strict=True))]
            for exponents in product(*ranges)
            if sum(w * e for w, e in weighed(exponents)) <= goal["degree"]
        ]
        more = [self.evidence["further"]] if "further" in self.evidence else []
        fixed = names.random_values(self.generator)
        points = []
        while len(points) < len(monomials) + len(more) + 5:
            own = names.random_values(self.generator)
            points.append(own | {n: fixed[n] for n in names.data.get("constants", [])})

        def applied(tree, factor, values):
            rate = names.value(names.along(tree), values)
            return rate - scalar(names, factor, values) * names.value(tree, values)

        integrals, solutions = (
            [names.open(t) for t in goal[key]] for key in ("integrals", "solutions")
        )
        for values in points[:5]:
            for factor, trees in ((0, integrals), (goal["factor"], [*solutions, *more])):
                require(all(applied(t, factor, values) == 0 for t in trees), "no solution")

        def rank(rows):
            entries = [int(x) for row in rows for x in row]
            return nmod_mat(len(rows), len(rows[0]), entries, PRIME).rank() if rows else 0

        def at_points(trees):
            return [[names.value(tree, values) for values in points] for tree in trees]

        within, known = at_points(monomials), []
        require(rank(within) == len(monomials), "the points are too few")
        waiting = [(row, 0) for row in at_points(solutions)]
        factors = [row for row in at_points(integrals) if len({*map(int, row)}) > 1]
        while waiting:
            row, start = waiting.pop()
            if any(row) and rank([*within, row]) == len(monomials):
                known.append(row)
                for k, other in enumerate(factors[start:], start):
                    waiting.append(([a * b for a, b in zip(row, other, strict=True)], k))
        further = at_points([names.open(tree) for tree in more])
        require(rank([*within, *further]) == len(monomials), "its degree")
        operator = [[applied(m, goal["factor"], values) for values in points] for m in monomials]
        return len(monomials) - rank(operator), rank(known), rank([*known, *further])

    def kernel(self):
        self.at(given=False)
        whole, known, _ = self.spans()
        require(whole == known, "one is missing")

    def solved(self, constants):
        """The series of both sides, where the constants have values."""
        names, moving = self.names, [*self.names.data["variables"]]
        initial = {name: names.open(tree) for name, tree in self.goal["initial"]}
        require(len(initial) == len(self.goal["initial"]), "an initial value is given twice")
        moving += [name for name in names.radicands if name in initial]
        require({*moving} == {*initial}, "an initial value is missing")
        fixed = {name: value for name, value in constants.items() if name not in initial}
        start = {name: names.value(tree, fixed) for name, tree in initial.items()}
        for name in names.radicands:
            if name in initial:
                require(
                    start[name] ** 2 == names.value(names.radicands[name], {**fixed, **start}),
                    "root",
                )
            else:
                require(names.value(names.along(name), constants) == 0, "a root moves")
        rates = {name: names.along(name) for name in initial}
        found = {**fixed, **solution(rates, start, names.value, fixed)}
        return start, [
            (found[y], names.value(names.open(tree), found)) for y, tree in self.goal["equations"]
        ]

    def along(self):
        require(
            {y for y, _ in self.goal["equations"]} <= {*self.names.data["variables"]}, "no variable"
        )
        point = self.at(given=False)
        start, _ = self.solved(point)
        require(all(point[name] == value for name, value in start.items()), "it begins elsewhere")
        for values in self.general():
            for left, right in self.solved(values)[1]:
                require(left == right, "they part")

    def no_along(self):
        point = self.at(given=False)
        start, both = self.solved(point)
        require(all(point[name] == value for name, value in start.items()), "it begins elsewhere")
        require(any(left != right for left, right in both), "they do not part")

    def no_kernel(self):
        point = self.at(given=False)
        if "further" in self.evidence:
            _, known, more = self.spans()
            return require(more > known, "none is missing")
        both = [(t, self.goal["factor"]) for t in self.goal["solutions"]]
        both += [(t, 0) for t in self.goal["integrals"]]
        opened = [(self.names.open(tree), factor) for tree, factor in both]
        rests = (
            self.names.value(self.names.along(tree), point)
            - scalar(self.names, factor, point) * self.names.value(tree, point)
            for tree, factor in opened
        )
        require(any(rest != 0 for rest in rests), "all are solutions")


OPPOSITE = {
    "follows": "fails", "fails": "follows", "rank": "no_rank",
    "count": "no_count", "kernel": "no_kernel", "along": "no_along",
}  # fmt: skip


def shown(goal, evidence, spaces, holds, bound=()):
    kind = goal["goal"] if holds else OPPOSITE[goal["goal"]]
    getattr(Judge(spaces[goal["space"]], goal, evidence, bound), kind)()


def uses(data, name):
    if isinstance(data, dict):
        return any(uses(v, name) for k, v in data.items() if k not in ("goal", "space"))
    return any(uses(x, name) for x in data) if isinstance(data, list) else data == name


def exists(goal, evidence, spaces):
    bound = dict(evidence["values"])
    names = goal["numbers"] + goal["expressions"]
    require([name for name, _ in evidence["values"]] == names, "values")
    require(all(any(uses(one, name) for one in goal["goals"]) for name in names), "unused")
    for name in goal["numbers"]:
        rational(bound[name])
    for one, entry in zip(goal["goals"], evidence["evidence"], strict=True):
        shown(one, entry, spaces, True, [(n, t) for n, t in bound.items() if uses(one, n)])


def exists_not(goal, evidence, spaces):
    one = goal["goals"][evidence["inner"]]
    require(one["goal"] == "follows" and not one["given"] and len(one["conclusions"]) == 1, "kind")
    judge = Judge(spaces[one["space"]], one, evidence)
    bound = {name: {} for name in goal["numbers"] + goal["expressions"]}
    judge.names.rates = judge.names.rates | {name: f"{name}'" for name in goal["expressions"]}
    weights = [rational(weight) for weight, _ in evidence["points"]]
    points = [point for _, point in evidence["points"]]
    require(len(points) == 1 or (points and not goal["expressions"]), "points")
    values = [judge.at(given=False, point=point, more=points) for point in points]
    if None in values:
        return
    factors = [number(w.numerator) / number(w.denominator) for w in weights]
    factors = factors if len(points) > 1 else [number(1)]
    gaps = []
    for _ in range(3):
        free = {n: number(judge.generator.randrange(PRIME)) for n in bound}
        free |= {f"{n}'": number(judge.generator.randrange(PRIME)) for n in bound}
        there = [judge.names.differences(one["conclusions"][0], v | free) for v in values]
        gaps.append([sum(map(mul, factors, gap), number(0)) for gap in zip(*there, strict=True)])
    fixed = any(len({int(g) for g in gap}) == 1 and gap[0] != 0 for gap in zip(*gaps, strict=True))
    require(fixed, "it may hold")


def is_true(data, seed=1):
    """Whether the evidence of a certificate, whose digest does not matter, shows what it says."""
    generator = random.Random(seed)
    try:
        spaces = []
        text = json.dumps(data)
        conjugating = any(f'"{word}"' in text for word in ("conj", "change", "squares"))
        for space in data["spaces"]:
            spaces.append(Names(space, spaces))
        for names in spaces:
            for _ in range(POINTS):
                names.sound(names.random_values(generator), conjugating)
        if data["sign"] == "holds":
            for goal, evidence in zip(data["goals"], data["evidence"], strict=True):
                judge = (
                    exists(goal, evidence, spaces)
                    if goal["goal"] == "exists"
                    else shown(goal, evidence, spaces, True)
                )
        else:
            ((goal, evidence),) = [
                (data["goals"][e["goal"]], {k: v for k, v in e.items() if k != "goal"})
                for e in data["evidence"]
            ]
            judge = (
                exists_not(goal, evidence, spaces)
                if goal["goal"] == "exists"
                else shown(goal, evidence, spaces, False)
            )
        require(judge is None, "")
    except (Untrue, ArithmeticError, LookupError, TypeError, ValueError) as error:
        return False, repr(error)
    untrue = [why for one in data.get("failures", []) if (why := is_true(one, seed)[1])]
    return bool(data["goals"]) and not untrue, "".join(untrue)
