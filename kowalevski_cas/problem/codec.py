"""Problems and evidence as JSON, and back, as they stand in certificates (docs/certificate.md).

A formula is a tree, a tuple a list, a mapping a list of pairs, and data an object under the keys of
:data:`SHAPES`; a step, or a row of a field, is a list of what it has. The spaces of a problem are a
list, and goals and changes have their places in it.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import MISSING
from functools import cache
from hashlib import sha256
from types import NoneType, UnionType
from typing import Any, get_args, get_origin, get_type_hints

from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.evidence import (
    At,
    Departure,
    Entailment,
    Evidence,
    Factor,
    Found,
    Further,
    Minors,
    Point,
    Proof,
    Regardless,
    Roots,
    Solutions,
)
from kowalevski_cas.problem.goals import (
    Along,
    Count,
    Exists,
    Fails,
    Follows,
    Goal,
    Kernel,
    Problem,
    Rank,
)
from kowalevski_cas.problem.space import (
    Adjoined,
    ChangeOfVariables,
    EquationOfMotion,
    Let,
    NameDefinition,
    Raised,
    Setting,
    Space,
    Step,
)
from kowalevski_cas.problem.trees import FormatError, Tree, decode, encode

Data = dict[str, Any]

SHAPES: dict[type[Any], str] = {
    Space: "variables constants? nonzero? steps? field? change? conjugates?",
    ChangeOfVariables: "old formulas time",
    Exists: "numbers expressions goals",
    Follows: "space given conclusions",
    Fails: "space given conclusions",
    Rank: "space functions given rank",
    Count: "space equations names number",
    Kernel: "space factor solutions integrals weights degree",
    Along: "space initial equations",
    Proof: "product? cofactors:rows? cases? power? equal?",
    Point: "values",
    At: "point",
    Minors: "minors:rows",
    Found: "values evidence",
    Regardless: "inner:goal points",
    Factor: "factor squares cofactors:row? granted?",
    Roots: "point root form eliminant solved cofactors:rows quotients factors minors",
    Solutions: "points",
    Further: "further:formula point",
    Departure: "point order",
}
"""Keys in their order, with the attribute behind a colon if it is called otherwise.

