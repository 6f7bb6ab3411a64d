"""The places of boxes and lines: layers, few crossings, everything near what belongs to it."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from graphlib import TopologicalSorter
from itertools import pairwise
from typing import Final

WIDTH: Final = 155.0
"""The width of the page, which no layer of boxes exceeds, in mm."""

_BESIDE: Final = 3.0
_PASS: Final = 1.8


@dataclass
class Cell:
    """A place in a layer: a claim, or a long line passing through, perhaps a citation's."""

    name: str
    order: float
    width: float
    cited: bool = False
    x: float = 0.0
    before: list[Cell] = field(default_factory=list)
    after: list[Cell] = field(default_factory=list)

    @property
    def box(self) -> bool:
        """Whether it is a claim."""
        return self.width > 0

    def ends(self) -> list[str]:
        """The boxes to which lines through this place lead."""
        return [self.name] if self.box else [end for cell in self.after for end in cell.ends()]


def layout(
    rests: dict[str, list[str]], widths: dict[str, float], cited: Collection[tuple[str, str]] = ()
) -> list[list[Cell]]:
    """The boxes in layers, foundations first, each at its place from the middle of the page.

    Of the lines some are citations: pairs of what is cited and where.
    """
    layers = _layers(rests, widths, cited)
    _order(layers)
    _place(layers)
    return layers


def _levels(rests: dict[str, list[str]], widths: dict[str, float]) -> dict[str, int]:
    """The layer of each name: under what it rests on, and no layer wider than the page."""
    level: dict[str, int] = {}
    used: dict[int, float] = {}
    for name in TopologicalSorter(rests).static_order():
        at = max((level[b] + 1 for b in rests[name]), default=0)
        wide = widths[name] + _BESIDE
        while used.get(at, 0.0) and used[at] + wide > WIDTH:
            at += 1
        level[name] = at
        used[at] = used.get(at, 0.0) + wide
    for name in rests:  # a foundation stands near the first claim that needs it
        above = [level[n] for n in rests if name in rests[n]]
        wide = widths[name] + _BESIDE
        if not rests[name] and above:
            for at in range(min(above) - 1, level[name], -1):
                if used.get(at, 0.0) + wide <= WIDTH:
                    used[level[name]] -= wide
                    level[name], used[at] = at, used.get(at, 0.0) + wide
                    break
    present = sorted(set(level.values()))
    return {name: present.index(at) for name, at in level.items()}


def _layers(
    rests: dict[str, list[str]], widths: dict[str, float], cited: Collection[tuple[str, str]]
) -> list[list[Cell]]:
    """Cells by layer; a line over several layers passes through a cell in each."""
    order = {name: k for k, name in enumerate(rests)}
    level = _levels(rests, widths)
    layers: list[list[Cell]] = [[] for _ in range(max(level.values()) + 1)]
    cells = {name: Cell(name, order[name], widths[name]) for name in rests}
    for name in rests:
        layers[level[name]].append(cells[name])
    for name, belows in rests.items():
        for below in belows:
            previous, citing = cells[below], (below, name) in cited
            for between in range(level[below] + 1, level[name]):
                passing = (c for c in previous.after if not c.box)
                shared = next((c for c in passing if (c.name, c.cited) == (below, citing)), None)
                if shared is None:
                    shared = Cell(below, (order[below] + order[name]) / 2, 0.0, citing)
                    layers[between].append(shared)
                    _join(previous, shared)
                previous = shared
            _join(previous, cells[name])
    return layers


def _join(below: Cell, above: Cell) -> None:
    below.after.append(above)
    above.before.append(below)


def _crossings(layers: Sequence[Sequence[Cell]]) -> int:
    total = 0
    for left, right in pairwise(layers):
        at = {id(cell): k for k, cell in enumerate(right)}
        ends = [at[id(c)] for cell in left for c in sorted(cell.after, key=lambda c: at[id(c)])]
        total += sum(ends[a] > ends[b] for a in range(len(ends)) for b in range(a + 1, len(ends)))
    return total


def _order(layers: list[list[Cell]]) -> None:
    """Sort each layer so that few lines cross: sweeps of barycentres, the best one kept."""
    for layer in layers:
        layer.sort(key=lambda cell: cell.order)
    best, fewest = [list(layer) for layer in layers], _crossings(layers)
    for sweep in range(12):
        forward = sweep % 2 == 0
        for k in range(1, len(layers)) if forward else range(len(layers) - 2, -1, -1):
            _sort(layers[k], layers[k - 1 if forward else k + 1], forward)
        if (now := _crossings(layers)) < fewest:
            best, fewest = [list(layer) for layer in layers], now
    layers[:] = best


def _sort(layer: list[Cell], beside: Sequence[Cell], forward: bool) -> None:
    at = {id(cell): k for k, cell in enumerate(beside)}
    order = {id(cell): float(k) for k, cell in enumerate(layer)}

    def middle(cell: Cell) -> float:
        near = [at[id(c)] for c in (cell.before if forward else cell.after)]
        return sum(near) / len(near) if near else order[id(cell)]

    layer.sort(key=middle)


def _place(layers: Sequence[Sequence[Cell]]) -> None:
    """Move each cell near its neighbours, and never on top of the next one."""
    for layer in layers:
        _spread(layer, [0.0] * len(layer))
    for sweep in range(24):
        for layer in layers if sweep % 2 == 0 else reversed(layers):
            wanted = []
            for cell in layer:
                near = [c.x for c in (*cell.before, *cell.after)]
                wanted.append(sum(near) / len(near) if near else cell.x)
            _spread(layer, wanted)


def _spread(layer: Sequence[Cell], wanted: Sequence[float]) -> None:
    """The places nearest to those wanted, in order, with room between, and on the page."""
    offsets = [0.0]
    for cell, after in pairwise(layer):
        room = _BESIDE if cell.box or after.box else _PASS
        offsets.append(offsets[-1] + (cell.width + after.width) / 2 + room)
    blocks: list[tuple[float, int]] = []
    for want, offset in zip(wanted, offsets, strict=True):
        blocks.append((want - offset, 1))
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            (a, m), (b, n) = blocks[-2:]
            blocks[-2:] = [((a * m + b * n) / (m + n), m + n)]
    flat = [value for value, count in blocks for _ in range(count)]
    for cell, value, offset in zip(layer, flat, offsets, strict=True):
        cell.x = value + offset
    left = layer[0].x - layer[0].width / 2 + WIDTH / 2
    right = layer[-1].x + layer[-1].width / 2 - WIDTH / 2
    shift = -(left + right) / 2 if right - left > 0 else -min(0.0, left) - max(0.0, right)
    for cell in layer:
        cell.x += shift
