r"""The chambers of the diagram of the whole top at an energy, by its structure, however narrow.

The plane of :math:`(g,\sqrt k)` is cut at the ends of all walls into strips, each strip by its
walls into cells; cells of neighbouring strips that share more than an end are in one chamber.
Inside of a chamber the three integrals are independent, so all its levels have equally
many tori of dimension three; and where an elliptic torus of dimension two is on its edge, these
shrink to it. So on the edge of all values they are as many as the critical tori, and there the
structure tells their number.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise, product

import numpy as np

from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.walls import Wall, tori_on_M4, walls

SAME = 1e-10
"""What is nearer to each other, relative to the whole diagram, is the same."""

LEAST = 1e-8
"""Narrower chambers may be in pieces, and are passed over."""

MOST = 32
"""No chamber has more tori."""


@dataclass(frozen=True)
class Trapezoid:
    """What is between two walls in a strip from one value of √k to another."""

    low: float
    high: float
    left: Wall
    right: Wall

    def at(self, root: float) -> tuple[float, float]:
        """From which g to which it is at a value of √k, also at the ends."""
        return self.left.g(root), self.right.g(root)

    @cached_property
    def middle(self) -> tuple[float, float]:
        """The place (g, √k) in the middle."""
        root = (self.low + self.high) / 2
        return sum(self.at(root)) / 2, root

    def depth(self, width: float, height: float) -> float:
        """How large it is, as a share of the width or the height of a diagram."""
        left, right = self.at(self.middle[1])
        return min((right - left) / width, (self.high - self.low) / height)


@dataclass(frozen=True)
class Chamber:
    """A chamber by its cells, the numbers of tori that its walls leave, and its place.

    ``place`` is that (g, √k) in the middle of its largest cell, ``depth`` the size of this.
    """

    h: float
    cells: tuple[Trapezoid, ...]
    numbers: frozenset[int]
    place: tuple[float, float]
    depth: float

    @property
    def level(self) -> tuple[float, float, float]:
        """The values (h, k, g) at its place."""
        g, root = self.place
        return self.h, root**2, g

    @property
    def tori(self) -> int | None:
        """The number of its tori, if the walls tell it."""
        return next(iter(self.numbers)) if len(self.numbers) == 1 else None


def chambers(fields: Fields, h: Fraction) -> list[Chamber]:
    """The chambers at an energy, the largest first; none up to the least energy of all.

    >>> wide, *others = chambers(Fields(Fraction(6, 5), Fraction(7, 10)), Fraction(0))
    >>> wide.tori, [chamber.tori for chamber in others]
    (1, [2, 2])
    """
    return Strips(fields, h).chambers() if h > -(fields.a + fields.b) else []


class Strips:
    """The strips at an energy, with their cells, and in which chamber each of these is."""

    def __init__(self, fields: Fields, h: Fraction) -> None:
        self._fields, self._h = fields, h
        self._walls = walls(fields, h)
        ends = np.unique([end for wall in self._walls for end in (wall.low, wall.high)])
        self._height = float(ends[-1])
        apart = np.diff(ends, prepend=-np.inf) > SAME * self._height
        self._strips = [list(self._cells(*strip)) for strip in pairwise(ends[apart].tolist())]
        g = [x for strip in self._strips for cell in strip for x in cell.at(cell.middle[1])]
        self._width = max(g) - min(g)
        self._number = self._join()

    def chambers(self) -> list[Chamber]:
        """The chambers, the largest first."""
        found = [self._chamber(*option) for option in self._options().items()]
        large = (chamber for chamber in found if chamber.depth > LEAST)
        return sorted(large, key=lambda chamber: -chamber.depth)

    def type(self) -> list[tuple[object, ...]]:
        """What stays the same while nothing changes: the chambers, by their tori and walls."""
        around: dict[int | None, set[tuple[str, int, bool]]] = {}
        for wall, *sides in self._sides():
            for side in sides:
                sort = (wall.name, wall.tori, wall.elliptic)
                around.setdefault(side, set()).add(sort)
        return sorted(
            (tuple(sorted(numbers)), *sorted(around[number]))
            for number, numbers in self._options().items()
        )

    def _cells(self, low: float, high: float) -> Iterator[Trapezoid]:
        middle = (low + high) / 2
        across = sorted(
            (wall for wall in self._walls if wall.low < middle < wall.high),
            key=lambda wall: wall.g(middle),
        )
        return (Trapezoid(low, high, left, right) for left, right in pairwise(across))

    def _join(self) -> dict[Trapezoid, int]:
        """The number of the chamber of each cell."""
        cells = [cell for strip in self._strips for cell in strip]
        number = {cell: place for place, cell in enumerate(cells)}
        for below, above in pairwise(self._strips):
            for one, other in product(below, above):
                (left, right), (first, last) = one.at(one.high), other.at(one.high)
                if min(right, last) - max(left, first) > SAME * self._width:
                    old, new = number[other], number[one]
                    number = {cell: new if n == old else n for cell, n in number.items()}
        return number

    def _sides(self) -> Iterator[tuple[Wall, int | None, int | None]]:
        """Each wall in each strip, with the chambers beside it; None is outside."""
        for strip in self._strips:
            numbers = [None, *(self._number[cell] for cell in strip), None]
            across = [*(cell.left for cell in strip), *(cell.right for cell in strip[-1:])]
            yield from zip(across, numbers, numbers[1:], strict=False)

    def _options(self) -> dict[int, frozenset[int]]:
        """The numbers of tori that a chamber can have, by its number.

        At an elliptic wall they differ by as many as this has, at a hyperbolic one by no more,
        and there are some on either side. Outside there are none.
        """
        options: dict[int | None, frozenset[int]] = {
            number: frozenset(range(MOST + 1)) for number in self._number.values()
        }
        options[None] = frozenset({0})
        for cell, number in self._number.items():
            if (below := self._tori_below(cell)) is not None:
                options[number] &= {below}
        before = None
        while options != before:
            before = dict(options)
            for wall, *sides in self._sides():
                for one, other in (sides, sides[::-1]):
                    options[one] = frozenset(
                        x for x in options[one] if any(_beside(wall, x, y) for y in options[other])
                    )
        return {number: some for number, some in options.items() if number is not None}

    def _chamber(self, number: int, options: frozenset[int]) -> Chamber:
        cells = tuple(cell for cell, other in self._number.items() if other == number)
        depths = [cell.depth(self._width, self._height) for cell in cells]
        depth, place = max((depth, cell.middle) for depth, cell in zip(depths, cells, strict=True))
        return Chamber(float(self._h), cells, options, place, depth)

    def _tori_below(self, cell: Trapezoid) -> int | None:
        """The tori of M⁴ on the lower edge of a cell, of both signs of J₃, if it reaches down."""
        left, right = cell.at(cell.low)
        if cell.low > 0 or right - left <= SAME * self._width:
            return None
        return tori_on_M4(self._fields, self._h, Fraction((left + right) / 2))


def _beside(wall: Wall, one: int, other: int) -> bool:
    """Whether chambers on both sides of a wall can have these numbers of tori."""
    if wall.elliptic:
        return abs(one - other) == wall.tori
    return abs(one - other) <= wall.tori and min(one, other) > 0
