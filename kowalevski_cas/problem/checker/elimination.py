"""The rank of vectors modulo a prime.

The vectors fall into blocks that have no place in common. In a block the place where fewest vectors
have an entry is eliminated next, by the shortest of these vectors. Where the rest fills up, each
vector becomes one long number, in which all entries are subtracted at once.
"""

from __future__ import annotations

from collections import defaultdict
from heapq import heapify, heappop, heappush
from operator import itemgetter

from .reading import Budget, Spend

PRIME = 2**61 - 1
RARE = 2  # of a place that so many vectors have it is told when it becomes rarer
FULL = 4  # vectors are full where one entry in so many is not zero

Vector = dict[int, int]  # residues that are not zero, by places


def rank(vectors: list[Vector], budget: Budget) -> int:
    """The rank; its steps are taken from the budget."""
    budget.spend(sum(map(len, vectors)))
    return sum(budget.each(_rank_of_block, _blocks(vectors)))


def _rank_of_block(block: list[Vector], spend: Spend) -> int:
    size, rest = _eliminated(block, spend)
    return size + _dense_rank(rest, spend)


def _blocks(vectors: list[Vector]) -> list[list[Vector]]:
    """The vectors, in groups of which no two have an entry at the same place."""
    above = [*range(len(vectors))]  # in a tree for each group, with its first vector on top
    first: dict[int, int] = {}
    for k, vector in enumerate(vectors):
        top = k
        for place in vector:
            if (other := first.setdefault(place, top)) != top:
                while above[other] != other:
                    above[other] = other = above[above[other]]
                above[max(top, other)] = top = min(top, other)
    groups = defaultdict[int, list[Vector]](list)
    for k, vector in enumerate(vectors):
        above[k] = top = above[above[k]]  # the tops of those before are known
        if vector:
            groups[top].append(vector)
    return [*groups.values()]


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
        if number != (now := len(having.get(place, ()))):
            if now:
                heappush(rarest, (now, place))
            continue
        if number > 1 and FULL * entries > (len(left) - found) * len(having):
            break
        some = having.pop(place)
        shortest = min(some, key=lambda k: (len(left[k]), k)) if number > 1 else some.pop()
        row, left[shortest], found = left[shortest], {}, found + 1
        entries -= len(row)
        value = row.pop(place)
        some.discard(shortest)
        spend(number * (1 + (len(row) >> 2)))
        if some:
            over = pow(value, -1, PRIME)
            for k in some:
                vector = left[k]
                entries -= len(vector)
                _subtract(vector, vector.pop(place) * over % PRIME, row, having, k)
                entries += len(vector)
        for m in row:
            having[m].discard(shortest)
            if not (now := len(having[m])):
                del having[m]
            elif now <= RARE:
                heappush(rarest, (now, m))
    return found, [vector for vector in left if vector]


def _subtract(
    vector: Vector, factor: int, row: Vector, having: dict[int, set[int]], number: int
) -> None:
    """Subtract a multiple of a row from the vector with a number."""
    for place, value in row.items():
        if (old := vector.get(place)) is None:
            vector[place] = -factor * value % PRIME
            having[place].add(number)
        elif new := (old - factor * value) % PRIME:
            vector[place] = new
        else:
            del vector[place]
            having[place].discard(number)


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
