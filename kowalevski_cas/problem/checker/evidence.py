"""What evidence is made of: real points, combinations, sums of squares, proofs by cases."""

from __future__ import annotations

from itertools import combinations
from math import isqrt, prod

from .formulas import Map, rational
from .polynomials import Element, Ring
from .reading import (
    BITS,
    Json,
    Rejected,
    exponent,
    integer,
    items,
    label,
    need,
    operation,
    pairs,
    record,
)
from .spaces import Space

# -- points ------------------------------------------------------------------------


def numbers_of(space: Space, points: list[Json]) -> Space:
    """The numbers in which points are given: i and square roots of positive integers."""
    lists = [items(record(point, "roots values")["roots"]) for point in points]
    roots = {integer(d, 2, 10**12) for roots in lists for d in roots}
    squares = {"i": ["-", 1], **{f"\\sqrt{{{d}}}": d for d in sorted(roots)}}
    steps = [["root", name, tree] for name, tree in squares.items()]
    return type(space)({"variables": [], "steps": steps}, [], space.ring.another())


def locate(space: Space, data: Json, given: list[Element], numbers: Space | None = None) -> Map:
    """A real point of the setting, where elements vanish and no known divisor does."""
    numbers = numbers or numbers_of(space, [data])
    values = {label(name): numbers.scalar(tree) for name, tree in pairs(data["values"])}
    whole = values.keys() == space.bar.keys() and len(values) == len(data["values"])
    need(whole, "a value of the point is missing, or unknown, or given twice")
    at = numbers.carried(space.ring, values)
    for name, conjugate in space.bar.items():
        real = (at(conjugate) - numbers.conj(at.images[name])).vanishes()
        need(real, f"{name} is not real there")
        if name.startswith("\\sqrt") and conjugate.is_generator(name):
            need(not is_negative(at.images[name]), f"{name} is negative there")
    need(all(at(e).vanishes() for e in given), "the point is not where it should be")
    need(all(at(e).differs() for e in space.granted), "a condition fails before the change")
    for name, words in space.known.items():
        known = at(space.ring.divisors[name]).differs()
        need(known, f"a condition fails at the point: {words:.200}")
    return at


def on_each_piece(at: Map, given: list[Element]) -> Map:
    """The values at a point, with the roots left open that do not stand in what is given.

    Each piece of the space has a point with the same values of all else, where each root has one of
    its signs. So what differs from zero whatever they are is zero on none of the pieces.
    """
    ring, numbers = at.ring, at.space
    bases = [base for base, _ in ring.powers.values()]
    fixed = {name for element in [*given, *bases] for name in element.generators()}
    for name in reversed(ring.roots):
        fixed |= {*ring.roots[name].generators()} if name in fixed else set()
    others = {*ring.roots, *ring.divisors, *ring.powers}
    pieces = numbers.carried(ring, {n: e for n, e in at.images.items() if n not in others})
    for name in (n for n in ring.roots if n in at.images):
        square = pieces(ring.roots[name])
        if name in fixed or not square.terms or square.value() == -1:
            pieces.images[name] = at.images[name]
        else:
            pieces.images[name] = numbers.ring.adjoin(f":{name}")
            numbers.ring.relate(f":{name}", square)
    pieces.images |= {name: at.images[name] for name in ring.powers}
    return pieces


def is_negative(number: Element) -> bool:
    """Whether a number is negative, or may be; its roots are the positive ones."""
    ring, low = number.ring, 0
    squares = {name: ring.roots[name].value() or 0 for name in number.generators()}
    if not number.terms or min(squares.values(), default=1) < 1:
        return bool(number.terms)
    ring.spend(len(number.terms) << 4)
    for m, c in number.terms.items():
        square = prod(squares[name].numerator for name, _ in ring.exponents(m))
        root = isqrt(c * c * square << 2 * BITS)  # rounded off; that of a square is exact
        low += root if c > 0 else -root - (root * root < c * c * square << 2 * BITS)
    return low < 0


# -- proofs ------------------------------------------------------------------------

PROOF = "product cofactors cases power equal"
LARGEST_POWER = 16


