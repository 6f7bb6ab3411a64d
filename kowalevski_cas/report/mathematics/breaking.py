"""Breaking a formula that is too wide into lines."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from kowalevski_cas.report.mathematics.nodes import Node, joined, measured, spaced, trimmed


@dataclass(frozen=True)
class Line:
    """One line of a display: what stands left of the alignment, and right of it."""

    left: str
    right: str
    indent: int = 0

    @property
    def tex(self) -> str:
        """The line as a row of ``aligned``."""
        space = r"\quad " * (self.indent % 2) + r"\qquad " * (self.indent // 2)
        sign = re.match(r"([+-]|\\pm|\\mp) ?", self.right) if self.indent else None
        right = f"{{}} {sign[1]} {self.right[sign.end() :]}" if sign else self.right
        return f"{self.left} & {space}{right}".strip()


@dataclass(frozen=True)
class _Break:
    """A place where a line can begin: how deep in brackets, and what it costs."""

    place: int
    depth: int = 0
    cost: float = 0.0


def broken(nodes: Sequence[Node], room: float, *, first: bool) -> list[Line]:
    """The nodes in lines. With ``first`` the line begins with the relation that is aligned."""
    if measured(nodes) <= room:
        return [Line("", joined(nodes))]
    found = []
    for part, price in ((1.0, 0.0), (0.7, 60.0), (0.4, 200.0)):
        loose = _loosened(nodes, room, part)
        cost, cuts = _cuts(loose, room, first)
        found.append((cost + price, -part, cuts, loose))
    _, _, cuts, loose = min(found, key=lambda one: one[:2])
    return [
        Line("", joined(trimmed(loose[a.place : b.place])), _indent(a, first) if a.place else 0)
        for a, b in pairwise(cuts)
    ]


def _loosened(nodes: Sequence[Node], room: float, part: float) -> list[Node]:
    """The nodes, with pairs that take more than a part of the line, and wide fractions, apart."""
    return [piece for node in nodes for piece in _apart(node, room, part)]


def _apart(node: Node, room: float, part: float) -> list[Node]:
    """The pieces of a node that is too wide to stay whole; else the node."""
    if node.pair:
        if node.width <= part * room:
            return [node]
        opening, *inside, closing = node.inner
        if opening.tex == "." or closing.tex.startswith("."):
            return [node]
        left, right = (r"\Bigl", r"\Bigr") if node.tall else ("", "")
        return [
            Node(f"{left}{spaced(opening.tex.strip())}", opening.width, "open"),
            *_loosened(inside, room, part),
            Node(f"{right}{spaced(closing.tex.strip())}", closing.width, "close"),
        ]
    if node.inner and node.width > 0.9 * room and measured(node.below) < 0.6 * room:
        below = rf"\frac{{1}}{{{joined(node.below)}}}"
        return [
            Node(below, measured(node.below) + 0.24, tall=True),
            Node(r"\Bigl(", 0.6, "open"),
            *_loosened(node.inner, room, part),
            Node(r"\Bigr)", 0.6, "close"),
        ]
    return [node]


def _cuts(nodes: Sequence[Node], room: float, first: bool) -> tuple[float, list[_Break]]:
    """Where to break, from the beginning to the end, and what it costs.

    Few lines, few breaks within brackets, no line wider than there is room.
    """
    sums = [0.0]
    for node in nodes:
        sums.append(sums[-1] + node.width)
    places = [_Break(0), *_breaks(nodes), _Break(len(nodes))]
    best: list[tuple[float, int]] = [(0.0, -1)]
    for end in range(1, len(places)):
        choices = []
        for start in range(end - 1, -1, -1):
            used = sums[places[end].place] - sums[places[start].place]
            used += _indent(places[start], first) if start else 0
            over = max(0.0, used - room)
            empty = 0.0 if end == len(places) - 1 else max(0.0, 1 - used / room)
            cost = 100.0 + 2000.0 * over + 20.0 * empty**2 + places[end].cost
            choices.append((best[start][0] + cost, start))
            if over:
                break
        best.append(min(choices))
    cuts = [len(places) - 1]
    while cuts[-1] > 0:
        cuts.append(best[cuts[-1]][1])
    return best[-1][0], [places[cut] for cut in reversed(cuts)]


def _breaks(nodes: Sequence[Node]) -> Iterator[_Break]:
    """Where a line can be broken."""
    depth, before = 0, "open"
    for place, node in enumerate(nodes):
        if node.kind == "close":
            depth = max(0, depth - 1)
        if place:
            if node.kind == "rel" and depth == 0:
                yield _Break(place, depth, -5.0)
            elif node.tex.strip() in {"+", "-", r"\pm", r"\mp"} and before in {"ord", "close"}:
                yield _Break(place, depth, 60.0 * depth)
            elif before == "punct":
                yield _Break(place, depth, 60.0 * depth if depth else -1.0)
            elif depth == 0 and before in {"ord", "close"} and node.inner and node.width > 4:
                yield _Break(place, 2, 180.0)
        if node.kind == "open":
            depth += 1
        if node.kind != "space":
            before = node.kind


def _indent(at: _Break, first: bool) -> int:
    """How far the line that begins at a break is moved to the right, in em."""
    if at.cost < 0:  # a relation, or a new statement after a comma
        return 0 if first else 1
    return min(1 + at.depth, 4) + (0 if first else 1)
