"""The components of vectors that are printed as vectors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kowalevski_cas.notation import (
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    Vector,
    rank,
    to_latex,
)
from kowalevski_cas.notation.vocabulary import VECTOR
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.problem.space import EquationOfMotion, Let, Meaningless

ZERO = Number(0)
SPACE = 3
"""The components of a vector product, and of its factors."""


def parts(formula: Formula, setting: Meaning) -> tuple[Formula, ...]:
    """The components of a vector, or a scalar alone."""
    if rank(formula, setting.texts.vocabulary) != VECTOR:
        return (formula,)
    return tuple(component(formula, index, setting) for index in range(size(formula, setting)))


def size(vector: Formula, setting: Meaning) -> int:
    """The number of components of a vector; raises ``Meaningless`` if its parts differ in it."""
    match vector:
        case Vector(components):
            return len(components)
        case Name(name) if name in setting.scene.vectors:
            return len(setting.scene.vectors[name])
        case Name(name) if name in setting.scene.definitions:
            return size(setting.definition(name), setting)
    parts = (part for part in vector.children() if rank(part, setting.texts.vocabulary) == VECTOR)
    found = {size(part, setting) for part in parts} or {3}
    if len(found) > 1 or (isinstance(vector, CrossProduct) and found != {3}):
        numbers = " and ".join(map(str, sorted(found)))
        raise Meaningless(f"the vectors in {to_latex(vector)} have {numbers} components")
    return found.pop()


def sides(members: Sequence[Formula], setting: Meaning) -> list[Formula]:
    """The members of a chain, written out; a zero among vectors is one.

    Raises ``Meaningless`` for vectors that differ in the number of their components.
    """
    found = [setting.plain(member) for member in members]
    sizes = {len(parts(member, setting)) for member in found if member != ZERO} or {1}
    if len(sizes) > 1:
        raise Meaningless("vectors with different numbers of components are set equal")
    zero = ZERO if sizes == {1} else Vector((ZERO,) * sizes.pop())
    return [zero if member == ZERO else member for member in found]


def component(vector: Formula, index: int, setting: Meaning) -> Formula:
    """One component of a vector that is printed by its components or as a product."""

    def of(part: Formula, k: int) -> Formula:
        return component(part, k, setting)

    vocabulary = setting.texts.vocabulary
    match vector:
        case Vector(entries) | Diagonal(entries) if index < len(entries):
            return entries[index]
        case Name(name) if name in setting.scene.definitions:
            step = setting.step(name)
            assert isinstance(step, Let)
            return of(step.formula, index)
        case Name(name) if index < len(parts := setting.scene.vectors.get(name, ())):
            return Name(parts[index])
        case Negative() | Derivative():
            return vector.map_children(lambda argument: of(argument, index))
        case Sum(terms):
            return Sum(tuple(of(term, index) for term in terms))
        case Quotient(above, below):
            return Quotient(of(above, index), below)
        case Product(factors):
            vectors = (f if not rank(f, vocabulary) else of(f, index) for f in factors)
            return Product(tuple(vectors))
        case CrossProduct(left, right) if index < SPACE:
            j, k = (index + 1) % 3, (index + 2) % 3
            first = Product((of(left, j), of(right, k)))
            return Sum((first, Negative(Product((of(left, k), of(right, j))))))
    raise Meaningless(f"{to_latex(vector)} has no component {index + 1}")


def row_components(
    row: EquationOfMotion, setting: Meaning
) -> Iterator[tuple[str, Formula, Formula]]:
    """An equation of motion by components: name, factor of its rate, right side."""
    if len(row.names) == 1:
        yield row.names[0], row.factor, row.force
        return
    for index, name in enumerate(row.names):
        yield name, component(row.factor, index, setting), component(row.force, index, setting)
