"""Formulas as trees of JSON, and back: ``["*", 2, ["D", "x_1"]]``."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
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
    Partial,
    Power,
    Product,
    Quotient,
    Root,
    ScalarProduct,
    Sum,
    Vector,
    once,
)

Tree = Any
"""A name, an integer, or a list of an operation and trees."""

MARK = "dot"
"""How a derivative along the field is marked in formulas of a space."""


LARGEST_EXPONENT = 64
LARGEST_POWER = 6_000
"""The largest degree of a power, and how many bits one of a number may have."""


class FormatError(ValueError):
    """Something that has no place in a certificate, or a file that is none."""


@once
def encode(formula: Formula) -> Tree:
    """The tree of a formula of a space.

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
        case Power(base, Negative(Number(exponent))):
            return ["/", 1, ["^", encode(base), exponent]]
        case Partial(argument, name):
            return ["d", name, encode(argument)]
    op = _OPS.get(type(formula))
    if op is None:
        raise FormatError(f"a {type(formula).__name__} has no place in a certificate")
    return [op, *map(encode, formula.children())]


def decode(tree: Tree) -> Formula:
    """The formula of a tree; raises :class:`FormatError` if it is none.

    >>> decode(["D", "x_1"]) == Derivative(Name("x_1"), MARK)
    True
    """
    kind = type(tree)
    if kind is str and tree:
        return _name(tree)
    if kind is int:
        return _number(tree) if tree >= 0 else Negative(_number(-tree))
    if kind is not list or len(tree) < 2 or type(tree[0]) is not str:
        raise FormatError("a formula is expected")
    op = tree[0]
    if op == "^" and len(tree) == 3:
        return _power(tree[1], tree[2])
    if op in _KINDS and op not in ("/", "D"):
        return _make_node(op, tuple(map(decode, tree[1:])))
    match tree:
        case ["d", str(name), argument]:
            return Partial(decode(argument), name)
        case ["D", argument]:
            return Derivative(decode(argument), MARK)
        case ["/", above, *divisors] if divisors:
            result = decode(above)
            for divisor in divisors:
                result = Quotient(result, decode(divisor))
            return result
    raise FormatError("a formula is expected")


def whole(data: Tree) -> int:
    """A small exponent; raises :class:`FormatError` for anything else."""
    if type(data) is not int or not 0 <= data <= LARGEST_EXPONENT:
        raise FormatError("a whole number is expected, no large one")
    return data


def _power(base: Tree, exponent: Tree) -> Formula:
    if type(base) is str and base:
        return _power_of_name(base, whole(exponent))
    formula = decode(base)
    if whole(exponent) * _size(base) > LARGEST_POWER:
        raise FormatError("a power is too large")
    return Power(formula, Number(exponent))


def _size(tree: Tree) -> int:
    """A bound on the degree of a formula, or on the bits of a number."""
    if not isinstance(tree, list):
        return tree.bit_length() if isinstance(tree, int) else 1
    op, *parts = tree
    if op == "^":
        return whole(parts[-1]) * _size(parts[0])
    sizes = map(_size, parts)
    return max(sizes, default=0) if op == "+" else sum(sizes)


_name, _number = cache(Name), cache(Number)


@cache
def _power_of_name(name: str, exponent: int) -> Formula:
    return Power(_name(name), _number(exponent))


def _make_node(op: str, parts: tuple[Formula, ...]) -> Formula:
    kind = _KINDS[op]
    try:
        return kind(parts) if kind in _LISTS else kind(*parts)
    except TypeError:
        raise FormatError(f"“{op}” has {len(parts)} operands") from None


_KINDS: dict[str, Callable[..., Formula]] = {
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
_OPS = {kind: op for op, kind in _KINDS.items()}
_LISTS = {Sum, Product, Vector, Diagonal}
