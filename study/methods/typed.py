"""Formulas as people type them into SymPy with ``sqrt`` and ``I``, and simplified.

An expression is built from the trees of a certificate as one would type it: a
root of an expression is ``sqrt``; a variable whose square the paper prints, as
:math:`z_1^2+x_1y_2=c_1`, stays a symbol and the constant is replaced. Derivatives
are SymPy's own. This runs in a process of its own, under a limit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

import sympy

from kowalevski_cas.proof.trees import Tree
from study.step import Measured

Expression = Any
Values = tuple[Expression, ...]

METHODS: Mapping[str, Callable[[Expression], bool | None]] = {
    "simplify": lambda e: bool(sympy.simplify(e) == 0),
    "expand": lambda e: bool(sympy.expand(e) == 0),
    "cancel": lambda e: bool(sympy.cancel(e) == 0),
    "ratsimp": lambda e: bool(sympy.ratsimp(e) == 0),
    "equals": lambda e: e.equals(0),
}
"""Whether an expression is zero, in the words of SymPy; ``equals`` may not know."""


def decide(question: Mapping[str, Any]) -> Measured:
    """Whether a method finds that the statements of a certificate are true."""
    certificate, method = question["certificate"], METHODS[question["method"]]
    spaces: list[Typed] = []
    for data in certificate["spaces"]:
        spaces.append(Typed(data, spaces))
    for part in certificate["parts"]:
        space = spaces[part["space"]]
        for left, right in part["equations"]:
            for a, b in zip(space.value(left), space.value(right), strict=True):
                zero = method(a - b)
                if zero is None:
                    return {"verdict": "none", "reason": "it does not know"}
                if not zero:
                    return {"verdict": "rejected", "reason": "something is left that is not 0"}
    return {"verdict": "accepted", "reason": ""}


class Typed:
    """A space of a certificate, typed into SymPy."""

    def __init__(self, data: Mapping[str, Any], earlier: list[Typed]) -> None:
        self.names = [*data["variables"], *data.get("constants", [])]
        steps = data.get("steps", [])
        roots = {step[1]: step[2] for step in steps if step[0] == "root"}
        replaced = self._replaced(data, roots)
        self.names = [name for name in self.names if name not in replaced.values()]
        self.symbols = {
            name: sympy.Symbol(name) for name in [*self.names, *replaced] if name != "i"
        }
        self.env: dict[str, Values] = {name: (s,) for name, s in self.symbols.items()}
        self.env |= {"i": (sympy.I,)}
        for kind, name, tree in steps:
            if kind == "where" and tree in replaced.values():
                self.env.setdefault(tree, self.value(name))
        for kind, name, tree in steps:
            if kind == "let":
                self.env[name] = self.value(tree)
            elif kind == "root" and name not in self.env:
                self.env[name] = (sympy.sqrt(self.scalar(tree)),)
        self.rates: dict[str, Expression] = {}
        self._move(data, earlier)
        pairs = data.get("conjugates", [])
        swap = {a: b for pair in pairs for a, b in (pair, pair[::-1])}
        self.bar = {s: self.symbols[swap.get(n, n)] for n, s in self.symbols.items()}
        self.bar[sympy.I] = -sympy.I

    @staticmethod
    def _replaced(data: Mapping[str, Any], roots: Mapping[str, Tree]) -> dict[str, str]:
        """Variables that are roots, with the constant that is replaced instead."""
        found: dict[str, str] = {}
        for kind, left, right in data.get("steps", []):
            if kind == "where" and isinstance(right, str) and right in data.get("constants", []):
                names = [name for name in roots if name != "i" and ["^", name, 2] in _all(left)]
                found |= {name: right for name in names[:1]}
        return found

    def _move(self, data: Mapping[str, Any], earlier: list[Typed]) -> None:
        if "change" in data:
            change = data["change"]
            source = earlier[change["old"]]
            images = {s: self.scalar(name) for name, s in source.symbols.items()}
            scale = source.scalar(change["time"]).xreplace(images)
            for name, tree in change["formulas"]:
                rate = source.along(source.scalar(tree)).xreplace(images)
                self.rates[name] = sympy.expand(rate * scale)
        for names, factor, right in data.get("field", []):
            rows = zip(names, self.value(factor), self.value(right), strict=True)
            self.rates |= {name: above / below for name, below, above in rows}

    def along(self, e: Expression) -> Expression:
        """The derivative along the field, by the chain rule."""
        moving = [(s, self.rates[name]) for name, s in self.symbols.items() if name in self.rates]
        return sum((sympy.diff(e, s) * rate for s, rate in moving), sympy.Integer(0))

    def scalar(self, tree: Tree) -> Expression:
        """The value of a formula that is no vector."""
        (value,) = self.value(tree)
        return value

    def value(self, tree: Tree) -> Values:
        """The components of the value of a formula."""
        if isinstance(tree, str):
            return self.env[tree]
        if isinstance(tree, int):
            return (sympy.Integer(tree),)
        op, first, *rest = tree
        if op == "^":
            return (self.scalar(first) ** int(rest[0]),)
        if op == "d":
            return (sympy.diff(self.scalar(*rest), self.symbols[first]),)
        values = [self.value(part) for part in tree[1:]]
        if op in ("vector", "diag"):
            return tuple(value for (value,) in values)
        if rest:
            return reduce(lambda a, b: _binary(op, a, b), values)
        return tuple(self._unary(op, value) for value in values[0])

    def _unary(self, op: str, e: Expression) -> Expression:
        if op == "D":
            return self.along(e)
        if op == "conj":
            return e.xreplace(self.bar)
        return sympy.sqrt(e) if op == "sqrt" else -e


def _binary(op: str, a: Values, b: Values) -> Values:
    if op == "+":
        return tuple(x + y for x, y in zip(a, b, strict=True))
    if op == "cross":
        (p, q, r), (x, y, z) = a, b
        return (q * z - r * y, r * x - p * z, p * y - q * x)
    a, b = (a * len(b) if len(a) == 1 else a), (b * len(a) if len(b) == 1 else b)
    pairs = zip(a, b, strict=True)
    if op == "dot":
        return (sum((x * y for x, y in pairs), sympy.Integer(0)),)
    return tuple(x / y if op == "/" else x * y for x, y in pairs)


def _all(tree: Tree) -> list[Tree]:
    """A tree and everything below it."""
    below = [part for item in tree for part in _all(item)] if isinstance(tree, list) else []
    return [tree, *below]
