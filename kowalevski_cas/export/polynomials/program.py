"""The program about one certificate, and how each kind of part is said in it."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from itertools import combinations_with_replacement

from kowalevski_cas.export.format import Json
from kowalevski_cas.export.polynomials.language import Language
from kowalevski_cas.export.polynomials.space import Space
from kowalevski_cas.export.polynomials.writer import Value, Writer
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import Tree


def program(language: Language, certificate: Json) -> str:
    """The text of the program about a certificate."""
    writer = Writer(language)
    writer.say(language.comment(f"{certificate['claim']}, certificate {certificate['digest']}"))
    spaces: list[Space] = []
    checker.Space.left = checker.WORK
    for k, data in enumerate(certificate["spaces"]):
        spaces.append(Space(writer, writer.fresh(f"s{k}"), data, tuple(spaces)))
    kinds: dict[str, Callable[..., None]] = {
        "follows": _follows, "rank": _rank, "differ": _differ,
    }  # fmt: skip
    for part in certificate["parts"]:
        options = {key: value for key, value in part.items() if key not in ("space", "shows")}
        kinds[part["shows"]](spaces[part["space"]], **options)
    return writer.text


def _follows(
    space: Space,
    equations: Tree,
    given: Tree = (),
    root: str | None = None,
    point: Json | None = None,
    **proof: Tree,
) -> None:
    """Targets are combinations of what is given, or are so in each of some cases."""
    targets, known = space.differences(equations), space.differences(given)
    if point is not None:
        space.point(given, **point)
    if root is not None:
        targets = _for_one_sign(space, root, targets, known)
    _settle(space, targets, known, **proof)


def _settle(
    space: Space,
    targets: list[Value],
    known: list[Value],
    cofactors: Tree = (),
    product: Tree = (),
    cases: Tree = (),
) -> None:
    """Combinations; in a product that vanishes, a factor does, alone or as a sum of squares."""
    groups = [[space.scalar(tree) for tree in group] for group in product]
    for group, case in zip(groups, cases, strict=True):
        _settle(space, targets, known + group, **case)
    if groups:
        squares = ([entry * entry for entry in group] for group in groups)
        sums = (reduce(Value.__add__, square) for square in squares)
        factors = (g[0] if len(g) == 1 else s for g, s in zip(groups, sums, strict=True))
        targets = [space.writer.named(reduce(Value.__mul__, factors))]
    for target, row in zip(targets, cofactors or [[]] * len(targets), strict=True):
        rest = target
        for tree, element in zip(row, known, strict=True):
            rest = rest - space.scalar(tree) * element
        space.vanishes("statement", rest)


def _for_one_sign(space: Space, root: str, targets: list[Value], known: list[Value]) -> list[Value]:
    """Products that vanish exactly if the targets do for one of the two signs of a root."""
    images = {name: space.generator(name) for name in space.checked.names}
    images[root] = space.number(0) - images[root]
    flip = space.carried(images, space)
    for element in known:
        space.vanishes("the sign is free", element - flip(element))
    return [a * flip(b) for a, b in combinations_with_replacement(targets, 2)]


def _rank(
    space: Space, levels: Tree, functions: Tree, given: Tree, point: Json, dimension: int | None
) -> None:
    """A minor of the matrix of derivatives at the point is not zero."""
    at, numbers = space.point(given, **point)
    chosen = [*map(space.scalar, [*levels, *functions]), *space.differences(given)]
    one = space.number(1)
    rows = [[at(space.along(f, {v: one})) for v in space.checked.variables] for f in chosen]
    columns = _independent([[value.element for value in row] for row in rows])
    minor = _determinant([[row[k].element for k in columns] for row in rows])
    text = space.writer.language.determinant([[row[k].text for k in columns] for row in rows])
    found = space.writer.named(Value(text, minor))
    numbers.vanishes("independent", found * numbers.inverse(found) - numbers.number(1))
    if dimension is not None:
        left = len(space.checked.variables) - len(chosen) - dimension
        numbers.vanishes("dimension", numbers.number(left))


def _independent(rows: list[list[checker.Element]]) -> list[int]:
    """Columns whose minor is not zero, found by elimination; ``Rejected`` if there are none."""
    columns = []
    while rows:
        row = rows.pop()
        k = next((k for k, entry in enumerate(row) if entry.terms), None)
        if k is None:
            raise checker.Rejected("the differentials are dependent")
        columns.append(k)
        over = row[k].inverse()
        rows = [[a - r[k] * over * b for a, b in zip(r, row, strict=True)] for r in rows]
    return sorted(columns)


def _determinant(rows: list[list[checker.Element]]) -> checker.Element:
    """By expansion along the first row."""
    first, *rest = rows
    if not rest:
        return first[0]
    terms = [
        (entry, _determinant([row[:k] + row[k + 1 :] for row in rest]), k)
        for k, entry in enumerate(first)
    ]
    space = first[0].space
    products = (space.number((-1) ** k) * entry * minor for entry, minor, k in terms)
    return sum(products, space.number(0))


def _differ(space: Space, equation: Tree, point: Json, given: Tree = ()) -> None:
    """The difference of the two sides at the point has an inverse."""
    at, numbers = space.point(given, **point)
    values = [at(difference) for difference in space.differences([equation])]
    value = next((value for value in values if value.element.terms), None)
    if value is None:
        raise checker.Rejected("the two sides are equal at the point")
    numbers.vanishes("the sides differ", value * numbers.inverse(value) - numbers.number(1))
