"""Problems and evidence as JSON, and back: the format of certificates (docs/certificate.md)."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from hashlib import sha256
from typing import Any

from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.evidence import (
    At,
    Evidence,
    Factor,
    Found,
    Minors,
    Point,
    Proof,
    Regardless,
    Roots,
    Row,
    Shown,
    Solutions,
    Squares,
)
from kowalevski_cas.problem.goals import (
    Count,
    Exists,
    Fails,
    Follows,
    Goal,
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
from kowalevski_cas.problem.trees import FormatError, Tree, decode, encode, whole

Data = dict[str, Any]


# -- problems ----------------------------------------------------------------------


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
    raise FormatError(f"“{kind}” is no goal")


def _equation(data: Tree) -> Equation:
    left, right = data
    return decode(left), decode(right)


# -- evidence ----------------------------------------------------------------------


def evidence_data(evidence: Evidence) -> Data:
    """Evidence as it stands in a certificate, without what it has to divide by."""
    match evidence:
        case Shown(proof, point):
            return {**_point_data(point), **_proof_data(proof)}
        case At(point):
            return _point_data(point)
        case Minors(rows):
            return {"minors": _rows(rows)}
        case Found(values, inner):
            shown = [[name, encode(value)] for name, value in values.items()]
            return {"values": shown, "evidence": list(map(evidence_data, inner))}
        case Regardless(goal, points):
            weighted = [[encode(number), _point_data(point)["point"]] for number, point in points]
            return {"inner": goal, "points": weighted}
        case Squares(squares, row, point, zero):
            data = {**_point_data(point), "squares": _squares(squares), "cofactors": _rows((row,))}
            return data if zero is None else {**data, "zero": _proof_data(zero)}
        case Roots():
            return _roots_data(evidence)
        case Solutions(points):
            return {"points": [_point_data(point)["point"] for point in points]}


def read_evidence(data: Data, goal: Goal, holds: bool = True) -> Evidence:
    """The evidence in the data of a certificate that a goal holds, or that it does not.

    Raises :class:`FormatError` if it is none.
    """
    try:
        return _read_evidence(data, goal, holds)
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise FormatError(f"it is no evidence: {error}") from None


def _read_evidence(data: Data, goal: Goal, holds: bool) -> Evidence:
    match goal:
        case Exists() if holds:
            values = {name: decode(tree) for name, tree in data["values"]}
            pairs = zip(data["evidence"], goal.goals, strict=True)
            return Found(values, tuple(read_evidence(entry, one) for entry, one in pairs))
        case Exists():
            weighted = ((decode(number), _read_point(point)) for number, point in data["points"])
            return Regardless(_index(data["inner"]), tuple(weighted))
        case Follows() if isinstance(goal, Fails) != holds:
            return Shown(_read_proof(data), _read_point(data["point"]))
        case Rank() if not holds and "minors" in data:
            return Minors(_read_rows(data["minors"]))
        case Positive() if holds:
            squares, (row,) = _read_squares(data["squares"]), _read_rows(data["cofactors"])
            zero = _read_proof(data["zero"]) if "zero" in data else None
            return Squares(squares, row, _read_point(data["point"]), zero)
        case Count() if "eliminant" in data:
            return _read_roots(data)
        case Count():
            return Solutions(tuple(map(_read_point, data["points"])))
    return At(_read_point(data["point"]))


def _point_data(point: Point | None) -> Data:
    if point is None:
        return {}
    values = [[name, encode(value)] for name, value in sorted(point.values.items())]
    return {"point": {"roots": sorted(_squares_under(values)), "values": values}}


def _squares_under(tree: Tree) -> set[int]:
    """The whole numbers of which roots are taken."""
    if not isinstance(tree, list):
        return set()
    if tree[:1] == ["sqrt"]:
        return {tree[1]}
    return {number for part in tree for number in _squares_under(part)}


def _read_point(data: Data) -> Point:
    return Point({name: decode(tree) for name, tree in data["values"]})


def _proof_data(proof: Proof) -> Data:
    data: Data = {}
    if proof.product:
        data["product"] = _rows(proof.product)
    if proof.rows:
        data["cofactors"] = _rows(proof.rows)
    if proof.cases:
        data["cases"] = list(map(_proof_data, proof.cases))
    if proof.power != 1:
        data["power"] = proof.power
    return data


def _read_proof(data: Data) -> Proof:
    return Proof(
        _read_rows(data.get("cofactors", ())),
        _read_rows(data.get("product", ())),
        tuple(map(_read_proof, data.get("cases", ()))),
        data.get("power", 1),
    )


def _rows(rows: Sequence[Row]) -> list[list[Tree]]:
    return [[encode(entry) for entry in row] for row in rows]


def _read_rows(data: Sequence[Sequence[Tree]]) -> tuple[Row, ...]:
    return tuple(tuple(map(decode, row)) for row in data)


def _squares(squares: Sequence[tuple[Formula, Formula]]) -> list[list[Tree]]:
    return [[encode(number), encode(base)] for number, base in squares]


def _read_squares(data: Sequence[Tree]) -> tuple[tuple[Formula, Formula], ...]:
    return tuple((decode(number), decode(base)) for number, base in data)


def _roots_data(roots: Roots) -> Data:
    factors = []
    for factor in roots.factors:
        entry: Data = {"factor": encode(factor.factor), "squares": _squares(factor.squares)}
        if factor.row:
            entry["cofactors"] = _rows((factor.row,))[0]
        if factor.granted is not None:
            entry["granted"] = [factor.granted[0], _rows((factor.granted[1],))[0]]
        factors.append(entry)
    return {
        **_point_data(roots.point),
        "root": roots.root,
        "form": encode(roots.form),
        "eliminant": list(map(encode, roots.eliminant)),
        "solved": [[name, encode(a), encode(b)] for name, a, b in roots.solved],
        "cofactors": _rows(roots.rows),
        "quotients": list(map(encode, roots.quotients)),
        "factors": factors,
        "minors": [[encode(number), list(powers)] for number, powers in roots.minors],
    }


def _read_roots(data: Data) -> Roots:
    return Roots(
        root=data["root"],
        form=decode(data["form"]),
        eliminant=tuple(map(decode, data["eliminant"])),
        solved=tuple((name, decode(a), decode(b)) for name, a, b in data["solved"]),
        rows=_read_rows(data["cofactors"]),
        quotients=tuple(map(decode, data["quotients"])),
        factors=tuple(
            Factor(
                decode(entry["factor"]),
                _read_squares(entry["squares"]),
                tuple(map(decode, entry.get("cofactors", ()))),
                _read_granted(entry.get("granted")),
            )
            for entry in data["factors"]
        ),
        minors=tuple(
            (decode(number), tuple(map(whole, powers))) for number, powers in data["minors"]
        ),
        point=_read_point(data["point"]),
    )


def _read_granted(data: Tree) -> tuple[int, Row] | None:
    if data is None:
        return None
    place, row = data
    return _index(place), tuple(map(decode, row))


def _index(data: Tree) -> int:
    if type(data) is not int or data < 0:
        raise FormatError("the place of something in a list is expected")
    return data
