"""Ways to tamper with a certificate: every leaf, every operation, every list of its JSON."""

from __future__ import annotations

import hashlib
import json
from copy import deepcopy

OTHERS = {
    "+": ("*",), "*": ("+", "/"), "/": ("*",), "-": ("conj", "D"), "D": ("-",), "conj": ("-",),
    "dot": ("cross",), "cross": ("dot",), "sqrt": ("-",), "vector": ("diag",), "diag": ("vector",),
    "d": (), "^": (), "let": ("root",), "root": ("let",), "power": ("let",),
    "follows": ("fails", "rank"), "rank": ("follows",), "fails": ("follows",),
    "positive": ("follows",), "count": ("follows",), "exists": ("follows",),
    "holds": ("denied",), "denied": ("holds",),
}  # fmt: skip


def seal(data):
    """The text of a certificate, with the digest that belongs to its problem."""
    problem = {key: data[key] for key in ("spaces", "goals") if key in data}
    digest = hashlib.sha256(json.dumps(problem, sort_keys=True).encode()).hexdigest()[:16]
    return json.dumps({**data, "digest": digest})


def names_in(data):
    """All names that occur in a certificate."""
    if isinstance(data, str):
        return {data}
    if isinstance(data, list):
        return {name for item in data for name in names_in(item)}
    if isinstance(data, dict):
        return {name for item in data.values() for name in names_in(item)}
    return set()


def places(data, path=()):
    """The paths to everything below a value."""
    if isinstance(data, dict):
        for key, item in data.items():
            yield (*path, key)
            yield from places(item, (*path, key))
    elif isinstance(data, list):
        for k, item in enumerate(data):
            yield (*path, k)
            yield from places(item, (*path, k))


def at(data, path):
    for step in path:
        data = data[step]
    return data


def changed(data, path, value):
    """A copy of the data with another value at the end of a path; ``None`` takes it away."""
    data = deepcopy(data)
    if value is None:
        del at(data, path[:-1])[path[-1]]
    else:
        at(data, path[:-1])[path[-1]] = value
    return data


def others(data, path, names):
    """What could stand at a place instead; ``None`` takes it away."""
    value = at(data, path)
    new = []
    if isinstance(value, bool):
        new = [not value]
    elif isinstance(value, int):
        new = [value + 1, value - 1, -value, 2 * value, 0, True, 0.5]
    elif isinstance(value, str):
        new = list(OTHERS.get(value, ())) if value in OTHERS else [n for n in names if n != value]
    elif isinstance(value, list) and value:
        new = [value[:-1], value[1:], [*value, value[-1]], []]
        if len(value) > 1:
            new += [[value[1], value[0], *value[2:]], [*value[:-2], value[-1], value[-2]]]
        if isinstance(value[0], str):
            new += [["-", value], ["+", value, 1], ["*", 2, value], ["/", value, 0], 0]
    elif isinstance(value, dict):
        new = [{**value, "note": 1}]
    return [item for item in new if type(item) is not type(value) or item != value] + [None]


def mutants(data, path, names):
    """Certificates that differ at one place, with words for the change."""
    for value in others(data, path, names):
        yield f"{path} = {str(value)[:60]}", changed(data, path, value)
