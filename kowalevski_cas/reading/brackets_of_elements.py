r"""Brackets of the elements of a matrix by Kronecker's deltas, each of them by itself.

So :math:`\{M_{ij},M_{kl}\}=\delta_{ik}M_{jl}+\ldots` says of a skew matrix of order three that
:math:`\{M_{12},M_{13}\}=M_{23}`, and of two other pairs what their brackets are.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import combinations, product

Value = dict[tuple[int, int], int]
"""The elements in a bracket, each with its factor."""

_INDICES = r"_\s*\{\s*([a-z])\s*([a-z])\s*\}"


def brackets_of_elements(tex: str, letter: str, order: int, is_skew: bool) -> str:
    r"""The brackets that an equation with four indices gives; empty if it is none.

    Neither is one of which the right side is not skew as the left one is.

    >>> tex = r"\{K_{ij},K_{kl}\}=\delta_{ik}K_{jl}+\delta_{jl}K_{ik}"
    >>> tex += r"-\delta_{jk}K_{il}-\delta_{il}K_{jk}"
    >>> brackets_of_elements(tex, "K", 3, True)[:56]
    '\\{K_{12},K_{13}\\}=K_{23},\\quad \\{K_{12},K_{23}\\}=-K_{13}'
    >>> brackets_of_elements(tex.replace("-", "+"), "K", 3, True)
    ''
    """
    own = re.escape(letter) + _INDICES
    head = re.match(rf"\s*\\\{{\s*{own}\s*,\s*(?:\\,\s*)?{own}\s*\\\}}\s*&?=", tex)
    if head is None or len({*head.groups()}) < len(head.groups()):
        return ""
    right = re.sub(r"\\label\{[^}]*\}", "", tex[head.end() :])
    terms = _terms(right.strip(" .,;\n"), own)
    every = range(1, order + 1)
    values = {
        at: _value(terms, dict(zip(head.groups(), at, strict=True)), is_skew)
        for at in product(every, repeat=4)
    }
    if not terms or not _is_skew(values, is_skew):
        return ""
    pairs = [(i, j) for i in every for j in every if i < j or not is_skew]
    found = ((one, other, values[*one, *other]) for one, other in combinations(pairs, 2))
    return r",\quad ".join(
        rf"\{{{_element(letter, one)},{_element(letter, other)}\}}={_sum(letter, value)}"
        for one, other, value in found
    )


def _terms(right: str, own: str) -> list[tuple[int, tuple[str, str], tuple[str, str]]]:
    """The terms of a sum of deltas by elements: sign and indices; none if it is anything else."""
    term = re.compile(rf"\s*(?P<sign>[+-]?)\s*\\delta{_INDICES}\s*{own}\s*")
    found, at = [], 0
    while one := term.match(right, at):
        sign = -1 if one["sign"] == "-" else 1
        _, a, b, c, d = one.groups()
        found.append((sign, (a, b), (c, d)))
        at = one.end()
    return found if at == len(right) else []


def _value(
    terms: list[tuple[int, tuple[str, str], tuple[str, str]]], at: Mapping[str, int], is_skew: bool
) -> Value:
    """What the terms are at values of the indices; a letter without a value stands for nothing."""
    found = Counter[tuple[int, int]]()
    for sign, (a, b), (c, d) in terms:
        if at.get(a, a) != at.get(b, b):
            continue
        i, j = at.get(c, 0), at.get(d, 0)
        if is_skew and i >= j:
            sign, i, j = -sign * (i > j), j, i
        found[i, j] += sign
    return {pair: factor for pair, factor in found.items() if factor}


def _is_skew(values: Mapping[tuple[int, ...], Value], elements_are: bool) -> bool:
    """Whether brackets change their signs with the order of both elements, and of indices."""

    def opposite(one: Value, other: Value) -> bool:
        return one == {pair: -factor for pair, factor in other.items()}

    return all(
        opposite(value, values[k, m, i, j])
        and (not elements_are or opposite(value, values[j, i, k, m]))
        for (i, j, k, m), value in values.items()
    )


def _element(letter: str, pair: tuple[int, int]) -> str:
    return f"{letter}_{{{pair[0]}{pair[1]}}}"


def _sum(letter: str, value: Value) -> str:
    return "".join(_signed(letter, value)).removeprefix("+") or "0"


def _signed(letter: str, value: Value) -> Iterator[str]:
    for pair, factor in sorted(value.items()):
        number = "" if abs(factor) == 1 else str(abs(factor))
        yield f"{'-' if factor < 0 else '+'}{number}{_element(letter, pair)}"
