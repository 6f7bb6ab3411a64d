"""Digests: what a statement says, in a form that any change of it changes."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import fields
from hashlib import sha256

from kowalevski_cas.claims import Claim
from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.scene import Change, Locus, Scene
from kowalevski_cas.paper.texts import Printed, Texts


class Digester:
    """Digests of statements; what a scene says is described once as long as it stays the same."""

    def __init__(self) -> None:
        self._scenes: dict[tuple[Scene, frozenset[object]], str] = {}
        self._places: dict[Scene, frozenset[Printed]] = {}

    def statement(self, claim: Claim, texts: Texts) -> str:
        """The digest of a claim: its kind, its formulas as read, its scene and its parameters."""
        described = {f.name: self._describe(getattr(claim, f.name), texts) for f in fields(claim)}
        kind = type(claim).__name__
        return combined([kind, json.dumps(described, sort_keys=True, ensure_ascii=False)])

    def _scene(self, scene: Scene, texts: Texts) -> str:
        if scene not in self._places:
            self._places[scene] = frozenset(scene.places())
        key = (scene, texts.changes(self._places[scene]))
        if key not in self._scenes:
            described = {
                f.name: self._describe(getattr(scene, f.name), texts) for f in fields(scene)
            }
            text = json.dumps(described, sort_keys=True, ensure_ascii=False)
            self._scenes[key] = combined([text])
        return self._scenes[key]

    def _describe(self, value: object, texts: Texts) -> object:
        match value:
            case None | bool() | int() | str():
                return value
            case Printed():
                return [value.place, to_latex(texts.formula(value))]
            case Scene():
                return self._scene(value, texts)
            case Change():
                rows = [self._describe(printed, texts) for printed in value.formulas]
                return [self._scene(value.source, texts), rows, self._describe(value.time, texts)]
            case Claim():
                return self.statement(value, texts)
            case dict():
                return {str(key): self._describe(item, texts) for key, item in value.items()}
            case tuple() | list():
                return [self._describe(item, texts) for item in value]
            case Locus():
                return [value.words, list(value.equations), value.condition]
        raise TypeError(f"a statement cannot hold a {type(value).__name__}")


def combined(parts: Iterable[str]) -> str:
    """One digest of many texts."""
    return sha256("\n".join(parts).encode()).hexdigest()[:16]
