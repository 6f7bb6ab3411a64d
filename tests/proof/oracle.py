"""Whether what a certificate states is true, by an arithmetic that is not the checker's.

Formulas are differentiated and conjugated as trees, by structural recursion, and
evaluated with python-flint at random points modulo a prime of 61 bits. A statement that
is false holds at such a point with a probability of about 1e-16.
"""

from __future__ import annotations

import random
from functools import reduce
from operator import add, mul, truediv

from flint import nmod, nmod_mat
from flint.utils.flint_exceptions import DomainError

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


class Names:
    """A space: its trees with all definitions put in, its rates as trees."""

    def __init__(self, data, spaces):
        self.data = data
        self.plain = [*data["variables"], *data.get("constants", [])]
        self.lets, self.radicands = {}, {}
        self.swap = {a: b for pair in data.get("conjugates", []) for a, b in (pair, pair[::-1])}
        squares = {name: tree for kind, name, tree in data.get("steps", []) if kind == "root"}
        self.units = {name for name, tree in squares.items() if tree in (-1, ["-", 1])}
        for kind, name, tree in data.get("steps", []):
            if kind == "let":
                self.lets[name] = self.open(tree)
            elif kind == "root":
                self.radicands[name] = self.open(tree)
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
            for name, radicand in self.radicands.items():
                if self.value(radicand, values) == wanted:
                    return values[name]
            raise Untrue("a root is not declared")
        first, *others = (self.value(x, values) for x in rest)
        if op == "-":
            return -first
        require(op in ("+", "*", "/"), op)
        require(op != "/" or 0 not in others, "division by zero")
        return reduce({"+": add, "*": mul, "/": truediv}[op], others, first)

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

    def sound(self, values):
        """Whether relations, field, change and conjugation are what they have to be."""
        data = self.data
        for tree in data.get("nonzero", []):
            require(self.value(self.open(tree), values) != 0, "a divisor is zero")
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
        if "change" in data:
            self.sound_change(data["change"], values)
        if "conjugates" in data:
            for name, radicand in self.radicands.items():
                bar = self.value(self.bar(name), values)
                require(bar * bar == self.value(self.bar(radicand), values), "conjugate")

    def sound_change(self, change, values):
        """Whether the new variables are one to one, with the old relations, rates and reality."""
        require(len(change["formulas"]) == len(self.old.data["variables"]), "not one to one")
        for name, tree in change["formulas"]:
            there = self.value(self.moved(self.old.open(tree)), values)
            require(there == self.value(self.open(name), values), "inverse")
        for name, radicand in self.old.radicands.items():
            here = self.value(self.moved(name), values)
            require(here * here == self.value(self.moved(radicand), values), "old relation")
        scale = self.value(self.moved(self.old.open(change["time"])), values)
        for name in self.old.plain:
            rate = self.value(self.moved(self.old.along(name)), values) * scale
            require(self.value(self.along(self.open(name)), values) == rate, "old rate")
        for name in self.old.data["variables"]:
            tree = self.open(name)
            require(self.value(self.bar(tree), values) == self.value(tree, values), "real")


def point_values(names, point):
    """The values of a point modulo the prime."""
    roots = {d: square_root(number(d)) for d in point["roots"]}
    require(all(d > 1 for d in roots), "a root of a point")
    if any(root is None for root in roots.values()):
        return None  # this prime cannot tell
    numbers = Names({"variables": []}, [])
    unit = square_root(number(-1))

    def value(tree, i):
        if isinstance(tree, list) and tree[0] == "sqrt":
            require(tree[1] in roots, "a root of a point")
            return roots[tree[1]]
        if tree == "i":
            return i
        if isinstance(tree, list):
            inner = [value(x, i) for x in (tree[1:] if tree[0] != "^" else tree[1:2])]
            if tree[0] == "^":
                return inner[0] ** tree[2]
            keys = {f"v{k}": v for k, v in enumerate(inner)}
            return numbers.value([tree[0], *keys], keys)
        return numbers.value(tree, {})

    values = {name: value(tree, unit) for name, tree in point["values"]}
    require(len(values) == len(point["values"]), "a value is given twice")
    require(set(values) == {*names.plain, *names.radicands}, "a value is missing")
    for name, radicand in names.radicands.items():
        require(values[name] ** 2 == names.value(radicand, values), "off a relation")
    for tree in names.data.get("nonzero", []):
        require(names.value(names.open(tree), values) != 0, "a divisor is zero")
    bars = {name: value(tree, -unit) for name, tree in point["values"]}
    for name in values:
        require(names.value(names.bar(name), values) == bars[name], "not real")
    return values


def settled(names, values, targets, known, proof):
    """Whether the identities of a proof hold at a point in general position."""
    if groups := proof.get("product"):
        require(not names.radicands and not names.swap, "cases are for real numbers")
        require(len(groups) == len(proof["cases"]), "a case is missing")
        product = number(1)
        for group, case in zip(groups, proof["cases"], strict=True):
            found = [names.components(tree, values)[0] for tree in group]
            require(case.keys() <= {"product", "cofactors", "cases"}, "case")
            settled(names, values, targets, known + found, case)
            product *= found[0] if len(found) == 1 else sum((x * x for x in found), number(0))
        targets = [product]
    rows = proof.get("cofactors") or [[]] * len(targets)
    require(len(rows) == len(targets), "rows")
    for target, row in zip(targets, rows, strict=True):
        require(len(row) == len(known), "row")
        for tree, value in zip(row, known, strict=True):
            target = target - names.components(tree, values)[0] * value
        require(target == 0, "the two sides differ")


def part_holds(names, item, generator):
    kind = item["shows"]
    point = point_values(names, item["point"]) if "point" in item else None
    given = item.get("given", [])
    if point is not None:
        require(all(d == 0 for d in names.differences(given, point)), "off the set")
    if kind == "follows":
        require(item["equations"] and (not given or "point" in item), "nothing")
        for _ in range(POINTS):
            values = names.random_values(generator)
            targets = names.differences(item["equations"], values)
            known = names.differences(given, values)
            if "root" in item:
                flipped = {**values, item["root"]: -values[item["root"]]}
                others = names.differences(item["equations"], flipped)
                require(known == names.differences(given, flipped), "sign")
                targets = [a * b for k, a in enumerate(targets) for b in others[k:]]
            settled(names, values, targets, known, item)
    elif kind == "rank":
        trees = [*item["levels"], *item["functions"], *(["+", a, ["-", b]] for a, b in given)]
        variables = names.data["variables"]
        size = len(variables) - len(trees)
        require(item["dimension"] in (None, size), "dimension")
        if point is not None:
            rows = [
                [names.value(names.partial(names.open(t), v), point) for v in variables]
                for t in trees
            ]
            matrix = nmod_mat(
                len(rows), len(variables), [int(x) for row in rows for x in row], PRIME
            )
            require(matrix.rank() == len(trees), "rank")
    else:
        require(kind == "differ", kind)
        if point is not None:
            require(any(d != 0 for d in names.differences([item["equation"]], point)), "equal")


def is_true(data, seed=1):
    """Whether a certificate, whose digest does not matter, states what is true."""
    generator = random.Random(seed)
    try:
        spaces = []
        for space in data["spaces"]:
            spaces.append(Names(space, spaces))
        for names in spaces:
            for _ in range(POINTS):
                names.sound(names.random_values(generator))
        for item in data["parts"]:
            part_holds(spaces[item["space"]], item, generator)
    except (Untrue, ZeroDivisionError, KeyError, IndexError, TypeError, ValueError) as error:
        return False, repr(error)
    return bool(data["parts"]), ""
