"""Sparse elimination modulo a large prime: ranks of vectors, and the relations among them.

Vectors with an entry where no other has one are independent of the others, and are set aside until
none is left. The others are reduced one by one by those before, each of which stands for the place
where fewest have an entry; where this costs more than it would cost in a dense matrix, FLINT does
that instead.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from heapq import heapify, heappop, heappush
from typing import Any

from flint import nmod_mat

PRIME = 2**61 - 1

LARGEST = 40_000_000
"""The largest number of entries of a dense matrix, and of steps that nobody has counted on."""

Vector = Mapping[Any, int]
"""Residues that are not zero, by their places."""

Relation = dict[int, int]
"""Residues by the places of vectors: a combination of these that vanishes."""


class TooLarge(ValueError):
    """What would take too much memory; the message says how large it is."""


class Echelon:
    """Vectors that are independent, each reduced by those before it.

    Args:
        often: in how many vectors there is an entry, by its place: one that is rare is chosen to
            be eliminated from later vectors.
    """

    def __init__(self, often: Mapping[Any, int] | None = None) -> None:
        rare = None if often is None else {place: (n, place) for place, n in often.items()}
        self._key = None if rare is None else rare.__getitem__
        self.rows: list[tuple[Any, list[tuple[Any, int]]]] = []
        """The place that stands for a vector, where it is one, and its other entries."""
        self.scales: list[int] = []
        """What each reduced vector was multiplied by."""
        self.work = 0
        """How many entries of vectors were subtracted."""
        self._pivots: dict[Any, int] = {}

    def __len__(self) -> int:
        return len(self.rows)

    def extend(self, vector: Vector) -> bool:
        """Whether a vector is independent of those before; it is added then."""
        rest, _ = self.reduce(vector)
        return self.add(rest)

    def add(self, rest: dict[Any, int]) -> bool:
        """Whether a reduced vector is not zero; it is added then."""
        if not rest:
            return False
        pivot = min(rest, key=self._key)
        scale = pow(rest.pop(pivot), -1, PRIME)
        self._pivots[pivot] = len(self.rows)
        self.rows.append((pivot, [(place, value * scale % PRIME) for place, value in rest.items()]))
        self.scales.append(scale)
        return True

    def reduce(self, vector: Vector) -> tuple[dict[Any, int], dict[int, int]]:
        """What is left of a vector, and the multiples of the rows that were subtracted from it."""
        rest, multiples, pivots = dict(vector), dict[int, int](), self._pivots
        waiting = [pivots[place] for place in rest if place in pivots]
        heapify(waiting)
        while waiting:  # a row has no pivot of an earlier one, so that the first ones come first
            index = heappop(waiting)
            pivot, row = self.rows[index]
            if not (factor := rest.pop(pivot, 0)):
                continue
            multiples[index] = factor
            self.work += len(row) + 1
            for place, value in row:
                if place in rest:
                    if new := (rest[place] - factor * value) % PRIME:
                        rest[place] = new
                    else:
                        del rest[place]
                else:
                    rest[place] = -factor * value % PRIME
                    if place in pivots:
                        heappush(waiting, pivots[place])
        return rest, multiples


def rank(vectors: Sequence[Vector]) -> int:
    """The rank of vectors modulo the prime.

    >>> rank([{"x": 1}, {"x": 2, "y": 1}, {"y": 3}])
    2

    Raises:
        TooLarge: they are many, and not sparse.
    """
    return len(vectors) - len(relations(vectors))


def relations(vectors: Sequence[Vector]) -> list[Relation]:
    """The relations that express a vector by those before it, if there is one, for each vector.

    Those by which it is expressed are independent, so that the relations are a basis of all.

    >>> relations([{"x": 1}, {"x": 2, "y": 1}, {"y": 3}]) == [{0: 6, 1: -3 % PRIME, 2: 1}]
    True

    Raises:
        TooLarge: they are many, and not sparse.
    """
    found: list[Relation] = []
    for block in _blocks(vectors, _dependent(vectors)):
        own = [vectors[k] for k in block]
        found += ({block[k]: v for k, v in relation.items()} for relation in _relations(own))
    return sorted(found, key=max)


def _dependent(vectors: Sequence[Vector]) -> list[int]:
    """The vectors that are left when those with an entry of their own are taken away in turn."""
    having = defaultdict[Any, list[int]](list)
    for k, vector in enumerate(vectors):
        for place in vector:
            having[place].append(k)
    often = {place: len(some) for place, some in having.items()}
    left = [True] * len(vectors)
    alone = [place for place, number in often.items() if number == 1]
    while alone:
        if often[place := alone.pop()] == 1:
            k = next(k for k in having[place] if left[k])
            left[k] = False
            for other in vectors[k]:
                often[other] -= 1
                if often[other] == 1:
                    alone.append(other)
    return [k for k, is_left in enumerate(left) if is_left]


def _blocks(vectors: Sequence[Vector], chosen: Iterable[int]) -> list[list[int]]:
    """The chosen vectors, in groups of which no two have an entry at the same place."""
    root: dict[Any, int] = {}
    above = {k: k for k in chosen}

    def top(k: int) -> int:
        while above[k] != k:
            above[k] = k = above[above[k]]
        return k

    for k in above:
        for place in vectors[k]:
            above[top(root.setdefault(place, k))] = top(k)
    groups = defaultdict[int, list[int]](list)
    for k in above:
        groups[top(k)].append(k)
    return [*groups.values()]


def _relations(vectors: Sequence[Vector]) -> Iterator[Relation]:
    frequency = Counter(place for vector in vectors for place in vector)
    echelon, rows = Echelon(frequency), list[tuple[int, dict[int, int]]]()
    entries = len(vectors) * len(frequency)
    dense = entries * (1 + min(len(vectors), len(frequency)) // 300)
    dependent: list[tuple[int, dict[int, int]]] = []
    for k, vector in enumerate(vectors):
        rest, multiples = echelon.reduce(vector)
        (rows if echelon.add(rest) else dependent).append((k, multiples))
        if echelon.work > dense and entries <= LARGEST:
            yield from _dense_relations(vectors, [*frequency])
            return
        if echelon.work > max(dense, LARGEST):
            size = f"{len(frequency)} rows and {len(vectors)} columns"
            raise TooLarge(f"a matrix has {size}, and is not sparse")
    for k, multiples in dependent:
        yield _traced(k, multiples, rows, echelon.scales)


def _traced(
    last: int,
    multiples: Mapping[int, int],
    rows: Sequence[tuple[int, Mapping[int, int]]],
    scales: Sequence[int],
) -> Relation:
    """The relation of a vector that was reduced to zero, in the vectors that were given."""
    found, rest = {last: 1}, dict(multiples)
    waiting = [-index for index in rest]
    heapify(waiting)
    while waiting:
        index = -heappop(waiting)
        if not (factor := rest.pop(index, 0) * scales[index] % PRIME):
            continue
        k, subtracted = rows[index]
        found[k] = -factor % PRIME
        for other, multiple in subtracted.items():
            if other not in rest:
                heappush(waiting, -other)
            rest[other] = (rest.get(other, 0) - factor * multiple) % PRIME
    return found


def _dense_relations(vectors: Sequence[Vector], places: Sequence[Any]) -> Iterator[Relation]:
    height, width = len(places), len(vectors)
    row = {place: k for k, place in enumerate(places)}
    entries = [0] * (height * width)
    for k, vector in enumerate(vectors):
        for place, value in vector.items():
            entries[row[place] * width + k] = value
    reduced, size = nmod_mat(height, width, entries, PRIME).rref()
    pivots: list[int] = []
    for k in range(width):
        if len(pivots) < size and int(reduced[len(pivots), k]):
            pivots.append(k)
            continue
        values = ((pivot, int(reduced[i, k])) for i, pivot in enumerate(pivots))
        yield {pivot: -value % PRIME for pivot, value in values if value} | {k: 1}
