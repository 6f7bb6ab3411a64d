"""The differentials whose rank a goal is about."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations

from kowalevski_cas.algebra.linear import determinant
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Name
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Follows, Rank
from kowalevski_cas.problem.space import Equation


def functions_for_differentials(goal: Rank, at: Evaluation) -> list[Element]:
    """The functions, and left minus right sides of equations, whose differentials are meant."""
    return [*map(at.scalar, goal.functions), *at.differences(goal.given)]


def differentials(functions: Iterable[Element], at: Evaluation) -> list[list[Element]]:
    """The partial derivatives of functions by all variables, a row each."""
    return [[at.partial(f, name) for name in at.setting.variables] for f in functions]


def minors(rows: list[list[Element]]) -> list[Element]:
    """The minors of all columns, so many at a time as there are rows."""
    columns = combinations(range(len(rows[0])), len(rows)) if rows else [()]
    return [determinant([[row[k] for k in chosen] for row in rows]) for chosen in columns]


def multipliers(goal: Follows) -> list[str]:
    """The names that should vanish by the conclusions."""
    return [
        left.name
        for conclusion in goal.conclusions
        for left, _ in conclusion
        if isinstance(left, Name)
    ]


def factors_of_multipliers(goal: Follows, at: Evaluation) -> list[list[Element]]:
    """What each of the multipliers has as its factors in the equations that are given."""
    names = multipliers(goal)
    combinations = at.differences([equation for equation in goal.given if has(equation, names)])
    return [[at.partial(e, name) for e in combinations] for name in names]


def has(equation: Equation, names: Sequence[str]) -> bool:
    """Whether one of some names stands in an equation."""
    return any(side.names() & {*names} for side in equation)
