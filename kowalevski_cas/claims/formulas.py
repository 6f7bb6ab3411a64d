"""Printed formulas as elements of a stage, and elements as formulas."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kowalevski_cas.arithmetic.present import formula_of
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.notation import (
    Constant,
    Formula,
    Negative,
    Number,
    Product,
    Relation,
    Sum,
    Vector,
)
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.stage.evaluate import Triple, Value
from kowalevski_cas.paper.texts import Printed


def members(relation: Relation) -> list[Formula]:
    """The members of a chain of equalities that are formulas, not the word ``const``."""
    return [member for member in relation.members if not isinstance(member, Constant)]


def components(value: Value) -> tuple[Element, ...]:
    """A scalar or a vector as a tuple of scalars."""
    return tuple(value) if isinstance(value, Triple) else (value,)


def differences(left: Value, right: Value) -> list[Element]:
    """The components of the difference of two scalars or of two vectors."""
    pairs = zip(components(left), components(right), strict=True)
    return [a - b for a, b in pairs]


def equation(printed: Printed, stage: Stage) -> Element:
    """The left side minus the right side of a printed equation, which has these two only."""
    relation = stage.relation(printed)
    if len(relation.members) != 2 or r"\ne" in relation.signs:
        raise StageError(f"an equation with two sides is expected at {printed.place}")
    left, right = relation.members
    return scalar(left, stage) - scalar(right, stage)


def equations(places: Sequence[Printed], stage: Stage) -> list[Element]:
    """The left sides minus the right sides of printed equations."""
    return [equation(printed, stage) for printed in places]


def show(element: Element, stage: Stage) -> Formula:
    """An element in the names of its stage."""
    return formula_of(element, stage.texts.vocabulary)


def scaled(coefficient: Formula, *factors: Formula) -> Formula:
    """A coefficient times factors; a one is not shown, and a sign stands before all."""
    if isinstance(coefficient, Negative):
        return Negative(scaled(coefficient.argument, *factors))
    if coefficient != Number(1):
        own = coefficient.factors if isinstance(coefficient, Product) else (coefficient,)
        factors = (*own, *factors)
    return Product(factors) if len(factors) > 1 else next(iter(factors), Number(1))


def total(terms: Sequence[Formula]) -> Formula:
    """The sum of any number of terms."""
    return Sum(tuple(terms)) if len(terms) > 1 else next(iter(terms), Number(0))


def combined(
    coefficients: Iterable[Element], products: Iterable[tuple[Formula, ...]], stage: Stage
) -> Formula:
    """Products with coefficients, summed; what is zero is left out."""
    pairs = zip(coefficients, products, strict=True)
    return total([scaled(show(c, stage), *factors) for c, factors in pairs if not c.is_zero])


def equal(left: Formula, right: Formula) -> Relation:
    """An equation."""
    return Relation((left, right), ("=",))


def matrix_formula(rows: Iterable[Iterable[Formula]]) -> Vector:
    """A matrix by its rows."""
    return Vector(tuple(Vector(tuple(row)) for row in rows))
