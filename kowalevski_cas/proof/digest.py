"""Digests: what a statement says, in a form that any change of it changes."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import fields
from hashlib import sha256

from kowalevski_cas.claims import Claim
from kowalevski_cas.notation import to_latex
from kowalevski_cas.scene import Change, Scene
from kowalevski_cas.texts import Printed, Texts


def statement_digest(claim: Claim, texts: Texts) -> str:
    """The digest of a claim: its kind, its formulas as read, its scene and its parameters."""
    described = {
        "kind": type(claim).__name__,
        "fields": {f.name: _describe(getattr(claim, f.name), texts) for f in fields(claim)},
    }
    return combined([json.dumps(described, sort_keys=True, ensure_ascii=False)])


def combined(parts: Iterable[str]) -> str:
    """One digest of many texts."""
    return sha256("\n".join(parts).encode()).hexdigest()[:16]


def _describe(value: object, texts: Texts) -> object:
    match value:
        case Printed():
            return [value.place, to_latex(texts.formula(value))]
        case Scene():
            return {f.name: _describe(getattr(value, f.name), texts) for f in fields(value)}
        case Change():
            rows = [_describe(printed, texts) for printed in value.formulas]
            return [value.source.name, rows, _describe(value.time, texts)]
        case Claim():
            return statement_digest(value, texts)
        case dict():
            return {str(key): _describe(item, texts) for key, item in value.items()}
        case tuple() | list():
            return [_describe(item, texts) for item in value]
        case None | bool() | int() | str():
            return value
    return [_describe(getattr(value, f.name), texts) for f in fields(value)]  # type: ignore[arg-type]
