"""Ways to tamper with a certificate: every leaf, every operation, every list of its JSON."""

from __future__ import annotations

import hashlib
import json
import re
from copy import deepcopy

OTHERS = {
    "+": ("*",), "*": ("+", "/"), "/": ("*",), "-": ("conj", "D"), "D": ("-",), "conj": ("-",),
    "dot": ("cross",), "cross": ("dot",), "sqrt": ("-",), "vector": ("diag",), "diag": ("vector",),
    "d": (), "^": (), "let": ("root",), "root": ("let",), "power": ("let",),
    "follows": ("fails", "rank"), "rank": ("follows",), "fails": ("follows",),
    "count": ("follows",), "kernel": ("follows",), "along": ("follows", "kernel"), "exists": ("follows",),
    "holds": ("denied",), "denied": ("holds",),
}  # fmt: skip


def seal(data):
    """The text of a certificate, with the digests that belong to its problems."""
    failures = data.get("failures")
    if isinstance(failures, list):
        data = {**data, "failures": [sealed(x) if isinstance(x, dict) else x for x in failures]}
    return json.dumps(sealed(data))


def sealed(data):
    problem = {key: data[key] for key in ("spaces", "goals") if key in data}
    digest = hashlib.sha256(json.dumps(problem, sort_keys=True).encode()).hexdigest()[:16]
    return {**data, "digest": digest}


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


# -- changes of any kind -----------------------------------------------------------

JUNK = (
    None, True, False, 0, 1, -1, 2, 64, 65, 10**9, 10**30, 0.5, "", "i", "x", "x\nCERTIFIED 9 of 9", "\u202e",
    "\ud800", [], [[]], {}, [{}], ["sqrt", 2], ["D", "x"], ["/", 1, 0], ["^", ["^", "x", 64], 64],
)  # fmt: skip


def twisted(data, choose):
    """A copy with one to three changes of any kind, at any places."""
    for _ in range(choose.choice((1, 1, 1, 2, 3))):
        everywhere = [path for path in places(data) if path != ("digest",)]
        path = choose.choice(everywhere)
        value = deepcopy(at(data, path))
        kind = choose.choice(
            ("junk", "splice", "swap", "double", "reverse", "sink", "lift", "other")
        )
        if kind == "junk":
            data = changed(data, path, deepcopy(choose.choice(JUNK)))
        elif kind == "splice":
            data = changed(data, path, deepcopy(at(data, choose.choice(everywhere))))
        elif kind == "swap" and len(path) > 1:
            beside = [p for p in everywhere if p[:-1] == path[:-1]]
            other = choose.choice(beside)
            data = changed(changed(data, path, deepcopy(at(data, other))), other, value)
        elif kind == "double" and isinstance(value, list) and value:
            place = choose.randrange(len(value))
            data = changed(data, path, [*value[:place], value[place], *value[place:]])
        elif kind == "reverse" and isinstance(value, list):
            data = changed(data, path, value[::-1])
        elif kind == "sink":
            data = changed(data, path, [value])
        elif kind == "lift" and isinstance(value, list) and value:
            data = changed(data, path, choose.choice(value))
        elif kind == "other":
            names = sorted(names_in([data.get("spaces"), data.get("goals")]))
            data = changed(data, path, choose.choice(others(data, path, names)))
    return data


def scratched(text, choose):
    """A text with a few characters changed, left out, put in, or a piece of it doubled."""
    for _ in range(choose.choice((1, 1, 2, 5))):
        k, n = choose.randrange(len(text)), choose.choice((0, 1, 1, 30))
        new = choose.choice(("", text[k : k + n] * 2, choose.choice('019-,:[]{}"\\\nxe.\0é')))
        text = text[:k] + new + text[k + n :]
    return text


def doubled_key(text, choose):
    """A text in which a key stands twice, the second time with another value."""
    found = [match.span() for match in re.finditer(r'"\w+"(?=\s*:)', text)]
    start, end = choose.choice(found)
    return f"{text[:start]}{text[start:end]}: {choose.choice(['0', '[]', 'null', '{}'])}, {text[start:]}"
