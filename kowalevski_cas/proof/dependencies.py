"""What a claim rests on: the places whose formulas enter its decision."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.claims import Claim
from kowalevski_cas.notation import Application, Formula, Name, PoissonBracket, Root, to_latex
from kowalevski_cas.paper.scene import BRACKET, Change, Scene, head
from kowalevski_cas.paper.texts import Printed, Texts


class Dependencies:
    """Foundations of claims under given texts; what one scene leads to is followed once."""

    def __init__(self, texts: Texts) -> None:
        self.texts = texts
        self._scenes: dict[Scene, _Closure] = {}

    def foundations(self, claim: Claim) -> dict[Printed, None]:
        """The places of a claim, and those of its scenes that the names in them lead to.

        The field of a scene always takes part, for a derivative may.
        """
        found = dict.fromkeys(claim.places())
        used = {name for place in found for name in names(self.texts.formula(place))}
        for tex in claim.expressions():
            used.update(names(self.texts.expression(tex)))
        for scene in claim.scenes():
            closure = self._closure(scene)
            found.update(closure.always)
            for name in sorted(used):
                found.update(closure.of(name))
        return found

    def _closure(self, scene: Scene) -> _Closure:
        if scene not in self._scenes:
            self._scenes[scene] = _Closure(scene, self.texts)
        return self._scenes[scene]


class _Closure:
    """The places of a scene to which names lead, through definitions of definitions."""

    def __init__(self, scene: Scene, texts: Texts) -> None:
        self.scene = scene
        self.texts = texts
        self._known: dict[str, dict[Printed, None]] = {}
        self.always: dict[Printed, None] = {}
        for place in _field(scene):
            self.always.setdefault(place)
            for name in set(names(texts.formula(place))):
                self.always.update(self.of(name))
        if isinstance(scene.field, Change):
            self.always.update(_Closure(scene.field.source, texts).always)

    def of(self, name: str) -> dict[Printed, None]:
        """The places on which the meaning of a name rests."""
        if name in self._known:
            return self._known[name]
        found: dict[Printed, None] = {}
        self._known[name] = found
        scene = self.scene
        component = scene.component(name)
        places = [p for d, p in scene.definitions.items() if head(d)[0] == name]
        if place := scene.unit if name == "i" else scene.roots.get(name):
            places.append(place)
        for other in component[:1] if component else scene.vectors.get(name, ()):
            found.update(self.of(other))
        for place in places:
            found.setdefault(place)
            for other in names(self.texts.formula(place)):
                found.update(self.of(other))
        return found


def _field(scene: Scene) -> Iterator[Printed]:
    if isinstance(scene.field, Change):
        yield from (*scene.field.formulas, scene.field.time)
    else:
        yield from scene.field
    yield from scene.zero
    if scene.clock is not None:
        yield scene.clock


def names(formula: Formula) -> Iterator[str]:
    """The names, printed roots and functions in a formula."""
    if isinstance(formula, Name):
        yield formula.name
    if isinstance(formula, Application):
        yield formula.function
    if isinstance(formula, PoissonBracket):
        yield BRACKET
    if isinstance(formula, Root):
        yield to_latex(formula)
    for child in formula.children():
        yield from names(child)
