"""Statements about an exact point, which Rocq decides by computing."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from kowalevski_cas.export.format import Inexpressible, Json
from kowalevski_cas.export.rocq.space import Element, Sides, Space
from kowalevski_cas.proof import checker

Statements = tuple[str, list[str]]
"""The coordinates of a point, and what is computed there."""


def given(space: Space, part: Json) -> Statements:
    """There is a point of the space where the given equations hold."""
    point, _, _ = _point(space, part)
    return point, [*_admissible(space), *_hold(space.sides(part.get("given", [])))]


def differ(space: Space, part: Json) -> Statements:
    """There is a point, perhaps one where given equations hold, where an equation fails."""
    point, statements = given(space, part)
    equal = [_equal(sides) for sides in space.sides([part["equation"]])]
    while len(equal) > 1:
        equal = [f"andb ({equal[0]}) ({equal[1]})", *equal[2:]]
    return point, [*statements, f"{equal[0]} = false"]


def rank(space: Space, part: Json) -> Statements:
    """There is a point where a minor of the matrix of partial derivatives is not zero."""
    point, statements = given(space, part)
    _, images, numbers = _point(space, part)
    trees = [*part["levels"], *part["functions"], *(["+", a, ["-", b]] for a, b in part["given"])]
    partials = "; ".join(space.partial(name) for name in space.data["variables"])
    space.define("partials", f"[{partials}]", "list (expr -> expr)")
    functions = [component for tree in trees for component in space.parts(tree)]
    one = space.checked.number(1)
    matrix = [
        [value.along({name: one}).image(images, numbers) for name in space.data["variables"]]
        for tree in trees
        for value in space.checked.value(tree)
    ]
    rows = [f"map (fun d => at_point p (d ({f}))) partials" for f in functions]
    columns = "; ".join(map(str, sorted(_pivots(matrix))))
    return point, [
        *statements,
        f"vanishes (minor [{'; '.join(rows)}] [{columns}]%nat) = false",
    ]


def _pivots(rows: list[list[Element]]) -> list[int]:
    """Columns in which the rows are independent."""
    found = []
    while rows:
        row = rows.pop()
        k = next(k for k, entry in enumerate(row) if entry.terms)
        over = row[k].inverse()
        rows = [[a - r[k] * over * b for a, b in zip(r, row, strict=True)] for r in rows]
        found.append(k)
    return found


def _admissible(space: Space) -> list[str]:
    """The point obeys the relations and conditions of the space, and what is real is so there."""
    squares = [(f"{a} * {a}", b) for a, b in space.sides(space.squares.items())]
    nonzero = [f"vanishes (at_point p ({space.say(t)})) = false" for t in space.checked.nonzero]
    names = [space.term(name) for name in space.names]
    real = [f"equal (at_point p (conjugate {n})) (gbar (at_point p {n})) = true" for n in names]
    return [*_hold(squares), *nonzero, *real]


def _hold(pairs: Sequence[Sides]) -> list[str]:
    return [f"{_equal(sides)} = true" for sides in pairs]


def _equal(sides: Sides) -> str:
    return f"equal (at_point p ({sides[0]})) (at_point p ({sides[1]}))"


def _point(space: Space, part: Json) -> tuple[str, checker.Elements, checker.Space]:
    """The coordinates of a point, also as the checker has them."""
    if part["point"]["roots"]:
        raise Inexpressible("a point has coordinates that are no Gaussian rational numbers")
    images, numbers = space.checked.point([], **part["point"])
    coordinates = []
    for name in space.names:
        value = images[name]
        both = (value.terms.get(m, 0) for m in (0, numbers.unit["i"]))
        real, imaginary = (Fraction(part, value.below) for part in both)
        shown = (f"{z.numerator} # {z.denominator}" for z in (real, imaginary))
        coordinates.append(f"({', '.join(shown)})")
    return f"[{'; '.join(coordinates)}]%Q", images, numbers
