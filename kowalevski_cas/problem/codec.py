"""Problems as JSON, and back: what the digest of a statement is made of (docs/certificate.md)."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from hashlib import sha256
from typing import Any

from kowalevski_cas.problem.goals import (
    Count,
    Exists,
    Fails,
    Follows,
    Goal,
    Kernel,
    Positive,
    Problem,
    Rank,
    Simple,
    simple,
)
from kowalevski_cas.problem.space import (
    Adjoined,
    Change,
    Equation,
    Let,
    Motion,
    Raised,
    Space,
    Step,
)
from kowalevski_cas.problem.trees import FormatError, Tree, decode, encode

Data = dict[str, Any]


def problem_data(problem: Problem) -> Data:
    """The spaces and goals of a problem."""
    spaces: list[Space] = []

    def place(space: Space) -> int:
        if space not in spaces:
            if space.change is not None:
                assert isinstance(space.change.old, Space)
                place(space.change.old)
            spaces.append(space)
        return spaces.index(space)

    for goal in problem.goals:
        for one in simple(goal):
            assert isinstance(one.space, Space)
            place(one.space)
    return {
        "spaces": [_space_data(space, place) for space in spaces],
        "goals": [_goal_data(goal, place) for goal in problem.goals],
    }


def digest(problem: Problem) -> str:
    """The digest of a statement: any change of its mathematics changes it."""
    return digest_of(problem_data(problem))


def digest_of(data: Data) -> str:
    """The digest of the spaces and goals in the data of a certificate."""
    text = json.dumps({key: data[key] for key in ("spaces", "goals")}, sort_keys=True)
    return sha256(text.encode()).hexdigest()[:16]


def _space_data(space: Space, place: Callable[[Space], int]) -> Data:
    data: Data = {"variables": list(space.variables)}
    if space.constants:
        data["constants"] = list(space.constants)
    if space.nonzero:
        data["nonzero"] = [encode(formula) for formula in space.nonzero]
    if space.steps:
        data["steps"] = [_step_data(step) for step in space.steps]
    if space.field:
        data["field"] = [
            [list(row.names), encode(row.factor), encode(row.force)] for row in space.field
        ]
    if (change := space.change) is not None:
        assert isinstance(change.old, Space)
        data["change"] = {
            "old": place(change.old),
            "formulas": [[name, encode(formula)] for name, formula in change.formulas],
            "time": encode(change.time),
        }
    if space.conjugates:
        data["conjugates"] = [list(pair) for pair in space.conjugates]
    return data


def _step_data(step: Step) -> Tree:
    match step:
        case Let(name, formula):
            return ["let", name, encode(formula)]
        case Adjoined(name, square, None):
            return ["root", name, encode(square)]
        case Adjoined(name, square, printed):
            assert printed is not None
            return ["root", name, encode(square), _sides(printed)]
        case Raised(name, base, exponent):
            return ["power", name, encode(base), exponent]


def _goal_data(goal: Goal, place: Callable[[Space], int]) -> Data:
    match goal:
        case Exists():
            inner = [_goal_data(one, place) for one in goal.goals]
            names = {"numbers": list(goal.numbers), "expressions": list(goal.expressions)}
            return {"goal": "exists", **names, "goals": inner}
        case Follows():
            kind = "fails" if isinstance(goal, Fails) else "follows"
            content: Data = {
                "given": list(map(_sides, goal.given)),
                "conclusions": [list(map(_sides, one)) for one in goal.conclusions],
            }
        case Rank():
            kind = "rank"
            content = {
                "functions": list(map(encode, goal.functions)),
                "given": list(map(_sides, goal.given)),
                "rank": goal.rank,
            }
        case Positive():
            kind = "positive"
            content = {"given": list(map(_sides, goal.given)), "formula": encode(goal.formula)}
        case Count():
            kind = "count"
            content = {
                "equations": list(map(_sides, goal.equations)),
                "names": list(goal.names),
                "number": goal.number,
            }
        case Kernel():
            kind = "kernel"
            content = {
                "factor": encode(goal.factor),
                "solutions": list(map(encode, goal.solutions)),
                "integrals": list(map(encode, goal.integrals)),
                "weights": list(goal.weights),
                "degree": goal.degree,
            }
    assert isinstance(goal.space, Space)
    return {"goal": kind, "space": place(goal.space), **content}


def _sides(equation: Equation) -> Tree:
    return [encode(side) for side in equation]


def read_problem(data: Data) -> Problem:
    """The problem in the data of a certificate; raises :class:`FormatError` if there is none."""
    try:
        spaces: list[Space] = []
        for space in data["spaces"]:
            spaces.append(_read_space(space, spaces))
        return Problem(tuple(_read_goal(goal, spaces) for goal in data["goals"]))
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise FormatError(f"it states nothing that can be read: {error}") from None


def _read_space(data: Data, before: Sequence[Space]) -> Space:
    change = data.get("change")
    return Space(
        variables=tuple(data["variables"]),
        constants=tuple(data.get("constants", ())),
        nonzero=tuple(map(decode, data.get("nonzero", ()))),
        steps=tuple(map(_read_step, data.get("steps", ()))),
        field=tuple(
            Motion(tuple(names), decode(factor), decode(force))
            for names, factor, force in data.get("field", ())
        ),
        change=None
        if change is None
        else Change(
            before[change["old"]],
            tuple((name, decode(tree)) for name, tree in change["formulas"]),
            decode(change["time"]),
        ),
        conjugates=tuple((a, b) for a, b in data.get("conjugates", ())),
    )


def _read_step(data: Tree) -> Step:
    match data:
        case ["let", name, tree]:
            return Let(name, decode(tree))
        case ["root", name, square]:
            return Adjoined(name, decode(square))
        case ["root", name, square, printed]:
            return Adjoined(name, decode(square), _equation(printed))
        case ["power", name, base, exponent]:
            return Raised(name, decode(base), exponent)
    raise FormatError("a step is expected")


def _read_goal(data: Data, spaces: Sequence[Space]) -> Goal:
    if data["goal"] == "exists":
        inner = (_read_goal(goal, spaces) for goal in data["goals"])
        goals: tuple[Simple, ...] = tuple(g for g in inner if not isinstance(g, Exists))
        return Exists(goals, tuple(data["expressions"]), tuple(data["numbers"]))
    space, kind = spaces[data["space"]], data["goal"]
    if kind in ("follows", "fails"):
        make = Fails if kind == "fails" else Follows
        conclusions = tuple(tuple(map(_equation, one)) for one in data["conclusions"])
        return make(space, conclusions, tuple(map(_equation, data["given"])))
    if kind == "rank":
        functions, given = map(decode, data["functions"]), map(_equation, data["given"])
        return Rank(space, tuple(functions), tuple(given), data["rank"])
    if kind == "positive":
        return Positive(space, decode(data["formula"]), tuple(map(_equation, data["given"])))
    if kind == "count":
        equations = tuple(map(_equation, data["equations"]))
        return Count(space, equations, tuple(data["names"]), data["number"])
    if kind == "kernel":
        solutions, integrals = map(decode, data["solutions"]), map(decode, data["integrals"])
        factor, weights = decode(data["factor"]), tuple(data["weights"])
        return Kernel(space, factor, tuple(solutions), tuple(integrals), weights, data["degree"])
    raise FormatError(f"“{kind}” is no goal")


def _equation(data: Tree) -> Equation:
    left, right = data
    return decode(left), decode(right)
