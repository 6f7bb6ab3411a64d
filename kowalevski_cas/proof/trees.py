"""Formulas as trees of JSON, and back: ``["*", 2, ["D", "x_1"]]``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kowalevski_cas.notation import (
    Conjugate,
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    ScalarProduct,
    Sum,
    Vector,
)

Tree = Any
"""A name, an integer, or a list of an operation and trees."""


class CertificateError(ValueError):
    """A statement for which no certificate can be written."""


def encode(formula: Formula) -> Tree:
    """The tree of a formula.

    >>> encode(Sum((Name("x_1"), Negative(Power(Name("x_2"), Number(2))))))
    ['+', 'x_1', ['-', ['^', 'x_2', 2]]]
    """
    match formula:
        case Number(value):
            return value
        case Name(name):
            return name
        case Power(base, Number(exponent)):
            return ["^", encode(base), exponent]
    for op, kind in _KINDS.items():
        if type(formula) is kind:
            return [op, *map(encode, formula.children())]
    raise CertificateError(f"a {type(formula).__name__} cannot be certified")


def decode(tree: Tree, mark: str) -> Formula:
    """The formula of a tree; derivatives get this mark.

    >>> decode(["D", "x_1"], "dot") == Derivative(Name("x_1"), "dot")
    True
    """
    if isinstance(tree, str):
        return Name(tree)
    if isinstance(tree, int):
        return Number(tree) if tree >= 0 else Negative(Number(-tree))
    op, *rest = tree
    if op == "^":
        return Power(decode(rest[0], mark), Number(rest[1]))
    parts = tuple(decode(part, mark) for part in rest)
    if op == "D":
        return Derivative(parts[0], mark)
    if op == "/":
        result, *divisors = parts
        for divisor in divisors:
            result = Quotient(result, divisor)
        return result
    make: Callable[..., Formula] = _KINDS[op]
    return make(parts) if op in ("+", "*", "vector", "diag") else make(*parts)


_KINDS: dict[str, type[Formula]] = {
    "+": Sum,
    "-": Negative,
    "*": Product,
    "/": Quotient,
    "sqrt": Root,
    "D": Derivative,
    "conj": Conjugate,
    "vector": Vector,
    "diag": Diagonal,
    "dot": ScalarProduct,
    "cross": CrossProduct,
}


def names_of(tree: Tree) -> set[str]:
    """The names that occur in a tree.

    >>> sorted(names_of(["d", "x", ["*", 2, "y", ["D", "z"]]]))
    ['x', 'y', 'z']
    """
    if isinstance(tree, str):
        return {tree}
    if isinstance(tree, list):
        return {name for part in tree[1:] for name in names_of(part)}
    return set()


def uses(tree: Tree, op: str) -> bool:
    """Whether an operation occurs in a tree."""
    return isinstance(tree, list) and (tree[0] == op or any(uses(part, op) for part in tree[1:]))
