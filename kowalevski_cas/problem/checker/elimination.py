"""The rank of vectors modulo a prime.

A vector with an entry where no other has one counts, and is set aside, until there is none. What is
left falls into blocks that have no place in common. A block is eliminated vector by vector; where
its vectors fill up, each becomes one long number, in which all entries are subtracted at once.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from heapq import heapify, heappop, heappush
from operator import itemgetter

PRIME = 2**61 - 1

Vector = dict[int, int]  # residues that are not zero, by places
Spend = Callable[[int], None]


def rank(vectors: list[Vector], spend: Spend) -> int:
    """The rank; ``spend`` counts the steps."""
    spend(sum(map(len, vectors)))
    rest = _without_own(vectors)
    found = len(vectors) - len(rest)
    for block in _blocks(rest):
        by_vector = _sparse_rank(block, spend)
        found += _dense_rank(block, spend) if by_vector is None else by_vector
    return found


def _without_own(vectors: list[Vector]) -> list[Vector]:
    """The vectors that are left when those with an entry of their own are taken away in turn."""
    having = defaultdict[int, list[int]](list)
    for k, vector in enumerate(vectors):
        for place in vector:
            having[place].append(k)
    often = {place: len(some) for place, some in having.items()}
    left = dict(enumerate(vectors))
    alone = [place for place, number in often.items() if number == 1]
    while alone:
        if often[place := alone.pop()] == 1:
            for other in left.pop(next(k for k in having[place] if k in left)):
                often[other] -= 1
                if often[other] == 1:
                    alone.append(other)
    return [*left.values()]


def _blocks(vectors: list[Vector]) -> Iterator[list[Vector]]:
    """The vectors, in groups of which no two have an entry at the same place."""
    having = defaultdict[int, list[int]](list)
    for k, vector in enumerate(vectors):
        for place in vector:
            having[place].append(k)
    left = {k for k, vector in enumerate(vectors) if vector}
    while left:
        group = [left.pop()]
        for k in group:
            for place in vectors[k]:
                more = left.intersection(having.pop(place, ()))
                left -= more
                group += more
        yield [vectors[k] for k in sorted(group)]


def _sparse_rank(block: list[Vector], spend: Spend) -> int | None:
    """The rank, unless that is easier where vectors are full.

    What is eliminated by a vector is the entry at the place where fewest vectors have one.
    """
    often = Counter(place for vector in block for place in vector)
    rare = {place: (number, place) for place, number in often.items()}
    size = min(len(block), len(often))
    most = len(block) * len(often) * (1 + size // 200)  # about as long as in long numbers
    rows, at, work = list[list[tuple[int, int]]](), dict[int, int](), 0
    for vector in block:
        rest = dict(vector)
        waiting = [at[place] for place in rest if place in at]
        heapify(waiting)
        while waiting:  # a row has no entry where an earlier one has its first
            (pivot, _), *row = rows[heappop(waiting)]
            if not (factor := rest.pop(pivot, 0)):
                continue
            spend(1 + (len(row) >> 2))
            work += len(row) + 1
            for place, value in row:
                if place not in rest and place in at:
                    heappush(waiting, at[place])
                rest[place] = (rest.get(place, 0) - factor * value) % PRIME
                if not rest[place]:
                    del rest[place]
        if work > most:
            return None
        if rest:
            pivot = min(rest, key=rare.__getitem__)
            over, at[pivot] = pow(rest.pop(pivot), -1, PRIME), len(rows)
            rows.append([(pivot, 1), *((m, v * over % PRIME) for m, v in rest.items())])
    return len(rows)


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