def is_combination(space: Space, goal: Element, row: Json, known: list[Element]) -> bool:
    """Whether a goal is the combination of known elements that a row of formulas gives."""
    need(len(items(row)) in (0, len(known)), "a row has another length")
    parts = (space.scalar(tree) * e for tree, e in zip(row, known, strict=False))
    return (goal - space.ring.total(parts)).vanishes()


def squares_of(space: Space, data: Json) -> Element:
    """A sum of squares of real elements, with positive numbers."""
    found = list[Element]()
    for tree, base in pairs(data):
        number, element = rational(space, tree), space.scalar(base)
        need(number > 0, "a square is taken away")
        need(space.is_real(element), "a square is one of what is not real")
        found.append(space.ring.number(number) * element * element)
    return space.ring.total(found)


def difference(space: Space, left: Json, right: Json) -> Element:
    """What vanishes since both sides have one square, and neither is negative."""
    signs = space.all_real() and is_not_negative(space, left) and is_not_negative(space, right)
    need(signs, "what has the same square may have another sign")
    a, b = space.scalar(left), space.scalar(right)
    need((a * a - b * b).vanishes(), "the squares are not equal")
    return a - b


def is_not_negative(space: Space, tree: Json) -> bool:
    """Whether a formula of real names is made of printed roots, even powers and numbers only."""
    if type(tree) is str:
        return tree.startswith("\\sqrt") and tree in space.ring.roots
    if type(tree) is int:
        return tree >= 0
    op, parts = operation(tree)
    if op == "^" and exponent(parts[1]) % 2 == 0:
        return True
    return op in ("+", "*", "/", "^") and all(is_not_negative(space, part) for part in parts)


def settle(space: Space, goals: list[Element], known: list[Element], proof: Json) -> None:
    """Goals vanish where known elements do: as combinations, or in all cases of a product."""
    record(proof, "", PROOF)
    known = known + [difference(space, *sides) for sides in pairs(proof.get("equal", []))]
    need(("product" in proof) == ("cases" in proof), "cases belong to a product")
    if "product" in proof:
        groups = [[*map(space.scalar, items(group))] for group in items(proof["product"])]
        need(groups and all(groups), "a product is empty")
        squares = any(group[1:] for group in groups)
        need(not squares or space.all_real(), "sums of squares are for real names")
        for group, case in zip(groups, items(proof["cases"], len(groups)), strict=True):
            settle(space, goals, known + group, case)
        whole = space.ring.number(1)
        for group in groups:
            whole = whole * (space.ring.total(e * e for e in group) if group[1:] else group[0])
        goals = [whole]
    power = integer(proof.get("power", 1), 1, LARGEST_POWER)
    rows = items(proof["cofactors"], len(goals)) if "cofactors" in proof else [[]] * len(goals)
    for goal, row in zip(goals, rows, strict=True):
        need(is_combination(space, goal**power, row, known), "the two sides are not equal")


# -- matrices ----------------------------------------------------------------------


def minors(ring: Ring, matrix: list[list[Element]]) -> list[Element]:
    """The maximal minors of a matrix with no more rows than columns, column by column."""
    found: dict[tuple[int, ...], Element] = {(): ring.number(1)}
    width = len(matrix[0])
    for size, row in enumerate(matrix, 1):
        smaller, found = found, {}
        for columns in combinations(range(width), size):
            parts = list[Element]()
            for k, column in enumerate(columns):
                part = row[column] * smaller[columns[:k] + columns[k + 1 :]]
                parts.append(-part if (size - k) % 2 == 0 else part)
            found[columns] = ring.total(parts)
    return [*found.values()]


def independent(at: Map, matrix: list[list[Element]]) -> None:
    """The rows of a matrix are certainly independent at a point."""
    rows = [[at(e) for e in row] for row in matrix]
    while rows:
        row = rows.pop()
        k = next((k for k, e in enumerate(row) if e.differs()), None)
        if k is None:
            raise Rejected("the differentials may depend on each other")
        over = at.space.inverse(row[k])
        rows = [[a - r[k] * over * b for a, b in zip(r, row, strict=True)] for r in rows]