Those with a question mark are left out if they have their default.
"""

_Key = tuple[str, str, object]


def _keys(kind: type[Any], shape: str) -> Iterator[_Key]:
    """Keys, their attributes, and the value with which one is left out."""
    defaults = getattr(kind, "_field_defaults", vars(kind))  # of a tuple, or of a dataclass
    for entry in shape.split():
        key, _, name = entry.rstrip("?").partition(":")
        yield key, name or key, defaults[name or key] if entry[-1] == "?" else MISSING


_KEYS = {kind: [*_keys(kind, shape)] for kind, shape in SHAPES.items()}
_GOALS: dict[str, type[Any]] = {
    kind.__name__.lower(): kind for kind in (Exists, Follows, Fails, Rank, Count, Kernel, Along)
}
_STEPS: dict[str, type[Any]] = {"let": Let, "root": Adjoined, "power": Raised}
_WORDS = {kind: word for word, kind in (*_GOALS.items(), *_STEPS.items())}


@cache
def _types(kind: Any) -> dict[str, Any]:
    """The types of the attributes of data, by their names."""
    return get_type_hints(kind)


def problem_data(problem: Problem) -> Data:
    """The spaces and goals of a problem."""
    spaces: list[Space] = []
    goals = [_object(goal, spaces) for goal in problem.goals]
    return {"spaces": [_object(space, spaces) for space in spaces], "goals": goals}


def digest(problem: Problem) -> str:
    """The digest of a statement: any change of its mathematics changes it."""
    return sha256(_JSON.encode(problem_data(problem)).encode()).hexdigest()[:16]


_JSON = json.JSONEncoder(sort_keys=True, check_circular=False)


def evidence_data(evidence: Evidence) -> Data:
    """Evidence as it stands in a certificate, without what it has to divide by."""
    return _object(evidence, [])


def _json_of(value: Any, spaces: list[Space]) -> Tree:
    """A value as JSON; spaces that are met are entered, each after those that it rests on."""
    match value:
        case Formula():
            return encode(value)
        case str() | int():
            return value
        case tuple() if type(value) is tuple:
            return [_json_of(part, spaces) for part in value]
        case Space():
            return _place(value, spaces)
        case NameDefinition():
            return [_WORDS[type(value)], *value.trees]
        case EquationOfMotion(names, factor, force):
            return [[*names], encode(factor), encode(force)]
        case Mapping():
            return [[name, encode(formula)] for name, formula in value.items()]
    return _object(value, spaces)


def _place(space: Space, spaces: list[Space]) -> int:
    if space not in spaces:
        if space.change is not None:
            _json_of(space.change.old, spaces)
        spaces.append(space)
    return spaces.index(space)


def _object(value: Any, spaces: list[Space]) -> Data:
    """Data under its keys."""
    match value:
        case Point(values):
            trees = [[name, encode(tree)] for name, tree in sorted(values.items())]
            return {"roots": sorted(_radicands(trees)), "values": trees}
        case Entailment(proof, None):
            return _object(proof, spaces)
        case Entailment(proof, point):
            return {"point": _object(point, spaces), **_object(proof, spaces)}
    word = {"goal": _WORDS[type(value)]} if type(value) in _WORDS else {}
    found = [(key, getattr(value, name), least) for key, name, least in _KEYS[type(value)]]
    return word | {
        key: _json_of(value, spaces) for key, value, least in found if value not in (least, None)
    }


def _radicands(tree: Tree) -> set[int]:
    """The whole numbers of which roots are taken."""
    if not isinstance(tree, list):
        return set()
    if tree[:1] == ["sqrt"]:
        return {tree[1]}
    return {number for part in tree for number in _radicands(part)}


# -- and back ----------------------------------------------------------------------


def read_problem(data: Data) -> Problem:
    """The problem in the data of a certificate; raises :class:`FormatError` if there is none."""
    try:
        spaces: list[Space] = []
        for space in data["spaces"]:
            spaces.append(_object_from_json(Space, space, spaces))
        return Problem(tuple(_value_from_json(Goal, goal, spaces) for goal in data["goals"]))
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise FormatError(f"it states nothing that can be read: {error}") from None


def read_evidence(data: Data, goal: Goal, holds: bool = True) -> Evidence:
    """The evidence in the data of a certificate that a goal holds, or that it does not.

    Raises :class:`FormatError` if it is none.
    """
    try:
        kind = _kind(data, goal, holds)
        found = {key: value for key, value in data.items() if key != "away" or kind is Found}
        if isinstance(goal, Exists) and kind is Found:
            pairs = zip(found.pop("evidence"), goal.goals, strict=True)
            inner = tuple(read_evidence(entry, inner_goal) for entry, inner_goal in pairs)
            return Found(
                _value_from_json(_types(Found)["values"], found.pop("values"), []), inner, **found
            )
        if kind is Entailment:
            point = _value_from_json(Point, found.pop("point"), [])
            return Entailment(_object_from_json(Proof, found, []), point)
        evidence: Evidence = _object_from_json(kind, found, [])
        return evidence
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise FormatError(f"it is no evidence: {error}") from None


def _kind(data: Data, goal: Goal, holds: bool) -> type:
    """What evidence for a goal, or against it, is."""
    match goal:
        case Exists():
            return Found if holds else Regardless
        case Follows() if isinstance(goal, Fails) != holds:
            return Entailment
        case Rank() if not holds and "minors" in data:
            return Minors
        case Kernel() if "further" in data:
            return Further
        case Along():
            return At if holds else Departure
        case Count():
            return Roots if "eliminant" in data else Solutions
    return At


def _value_from_json(kind: Any, data: Tree, spaces: list[Space]) -> Any:
    """The value of a type that is written as this JSON."""
    if isinstance(kind, UnionType):
        return _one_from_json(kind, data, spaces)
    if get_origin(kind) is tuple:
        first, *others = get_args(kind)
        parts = [first] * len(data) if others == [...] else [first, *others]
        return tuple(
            _value_from_json(part, entry, spaces) for part, entry in zip(parts, data, strict=True)
        )
    if get_origin(kind) is Mapping:
        return {name: decode(tree) for name, tree in data}
    if kind is Formula:
        return decode(data)
    if kind is Setting:
        return spaces[_value_from_json(int, data, spaces)]
    if kind in (str, int):
        if type(data) is not kind or (kind is int and data < 0):
            raise FormatError(f"{data!r:.80} is no {'name' if kind is str else 'whole number'}")
        return data
    if kind is EquationOfMotion:
        return _list_from_json(EquationOfMotion, data, spaces)
    return _object_from_json(kind, data, spaces)


def _one_from_json(kind: Any, data: Tree, spaces: list[Space]) -> Any:
    """A goal, a step, or what may be left out and is not."""
    if kind == Step:
        word, *rest = data
        return _list_from_json(_STEPS[word], rest, spaces)
    first, *others = (part for part in get_args(kind) if part is not NoneType)
    if not others:
        return _value_from_json(first, data, spaces)
    goal_type = _GOALS[data["goal"]]
    if not issubclass(goal_type, get_args(kind)):
        raise FormatError(f"a goal of the kind {data['goal']} cannot stand here")
    return _object_from_json(
        goal_type, {key: value for key, value in data.items() if key != "goal"}, spaces
    )


def _list_from_json(kind: Any, data: Tree, spaces: list[Space]) -> Any:
    types = [*_types(kind).values()][: len(data)]
    return kind(
        *(_value_from_json(part, entry, spaces) for part, entry in zip(types, data, strict=True))
    )


def _object_from_json(kind: Any, data: Data, spaces: list[Space]) -> Any:
    keys = _KEYS[kind]
    if unknown := data.keys() - {key for key, *_ in keys} - ({"roots"} if kind is Point else set()):
        raise FormatError(f"“{min(unknown)}” is unknown here")
    names = {name: data[key] for key, name, least in keys if key in data or least is MISSING}
    return kind(
        **{
            name: _value_from_json(_types(kind)[name], entry, spaces)
            for name, entry in names.items()
        }
    )
