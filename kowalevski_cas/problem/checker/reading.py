"""What a certificate may be made of: a few shapes of JSON, names, and the bounds of it all."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from typing import Any

FORMAT, VERSION = "kowalevski-cas certificate", 2
SIZE = 1_000_000  # characters of a file
WORK = 20_000_000  # steps in the check of a file, by the terms and the size of numbers
BITS = 6_000  # of an integer
DEGREE = 1_000  # total, of a polynomial
NAMES = 150  # generators of a ring

Json = Any
Spend = Callable[[int], None]
Block = list[dict[int, int]]  # sparse vectors, by places

_WORD = r"[\w\\^*()\[\]+\-/.,' ]"
_GROUP = rf"\{{{_WORD}+\}}"
for _ in range(8):  # groups may stand in groups, as in the root of a fraction
    _GROUP = rf"\{{(?:{_WORD}|{_GROUP})+\}}"
NAME = re.compile(
    rf"(?:[A-Za-z]|\\(?=[A-Za-z]))(?:[\w']|\\(?=[A-Za-z])|\^(?=[-+A-Za-z*{{\\])|(?<=\^)[-+*]|(?<=_)[-+*]|{_GROUP})*",
    re.ASCII,
)


def printable(text: str) -> str:
    """The text in a line of printable letters."""
    return re.sub("[^ -~]", "?", text)


class Rejected(Exception):
    """The certificate does not prove what it states; the message is printable."""

    def __init__(self, message: str) -> None:
        super().__init__(printable(message))


class Exhausted(Rejected):
    """The check takes more steps than it has; nothing is said of what is stated."""


def need(condition: object, message: str) -> None:
    """Reject the certificate unless the condition holds."""
    if not condition:
        raise Rejected(message)


class Budget:
    """The steps that are left for the check of a file."""

    def __init__(self, steps: int = WORK) -> None:
        self.left = steps

    def spend(self, steps: int) -> None:
        """Count steps."""
        self.left -= steps
        if self.left < 0:
            self.end()

    def each(self, work: Callable[[Block, Spend], int], blocks: list[Block]) -> list[int]:
        """What work gives on each of the blocks, which have nothing in common."""
        return [work(block, self.spend) for block in blocks]

    def end(self) -> None:
        """There are no steps left."""
        raise Exhausted("it takes too much work")


# -- JSON --------------------------------------------------------------------------


def parse(text: str) -> Json:
    """The data of a certificate of this format."""
    need(len(text) < SIZE, "it is too long")
    hooks: Json = {"parse_int": _integer, "parse_float": _no_number, "parse_constant": _no_number}
    try:
        data = json.loads(text, object_pairs_hook=_unique, **hooks)
    except json.JSONDecodeError as error:
        raise Rejected(f"it is no JSON: {error.msg}, line {error.lineno}") from None
    need(type(data) is dict and data.get("format") == FORMAT, "it is no certificate")
    old = type(data.get("version")) is int and data["version"] == 1
    need(not old, "it is a certificate of format 1: make certificates renews it")
    need(repr(data.get("version")) == repr(VERSION), "it has another format")
    return record(data, "format version claim spaces goals sign evidence digest", "failures")


def _unique(both: list[tuple[str, Json]]) -> Json:
    data = dict(both)
    need(len(data) == len(both), "a key stands twice")
    return data


def _integer(digits: str) -> int:
    need(len(digits) * 3 < BITS, "a number is too large")
    return int(digits)


def _no_number(digits: str) -> Json:
    raise Rejected(f"{digits:.20} is no integer")


def record(data: Json, required: str, optional: str = "") -> Json:
    """A JSON object that has all of the required keys, and no others but the optional ones."""
    need(type(data) is dict, "an object is expected")
    missing = ", ".join(key for key in required.split() if key not in data)
    need(not missing, f"it has no {missing}")
    need(data.keys() <= {*required.split(), *optional.split()}, "a key is unknown")
    return data


def part_of(data: Json, keys: str) -> Json:
    """The part of an object under some keys."""
    return {key: data[key] for key in keys.split() if key in data}


def items(data: Json, *sizes: int) -> list[Json]:
    """A JSON list, of one of the sizes."""
    if type(data) is not list:
        raise Rejected("a list is expected")
    if sizes and len(data) not in sizes:
        raise Rejected("a list has another length")
    return data


def pairs(data: Json) -> list[list[Json]]:
    """A list of lists of two."""
    return [items(pair, 2) for pair in items(data)]


def integer(data: Json, least: int, most: int) -> int:
    """An integer between two bounds."""
    need(type(data) is int and least <= data <= most, "a number is odd")
    found: int = data
    return found


def label(data: Json) -> str:
    """A name."""
    if type(data) is str and NAME.fullmatch(data):
        return data
    raise Rejected(f"a name is odd: {data!a:.80}")


def labels(data: Json) -> list[str]:
    """A list of names, all different."""
    found = [label(name) for name in items(data)]
    need(len({*found}) == len(found), "a name is given twice")
    return found


# -- formulas ----------------------------------------------------------------------

MANY = 1_000_000
OPERATIONS = {  # how many formulas they take
    "+": (2, MANY), "*": (2, MANY), "/": (2, MANY), "-": (1, 1), "^": (2, 2), "sqrt": (1, 1),
    "D": (1, 1), "d": (2, 2), "conj": (1, 1), "vector": (1, MANY), "diag": (1, MANY),
    "dot": (2, 2), "cross": (2, 2),
}  # fmt: skip
LARGEST_EXPONENT = 64


def operation(tree: Json) -> tuple[str, list[Json]]:
    """The operation of a formula that is neither a name nor a number, and its formulas."""
    op, *parts = items(tree) or [""]
    if type(op) is not str or op not in OPERATIONS:
        raise Rejected("an operation is not understood")
    least, most = OPERATIONS[op]
    if not least <= len(parts) <= most:
        raise Rejected(f"{op} is one of another number of formulas")
    return op, parts


def exponent(tree: Json) -> int:
    """The exponent of a power."""
    return integer(tree, 0, LARGEST_EXPONENT)


def parts_of(tree: Json) -> Iterator[Json]:
    """All formulas of which a formula is made, and itself."""
    waiting = [tree]
    while waiting:
        yield (tree := waiting.pop())
        if type(tree) is list:
            waiting += tree[1:]


def names_in(tree: Json) -> set[str]:
    """The names in a formula."""
    return {part for part in parts_of(tree) if type(part) is str}


def derives(tree: Json) -> bool:
    """Whether a derivative along the vector field stands in a formula."""
    return any(type(part) is list and part[:1] == ["D"] for part in parts_of(tree))


def squares_in(tree: Json) -> list[Json]:
    """The formulas of which a formula takes a root by its sign."""
    roots = (part for part in parts_of(tree) if type(part) is list and part[:1] == ["sqrt"])
    return [square for root in roots for square in root[1:]]


def factors(tree: Json) -> list[Json]:
    """The factors of a formula that is a product or a power; numbers do not count."""
    if type(tree) is not list:
        return [tree]
    op, parts = operation(tree)
    if op == "*":
        kept = [part for part in parts if type(part) is not int or part == 0]
        return [factor for part in kept for factor in factors(part)]
    if op == "^" and exponent(parts[1]) > 0:
        return factors(parts[0])
    return [tree]


BINDS = {"+": 1, "-": 1, "*": 2, "/": 2, "^": 3}


def say(tree: Json, around: int = 0) -> str:
    """A formula in plain letters; in brackets, where an operation around it binds as strongly."""
    if type(tree) is int:
        return f"({tree})" if tree < 0 and around else str(tree)
    if type(tree) is not list:
        return tree if type(tree) is str else label(tree)
    op, parts = operation(tree)
    binds = BINDS.get(op, 0)
    words = [say(part, binds) for part in parts]
    if not binds:
        return f"{op}({', '.join(words)})"
    said = f"-{words[0]}" if op == "-" else f" {op} ".join(words)
    if op == "+":  # "+ (-x)" is "- x"
        behind = zip(parts[1:], words[1:], strict=True)
        signed = [
            f" - {w[2:-1]}" if type(p) is list and p[0] == "-" else f" + {w}" for p, w in behind
        ]
        said = words[0] + "".join(signed)
    return f"({said})" if binds <= around else said


def say_all(equations: Json) -> str:
    """Equations in plain letters."""
    return ", ".join(f"{say(left)} = {say(right)}" for left, right in pairs(equations))
