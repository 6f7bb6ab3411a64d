"""The differentials whose rank a goal is about."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

from kowalevski_cas.algebra.linear import determinant
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Rank


def functions_for_differentials(goal: Rank, at: Evaluation) -> list[Element]:
    """The functions, and left minus right sides of equations, whose differentials are meant."""
    return [*map(at.scalar, goal.functions), *at.differences(goal.given)]


def differentials(functions: Iterable[Element], at: Evaluation) -> list[list[Element]]:
    """The partial derivatives of functions by all variables, a row each."""
    return [[at.partial(f, name) for name in at.setting.variables] for f in functions]


def minors(rows: list[list[Element]]) -> list[Element]:
    """The minors of all columns, so many at a time as there are rows."""
    columns = combinations(range(len(rows[0])), len(rows)) if rows else [()]
    return [determinant([[row[k] for k in column] for row in rows]) for column in columns]
