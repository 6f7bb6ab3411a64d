"""Evidence: what searches found, kept beside the derivation so that they need not be run again.

Nothing here is trusted. Cofactors, points and corrections are checked in every
run; evidence for a statement that has changed is not looked at.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

FILE = "evidence.json"
VERSION = 1


class Mended(NamedTuple):
    """A correction: the place, the source of its display after the change, and words for it."""

    place: str
    tex: str
    words: str


@dataclass
class Evidence:
    """What was found for one claim: the results of searches by label, and the correction.

    ``hopeless`` says that a correction was searched for, and none was found.
    """

    digest: str
    found: dict[str, Any] = field(default_factory=dict)
    correction: Mended | None = None
    hopeless: bool = False


def load_evidence(folder: Path) -> dict[str, Evidence]:
    """The evidence kept in a derivation's folder; nothing if there is none that can be used."""
    try:
        data = json.loads((folder / FILE).read_text(encoding="utf-8"))
        if data["version"] != VERSION:
            return {}
        return {
            claim: Evidence(
                entry["digest"],
                {label: _decode(value) for label, value in entry["found"].items()},
                Mended(*entry["correction"]) if entry["correction"] else None,
                bool(entry["hopeless"]),
            )
            for claim, entry in data["claims"].items()
        }
    except (OSError, ValueError, KeyError, TypeError, AttributeError, ZeroDivisionError):
        return {}


def dump_evidence(evidence: dict[str, Evidence]) -> str:
    """Evidence as JSON, a claim a line."""
    lines = []
    for claim, entry in evidence.items():
        value = {
            "digest": entry.digest,
            "found": {label: _encode(v) for label, v in entry.found.items()},
            "correction": entry.correction,
            "hopeless": entry.hopeless,
        }
        lines.append(f"  {json.dumps(claim)}: {json.dumps(value, separators=(',', ':'))}")
    body = ",\n".join(lines)
    return f'{{"version": {VERSION}, "claims": {{\n{body}\n}}}}\n'


def _encode(value: Any) -> Any:
    """A neutral value as JSON: fractions, tuples and dictionaries are marked."""
    match value:
        case None | bool() | int() | str():
            return value
        case Fraction():
            return {"q": str(value)}
        case list():
            return [_encode(item) for item in value]
        case tuple():
            return {"t": [_encode(item) for item in value]}
        case dict():
            if value and all(isinstance(k, tuple) for k in value):
                return {"p": [[_number(v), *k] for k, v in value.items()]}
            return {"d": [[_encode(k), _encode(v)] for k, v in value.items()]}
    raise TypeError(f"evidence of type {type(value).__name__} cannot be kept")


def _number(value: Fraction) -> int | str:
    """A coefficient; whole numbers are read faster than fractions."""
    return value.numerator if value.denominator == 1 else str(value)


def _decode(value: Any) -> Any:
    if isinstance(value, list):
        return [_decode(item) for item in value]
    if not isinstance(value, dict):
        return value
    ((mark, content),) = value.items()
    if mark == "q":
        return Fraction(content)
    if mark == "t":
        return tuple(_decode(item) for item in content)
    if mark == "p":
        return {tuple(exponents): Fraction(number) for number, *exponents in content}
    return {_decode(k): _decode(v) for k, v in content}
