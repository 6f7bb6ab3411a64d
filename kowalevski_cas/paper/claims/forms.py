"""What kinds of claims state alike, in formulas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

from kowalevski_cas.notation import (
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Quotient,
    Relation,
    Sum,
)
from kowalevski_cas.paper.components import parts, sides
from kowalevski_cas.paper.differentiate import derivative
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.generators import values_at_zero
from kowalevski_cas.paper.matrices import Rows, as_matrices, is_matrix, sizes
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import Equation, Meaningless
from kowalevski_cas.problem.trees import MARK

ZERO, ONE = Number(0), Number(1)


def rate(formula: Formula) -> Formula:
    """The derivative along the field."""
    return Derivative(formula, MARK)


def vanishes(formula: Formula) -> Equation:
    """The equation that a formula is zero."""
    return formula, ZERO


def minus(equation: Equation) -> Formula:
    """The left minus the right side."""
    left, right = equation
    return left if right == ZERO else Sum((left, Negative(right)))


def members(relation: Relation) -> list[Formula]:
    """The members of a chain of equalities that are formulas, not the word ``const``."""
    return [member for member in relation.members if not isinstance(member, Constant)]


def chain(on: Elaborations, space: Elaboration, printed: Printed) -> list[Equation]:
    """The equations of a printed chain; ``= const`` says that the first member does not move.

    Matrices are equal entry by entry; a zero may stand for one.
    """
    relation = on.texts.relation(printed)
    if are_matrices(relation, space):
        return [*entries(as_matrices(relation.members, space, are_equal=True))]
    found = sides(members(relation), space)
    equations = list(pairwise(found))
    if isinstance(relation.members[-1], Constant):
        equations.append(vanishes(rate(found[0])))
    return equations


def are_matrices(relation: Relation, space: Elaboration) -> bool:
    """Whether matrices are said to be equal."""
    return any(is_matrix(member, space) for member in relation.members)


def entries(matrices: Sequence[Rows]) -> Iterator[Equation]:
    """The equations between the entries of matrices that are equal."""
    for left, right in pairwise(matrices):
        if sizes(left) != sizes(right):
            raise Meaningless("the matrices differ in size")
        for a, b in zip(left, right, strict=True):
            yield from zip(a, b, strict=True)


def equation(on: Elaborations, space: Elaboration, printed: Printed) -> Equation:
    """Both sides of a printed equation, which has these two only."""
    relation = on.texts.relation(printed)
    if len(relation.members) != 2:
        raise Meaningless(f"an equation with two sides is expected at {printed.place}")
    left, right = sides(relation.members, space)
    return left, right


def equations(
    on: Elaborations, space: Elaboration, places: Sequence[Printed]
) -> tuple[Equation, ...]:
    """The sides of printed equations, component by component; of a chain, those of each sign."""
    return _equations(map(on.texts.relation, places), space)


def supposed(
    on: Elaborations, space: Elaboration, places: Sequence[Printed]
) -> tuple[Equation, ...]:
    """The equations that hold where printed ones do; at a point ``= const`` says nothing."""
    relations = map(on.texts.relation, places)
    chains = ((members(one), one.signs) for one in relations)
    return _equations([Relation((*kept,), signs[: len(kept) - 1]) for kept, signs in chains], space)


def _equations(relations: Iterable[Relation], space: Elaboration) -> tuple[Equation, ...]:
    found: list[Equation] = []
    for relation in relations:
        if are_matrices(relation, space):
            found += entries(as_matrices(relation.members, space, are_equal=True))
            continue
        for left, right in pairwise(sides(relation.members, space)):
            found += zip(parts(left, space), parts(right, space), strict=True)
    return (*found, *values_at_zero(found, space))


def expression(on: Elaborations, space: Elaboration, printed: Printed) -> Formula:
    """A printed formula that is no equation."""
    formula = on.texts.formula(printed)
    if isinstance(formula, Relation):
        raise Meaningless(f"an expression is expected at {printed.place}")
    return space.plain(formula)


def function(on: Elaborations, space: Elaboration, printed: Printed) -> Formula:
    """A printed function, or the name that is defined there; no other equation is one."""
    formula = on.texts.formula(printed)
    if not isinstance(formula, Relation):
        return formula
    if printed not in space.scene.definitions.values():
        raise Meaningless(f"a function is expected at {printed.place}, not an equation")
    return members(formula)[0]


def first_member(on: Elaborations, space: Elaboration, printed: Printed) -> Formula:
    """The first member of a printed chain, or the expression that is printed."""
    formula = on.texts.formula(printed)
    return space.plain(members(formula)[0] if isinstance(formula, Relation) else formula)


def moving(space: Elaboration, formula: Formula) -> list[str]:
    """The variables that stand in a formula, and in what it is defined by.

    Of an angle that stands by itself as well these are no functions: it is derived by the angle.
    """
    reach = Reach(space)
    reach.formula(formula)
    functions = space.transcendental.functions_beside
    names = {functions.get(name, name) for name in reach.names}
    return [name for name in space.variables if name in names and name not in functions]


def slope(space: Elaboration, formula: Formula, name: str) -> Formula:
    """The derivative of a formula by a variable, on which the functions of this rest."""
    return space.partial(_with_rates(space, formula), name)


def _with_rates(space: Elaboration, formula: Formula) -> Formula:
    """A formula with what the equations of motion say in the place of rates, as far as is known.

    Where no function stands beside its argument, whoever derives knows the rates.
    """
    if not space.transcendental.functions_beside:
        return formula
    known = {
        row.names[0]: row.force if row.factor == Number(1) else Quotient(row.force, row.factor)
        for row in space.field
        if len(row.names) == 1
    }

    def put(part: Formula) -> Formula:
        inner = part.map_children(put)
        if isinstance(inner, Derivative):
            reach = Reach(space)
            reach.formula(inner.argument)
            if {*space.variables} & reach.names <= known.keys():
                return derivative(inner.argument, known, space.step)
        return inner

    return put(formula)


def matrix(letter: str, size: int) -> Rows:
    """A square matrix of names, ``M_{11}``, ``M_{12}`` and so on."""
    places = range(1, size + 1)
    return tuple(tuple(Name(f"{letter}_{{{i}{j}}}") for j in places) for i in places)


def names_in(rows: Rows) -> tuple[str, ...]:
    """The names of a matrix of names."""
    return tuple(entry.name for row in rows for entry in row if isinstance(entry, Name))
