"""What a proposal has to say: a statement that is true by itself corrects nothing."""

from __future__ import annotations

from kowalevski_cas.notation import (
    Edit,
    Formula,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    subtree,
)
from kowalevski_cas.notation.errors import closeness
from kowalevski_cas.paper.claims import Neighbour
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import simple
from kowalevski_cas.verify.statement import Statement

ALIKE = 2.5
"""From what closeness on a name is easily taken for another one."""


def unlike(edit: Edit) -> bool:
    """Whether an edit puts a name in the place of one that neither looks nor sounds like it."""
    old, new = subtree(edit.statement.formula, edit.path), edit.replacement
    if not isinstance(old, Name) or not isinstance(new, Name):
        return False
    return closeness(old.name, new.name) < ALIKE


def says_something(neighbour: Neighbour, statement: Statement, printed: Statement) -> bool:
    """Whether a true neighbour is a statement about what is printed, and not true of itself.

    It involves variables if the print does, and the function that the print is about; no equation
    that it supposes vanishes identically; its sides are not the same and have no function as a
    common factor that they do not have in print.
    """
    if _moves(printed) and not _moves(statement):
        return False
    if _empty(statement) > _empty(printed):
        return False
    edit = neighbour.edit
    if edit is None:
        return True
    defined = set(neighbour.claim.scene.definitions)
    before, after = edit.statement.formula, edit.formula
    replaced = (before.names() - after.names()) & defined
    if replaced and unlike(edit) and not edit.replacement.names() & defined:
        return False
    return not _trivial(after) and not (_common(after) - _common(before)) & defined


def _moves(statement: Statement) -> bool:
    """Whether variables are reached from a statement."""
    return any(space.variables for space in statement.legend)


def _empty(statement: Statement) -> int:
    """How many of the equations that are supposed hold everywhere."""
    simple_ones = (one for goal in statement.goals for one in simple(goal))
    given = ((one.space, getattr(one, "given", ())) for one in simple_ones)
    return sum(d.is_zero for space, some in given for d in finder_of(space).differences(some))


def _trivial(formula: Formula) -> bool:
    """Whether two sides, or both arguments of a bracket, are literally the same."""
    paired = (one for one in formula.nodes() if isinstance(one, Relation | PoissonBracket))
    return any(len({*one.children()}) < len(one.children()) for one in paired)


def _common(formula: Formula) -> set[str]:
    """The names that are factors of all sides, or terms, but zeros."""
    match formula:
        case Name(name):
            return {name}
        case Number(0):
            return set()
        case Product():
            return set().union(*map(_common, formula.factors))
        case Negative() | Power():
            return _common(formula.children()[0])
        case Relation() | Sum():
            parts = [_common(one) for one in formula.children() if one != Number(0)]
            return set.intersection(*parts) if parts else set()
        case Quotient():
            return _common(formula.numerator)
    return set()
