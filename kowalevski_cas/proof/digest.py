"""Digests: what a statement says, in a form that any change of it changes."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import fields
from hashlib import sha256

from kowalevski_cas.claims import Claim
from kowalevski_cas.notation import to_latex
from kowalevski_cas.scene import Change, Locus, Scene
from kowalevski_cas.texts import Printed, Texts


class Digester:
    """Digests of statements under given texts; scenes are described once."""

    def __init__(self, texts: Texts) -> None:
        self.texts = texts
        self._scenes: dict[Scene, str] = {}

    def statement(self, claim: Claim) -> str:
        """The digest of a claim: its kind, its formulas as read, its scene and its parameters."""
        described = {f.name: self._describe(getattr(claim, f.name)) for f in fields(claim)}
        kind = type(claim).__name__
        return combined([kind, json.dumps(described, sort_keys=True, ensure_ascii=False)])

    def _scene(self, scene: Scene) -> str:
        if scene not in self._scenes:
            described = {f.name: self._describe(getattr(scene, f.name)) for f in fields(scene)}
            text = json.dumps(described, sort_keys=True, ensure_ascii=False)
            self._scenes[scene] = combined([text])
        return self._scenes[scene]

    def _describe(self, value: object) -> object:
        match value:
            case None | bool() | int() | str():
                return value
            case Printed():
                return [value.place, to_latex(self.texts.formula(value))]
            case Scene():
                return self._scene(value)
            case Change():
                rows = [self._describe(printed) for printed in value.formulas]
                return [self._scene(value.source), rows, self._describe(value.time)]
            case Claim():
                return self.statement(value)
            case dict():
                return {str(key): self._describe(item) for key, item in value.items()}
            case tuple() | list():
                return [self._describe(item) for item in value]
            case Locus():
                return [value.words, list(value.equations), value.condition]
        raise TypeError(f"a statement cannot hold a {type(value).__name__}")


def combined(parts: Iterable[str]) -> str:
    """One digest of many texts."""
    return sha256("\n".join(parts).encode()).hexdigest()[:16]

