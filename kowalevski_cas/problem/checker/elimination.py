"""The rank of vectors modulo a prime.

The vectors fall into blocks that have no place in common. In a block the place where fewest vectors
have an entry is eliminated next, by the shortest of these vectors. Where the rest fills up, each
vector becomes one long number, in which all entries are subtracted at once.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from heapq import heapify, heappop, heappush
from operator import itemgetter

from .reading import Budget, Spend

PRIME = 2**61 - 1
FULL = 4  # vectors are full where one entry in so many is not zero

Vector = dict[int, int]  # residues that are not zero, by places


def rank(vectors: list[Vector], budget: Budget) -> int:
    """The rank; its steps are taken from the budget."""
    budget.spend(sum(map(len, vectors)))
    return sum(budget.each(_rank_of_block, [*_blocks(vectors)]))


def _rank_of_block(block: list[Vector], spend: Spend) -> int:
    size, rest = _eliminated(block, spend)
    return size + _dense_rank(rest, spend)


def _blocks(vectors: list[Vector]) -> Iterator[list[Vector]]:
    """The vectors, in groups of which no two have an entry at the same place."""
    having = _having(vectors)
    left = {k for k, vector in enumerate(vectors) if vector}
    while left:
        group = [left.pop()]
        for k in group:
            for place in vectors[k]:
                more = left.intersection(having.pop(place, ()))
                left -= more
                group += more
        yield [vectors[k] for k in sorted(group)]


def _having(vectors: list[Vector]) -> dict[int, set[int]]:
    """The vectors that have an entry at a place."""
    found = defaultdict[int, set[int]](set)
    for k, vector in enumerate(vectors):
        for place in vector:
            found[place].add(k)
    return found


def _eliminated(block: list[Vector], spend: Spend) -> tuple[int, list[Vector]]:
    """How many vectors eliminate a place, and those that are left when these are full."""
    left = [*map(dict, block)]
    having = _having(left)
    rarest = [(len(some), place) for place, some in having.items()]
    heapify(rarest)
    found, entries = 0, sum(map(len, left))
    while rarest:
        number, place = heappop(rarest)
        if number != len(having.get(place, ())):  # it stands there once more, as it is now
            continue
        if number > 1 and FULL * entries > (len(left) - found) * len(having):
            break
        shortest = min(having[place], key=lambda k: (len(left[k]), k))
        row, left[shortest], found = left[shortest], {}, found + 1
        over, entries = pow(row.pop(place), -1, PRIME), entries - len(row) - 1
        others = having.pop(place) - {shortest}
        spend(number * (1 + (len(row) >> 2)))
        for k in others:
            vector = left[k]
            entries -= len(vector)
            factor = vector.pop(place) * over % PRIME
            for m, value in row.items():
                vector[m] = (vector.get(m, 0) - factor * value) % PRIME
                (having[m].add if vector[m] else having[m].discard)(k)
                if not vector[m]:
                    del vector[m]
            entries += len(vector)
        for m in row:
            having[m].discard(shortest)
            if having[m]:
                heappush(rarest, (len(having[m]), m))
            else:
                del having[m]
    return found, [vector for vector in left if vector]


def _dense_rank(block: list[Vector], spend: Spend) -> int:
    """The rank of vectors as numbers, whose digits are the residues and what is added to them."""
    order = {m: k for k, m in enumerate(sorted({place for vector in block for place in vector}))}
    bits = 8 * (2 * PRIME.bit_length() + len(block).bit_length() + 8 >> 3)
    digit, size = (1 << bits) - 1, bits >> 3
    rows: dict[int, int] = {}

    def number(residues: list[int]) -> int:
        return int.from_bytes(b"".join(v.to_bytes(size, "little") for v in residues), "little")

    for vector in block:
        inside = sorted(((order[place], v) for place, v in vector.items()), key=itemgetter(0))
        start, residues = inside[0][0], [0] * (inside[-1][0] - inside[0][0] + 1)
        for k, value in inside:
            residues[k - start] = value
        rest = number(residues)
        for k in range(start, len(order)):
            first = (rest & digit) % PRIME
            rest >>= bits
            if first and k in rows:
                rest += first * rows[k]
                spend(1 + (len(order) - k >> 5))
            elif first:
                count = len(order) - k - 1
                spend(1 + count)
                text = rest.to_bytes(count * size, "little")
                parts = (text[j : j + size] for j in range(0, len(text), size))
                minus = -pow(first, -1, PRIME)
                rows[k] = number([int.from_bytes(v, "little") * minus % PRIME for v in parts])
                break
    return len(rows)
