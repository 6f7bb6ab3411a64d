"""Sparse elimination modulo a large prime: ranks of vectors, and the relations among them.

The place where fewest vectors have an entry is eliminated next, by the shortest of these vectors,
so that little fills up. Where it does, FLINT eliminates what is left, in a dense matrix.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from heapq import heapify, heappop, heappush
from typing import Any

from flint import nmod_mat

from kowalevski_cas.algebra.polynomials import TooLarge

PRIME = 2**61 - 1

LARGEST = 40_000_000
"""The largest number of entries of a dense matrix, and of steps that nobody has counted on."""

RARE = 2
"""A place that so many vectors have is told when it becomes rarer."""

FULL = 4
"""Vectors are full where one entry in so many is not zero."""

Vector = Mapping[Any, int]
"""Residues that are not zero, by their places."""

Relation = dict[int, int]
"""Residues by the places of vectors: a combination of these that vanishes."""


class Echelon:
    """Vectors that are independent, each reduced by those before it."""

    def __init__(self) -> None:
        self._rows: list[tuple[Any, list[tuple[Any, int]]]] = []
        """The place that stands for a vector, where it is one, and its other entries."""
        self._pivots: dict[Any, int] = {}

    def __len__(self) -> int:
        return len(self._rows)

    def extend(self, vector: Vector) -> bool:
        """Whether a vector is independent of those before; it is added then."""
        rest = self._reduce(vector)
        if not rest:
            return False
        pivot = min(rest)
        scale = pow(rest.pop(pivot), -1, PRIME)
        self._pivots[pivot] = len(self._rows)
        row = [(place, value * scale % PRIME) for place, value in rest.items()]
        self._rows.append((pivot, row))
        return True

    def has(self, vector: Vector) -> bool:
        """Whether a vector depends on them."""
        return not self._reduce(vector)

    def _reduce(self, vector: Vector) -> dict[Any, int]:
        """What is left of a vector when multiples of the rows are subtracted from it."""
        rest, pivots = dict(vector), self._pivots
        waiting = [pivots[place] for place in rest if place in pivots]
        heapify(waiting)
        while waiting:  # a row has no pivot of an earlier one, so that the first ones come first
            pivot, row = self._rows[heappop(waiting)]
            if factor := rest.pop(pivot, 0):
                new = [place for place, _ in row if place not in rest and place in pivots]
                for place in new:
                    heappush(waiting, pivots[place])
                _subtract(rest, factor, row)
        return rest


def _subtract(rest: dict[Any, int], factor: int, row: Sequence[tuple[Any, int]]) -> None:
    """Subtract a multiple of a row from a vector."""
    for place, value in row:
        if new := (rest.get(place, 0) - factor * value) % PRIME:
            rest[place] = new
        else:
            del rest[place]


def rank(vectors: Sequence[Vector]) -> int:
    """The rank of vectors modulo the prime.

    >>> rank([{"x": 1}, {"x": 2, "y": 1}, {"y": 3}])
    2

    Raises:
        TooLarge: they are many, and not sparse.
    """
    return sum(_Elimination([vectors[k] for k in block]).rank() for block in _blocks(vectors))


def relations(vectors: Sequence[Vector]) -> list[Relation]:
    """The relations that express a vector by those before it, if there is one, for each vector.

    Those by which it is expressed are independent, so that the relations are a basis of all.

    >>> relations([{"x": 1}, {"x": 2, "y": 1}, {"y": 3}]) == [{0: 6, 1: -3 % PRIME, 2: 1}]
    True

    Raises:
        TooLarge: they are many, and not sparse.
    """
    found: list[Relation] = []
    for block in _blocks(vectors):
        block_relations = _Elimination([vectors[k] for k in block]).relations()
        found += (
            {block[k]: v for k, v in relation.items()} for relation in _by_last(block_relations)
        )
    return sorted(found, key=max)


def _blocks(vectors: Sequence[Vector]) -> list[list[int]]:
    """The vectors, in groups of which no two have an entry at the same place."""
    at = defaultdict[Any, list[int]](list)
    for k, vector in enumerate(vectors):
        for place in vector:
            at[place].append(k)
    blocks, left = list[list[int]](), dict.fromkeys(range(len(vectors)))
    while left:
        first, _ = left.popitem()
        block, waiting = [first], [*vectors[first]]
        while waiting:  # each place is looked at once
            new = [k for k in at.pop(waiting.pop(), ()) if k in left]
            block += new
            for k in new:
                del left[k]
                waiting += vectors[k]
        blocks.append(sorted(block))
    return sorted(blocks)


def _by_last(found: Iterable[Relation]) -> list[Relation]:
    """The basis of the same relations in which no other one has an entry where one ends."""
    ends: dict[int, Relation] = {}
    for relation in found:
        for end, other in ends.items():
            if end in relation:
                _subtract(relation, relation[end], [*other.items()])
        end = max(relation)
        scale = pow(relation[end], -1, PRIME)
        scaled = {k: value * scale % PRIME for k, value in relation.items()}
        for other in ends.values():
            if end in other:
                _subtract(other, other[end], [*scaled.items()])
        ends[end] = scaled
    return [*ends.values()]


class _Elimination:
    """Vectors, as they are when one place after the other is eliminated.

    Raises :class:`TooLarge` if they fill up, and are too many for a dense matrix.
    """

    def __init__(self, vectors: Sequence[Vector]) -> None:
        self.left = {k: dict(vector) for k, vector in enumerate(vectors)}
        self.multiples: list[dict[int, int]] = [{} for _ in vectors]
        """The multiples of the pivots that were subtracted from each vector."""
        self.pivots: list[tuple[int, int]] = []
        """The vectors by which a place was eliminated, and what each was multiplied by."""
        self.having = defaultdict[Any, set[int]](set)
        """The vectors left that have an entry at a place."""
        for k, vector in self.left.items():
            for place in vector:
                self.having[place].add(k)
        self.size = f"{len(self.having)} rows and {len(vectors)} columns"
        self.entries = sum(map(len, vectors))
        self._eliminate()

    def _eliminate(self) -> None:
        """Eliminate one place after the other, the rarest first, until what is left is full."""
        work, having = 0, self.having
        rarest = [(len(some), place) for place, some in having.items()]
        heapify(rarest)
        while rarest:
            number, place = heappop(rarest)
            if number != (now := len(having.get(place, ()))):
                if now:
                    heappush(rarest, (now, place))
                continue
            dense = len(self.left) * len(having)
            # a place of one vector only is eliminated without another entry, however full the rest
            # is
            if number > 1 and FULL * self.entries > dense and dense <= LARGEST:
                return
            work += self._eliminate_place(place, rarest)
            if work > LARGEST:
                raise TooLarge(f"a matrix has {self.size}, and is not sparse")

    def _eliminate_place(self, place: Any, rarest: list[tuple[int, Any]]) -> int:
        """Eliminate a place from all vectors but one, which leaves; the steps that this takes."""
        left, having = self.left, self.having
        some = having.pop(place)
        shortest = min(some, key=lambda k: (len(left[k]), k)) if len(some) > 1 else some.pop()
        row = left.pop(shortest)
        self.entries -= len(row)
        scale = pow(row.pop(place), -1, PRIME)
        some.discard(shortest)
        if some:
            entries = [(other, value * scale % PRIME) for other, value in row.items()]
            for k in sorted(some):
                self._subtract(k, place, entries)
        for other in row:
            having[other].discard(shortest)
            if not (now := len(having[other])):
                del having[other]
            elif now <= RARE:
                heappush(rarest, (now, other))
        self.pivots.append((shortest, scale))
        return len(some) * (1 + len(row))

    def _subtract(self, k: int, place: Any, entries: Sequence[tuple[Any, int]]) -> None:
        """Eliminate a place from the vector with a number, by the other entries of the pivot."""
        vector, having = self.left[k], self.having
        before, factor = len(vector), vector.pop(place)
        self.multiples[k][len(self.pivots)] = factor
        for other, value in entries:
            if (old := vector.get(other)) is None:
                vector[other] = -factor * value % PRIME
                having[other].add(k)
            elif new := (old - factor * value) % PRIME:
                vector[other] = new
            else:
                del vector[other]
                having[other].discard(k)
        self.entries += len(vector) - before

    def rank(self) -> int:
        """The rank."""
        return len(self.pivots) + (int(self._rest().rank()) if self.having else 0)

    def relations(self) -> Iterator[Relation]:
        """A basis of the relations."""
        if not self.having:
            yield from (self._traced({k: 1}) for k in self.left)
            return
        places = [*self.left]
        reduced, size = self._rest().transpose().rref()
        pivots: list[int] = []
        for column, k in enumerate(places):
            if len(pivots) < size and int(reduced[len(pivots), column]):
                pivots.append(column)
                continue
            values = ((places[pivot], int(reduced[i, column])) for i, pivot in enumerate(pivots))
            yield self._traced({other: -value % PRIME for other, value in values if value} | {k: 1})

    def _rest(self) -> nmod_mat:
        """The vectors left as rows of a dense matrix."""
        order = {place: k for k, place in enumerate(self.having)}
        entries = [0] * (len(self.left) * len(order))
        for k, vector in enumerate(self.left.values()):
            for place, value in vector.items():
                entries[k * len(order) + order[place]] = value
        return nmod_mat(len(self.left), len(order), entries, PRIME)

    def _traced(self, relation: Relation) -> Relation:
        """A relation among vectors that are left, in the vectors that were given."""
        rest = defaultdict[int, int](int)
        for k, value in relation.items():
            for index, multiple in self.multiples[k].items():
                rest[index] += value * multiple
        # from the last pivot backwards: each was reduced by those before it only
        waiting = [-index for index in rest]
        heapify(waiting)
        while waiting:
            index = -heappop(waiting)
            k, scale = self.pivots[index]
            if not (factor := rest.pop(index) * scale % PRIME):
                continue
            relation[k] = -factor % PRIME
            for other, multiple in self.multiples[k].items():
                if other not in rest:
                    heappush(waiting, -other)
                rest[other] = (rest[other] - factor * multiple) % PRIME
        return relation
