"""Breaking a formula that is too wide into lines."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from kowalevski_cas.report.pieces import Piece, width_of

Apart = Callable[[Piece], tuple[Piece, Piece]]
"""What stands before and behind the inner pieces of one that is taken apart."""


@dataclass(frozen=True)
class Line:
    """One line of a display: what stands left of the alignment, and right of it."""

    left: tuple[Piece, ...]
    right: tuple[Piece, ...]
    indent: int = 0


@dataclass(frozen=True)
class _Break:
    """A place where a line can begin: how deep in brackets, and what it costs."""

    place: int
    depth: int = 0
    cost: float = 0.0


def break_lines(pieces: Sequence[Piece], room: float, apart: Apart, *, first: bool) -> list[Line]:
    """The pieces in lines. With ``first`` the line begins with the relation that is aligned."""
    if width_of(pieces) <= room:
        return [Line((), tuple(pieces))]
    found = []
    for part, price in ((1.0, 0.0), (0.7, 60.0), (0.4, 200.0)):
        loose = _loosen(pieces, room, part, apart)
        cost, cuts = _cuts(loose, room, first)
        found.append((cost + price, -part, cuts, loose))
    _, _, cuts, loose = min(found, key=lambda option: option[:2])
    return [
        Line((), tuple(loose[a.place : b.place]), _indent(a, first) if a.place else 0)
        for a, b in pairwise(cuts)
    ]


def _loosen(pieces: Sequence[Piece], room: float, part: float, apart: Apart) -> list[Piece]:
    """The pieces, with wide fractions, and brackets wider than a part of the line, apart."""
    loose = []
    for piece in pieces:
        bracket = piece.inner and not piece.below and piece.width > part * room
        wide = piece.below and piece.width > 0.9 * room and width_of(piece.below) < room - 2
        if bracket or wide:
            before, behind = apart(piece)
            inner = piece.inner[1:-1] if bracket else piece.inner
            loose += [before, *_loosen(inner, room, part, apart), behind]
        else:
            loose.append(piece)
    return loose


def _cuts(pieces: Sequence[Piece], room: float, first: bool) -> tuple[float, list[_Break]]:
    """Where to break, from the beginning to the end, and what it costs.

    Few lines, few breaks within brackets, no line wider than there is room.
    """
    sums = [0.0]
    for piece in pieces:
        sums.append(sums[-1] + piece.width)
    places = [_Break(0), *_breaks(pieces), _Break(len(pieces))]
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


def _breaks(pieces: Sequence[Piece]) -> Iterator[_Break]:
    """Where a line can be broken."""
    depth, before = 0, "open"
    for place, piece in enumerate(pieces):
        if piece.kind == "close":
            depth = max(0, depth - 1)
        if place:
            if piece.kind == "relation" and depth == 0:
                yield _Break(place, depth, -5.0)
            elif piece.kind == "sign" and before in {"ord", "close"}:
                yield _Break(place, depth, 60.0 * depth)
            elif before in {"ord", "close"} and piece.kind == "ord" and piece.width > 4:
                yield _Break(place, depth + 2, 180.0 * (depth + 1))
        if piece.kind == "open":
            depth += 1
        before = piece.kind


def _indent(at: _Break, first: bool) -> int:
    """How far the line that begins at a break is moved to the right, in em."""
    if at.cost < 0:  # a relation
        return 0 if first else 1
    return min(1 + at.depth, 4) + (0 if first else 1)
