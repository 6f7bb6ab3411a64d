"""The pieces of a formula, side by side: their TeX and their width together."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Node:
    r"""A piece of a formula: its plain TeX, its width in em, its class.

    ``kind`` is one of ord, bin, rel, open, close, punct, space, row, cell. ``inner`` holds the
    nodes of a pair ``\left…\right`` or of the numerator of a fraction (whose denominator is
    ``below``), so that either can be taken apart where it does not fit on a line.
    """

    tex: str
    width: float
    kind: str = "ord"
    inner: tuple[Node, ...] = ()
    below: tuple[Node, ...] = ()
    rows: tuple[tuple[tuple[Node, ...], ...], ...] = ()
    tall: bool = False
    scripted: bool = False
    fraction: bool = False

    @property
    def pair(self) -> bool:
        """Whether ``inner`` begins and ends with brackets."""
        return bool(self.inner) and not self.fraction


def bracketed(opening: str, inside: Sequence[Node], closing: str) -> Node:
    r"""A pair of brackets as one node; they grow (``\left…\right``) around something tall."""
    tall = any(node.tall for node in inside)
    if tall or "." in {opening, closing}:
        tex = rf"\left{opening} {joined(inside)} \right{closing}"
    else:
        tex = f"{spaced(opening)}{joined(inside)}{spaced(closing)}"
    return Node(
        tex,
        measured(inside) + (1.5 if tall else 0.8),
        inner=(Node(opening, 0.45, "open"), *inside, Node(closing, 0.45, "close")),
        tall=tall,
    )


def spaced(token: str) -> str:
    """A token that keeps its distance from a letter after it."""
    return token + " " if token[0] == "\\" and token[-1].isalpha() else token


def joined(nodes: Iterable[Node]) -> str:
    """The TeX of nodes side by side."""
    text, before = "", "open"
    for node in nodes:
        if node.kind == "bin" and before not in {"ord", "close"}:
            text += spaced(node.tex.strip())  # a sign, not an operation
        elif node.kind in {"bin", "rel"}:
            text += f" {node.tex.strip()} "
        else:
            text += node.tex + (" " if node.kind == "punct" else "")
        before = node.kind
    return text if text.endswith("\\ ") else re.sub(r"(?<!\\) +", " ", text).strip(" ")


def measured(nodes: Iterable[Node]) -> float:
    """The width of nodes side by side, in em."""
    total, before = 0.0, "open"
    for node in nodes:
        unary = node.kind == "bin" and before in {"open", "bin", "rel", "punct", "space"}
        total += node.width - (0.44 if unary else 0.0)
        before = node.kind
    return total


def split(nodes: Iterable[Node], kind: str) -> list[tuple[Node, ...]]:
    """The nodes between those of a kind."""
    parts: list[list[Node]] = [[]]
    for node in nodes:
        if node.kind == kind:
            parts.append([])
        else:
            parts[-1].append(node)
    return [tuple(part) for part in parts]


def trimmed(nodes: Sequence[Node]) -> tuple[Node, ...]:
    """The nodes without spaces and empty rows at either end."""
    start, end = 0, len(nodes)
    while start < end and nodes[start].kind in {"space", "row", "cell"}:
        start += 1
    while end > start and nodes[end - 1].kind in {"space", "row", "cell"}:
        end -= 1
    return tuple(nodes[start:end])
