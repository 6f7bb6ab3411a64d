"""What a claim rests on: the places whose formulas enter its decision."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.claims import Claim
from kowalevski_cas.notation import Formula, Name, Root, read, to_latex
from kowalevski_cas.scene import Change, Scene
from kowalevski_cas.texts import Printed, Texts


def foundations(claim: Claim, texts: Texts) -> dict[Printed, None]:
    """The places of a claim, and those of its scenes that the names in them lead to.

    The field of a scene always takes part, for a derivative may.
    """
    found = dict.fromkeys(claim.places())
    formulas = [texts.formula(place) for place in found]
    formulas += [read(tex, texts.vocabulary) for tex in claim.expressions()]
    for scene in claim.scenes():
        _follow(scene, formulas, texts, found)
    return found


def _follow(
    scene: Scene, formulas: list[Formula], texts: Texts, found: dict[Printed, None]
) -> None:
    waiting = list(formulas)
    for place in _field(scene):
        found.setdefault(place)
        waiting.append(texts.formula(place))
    if isinstance(scene.field, Change):
        _follow(scene.field.source, [], texts, found)
    seen: set[str] = set()
    while waiting:
        for name in names(waiting.pop()):
            if name in seen:
                continue
            seen.add(name)
            place = scene.definitions.get(name) or scene.roots.get(name)
            if name == "i":
                place = scene.unit
            waiting += [read(n, texts.vocabulary) for n in scene.vectors.get(name, ())]
            if place is not None:
                found.setdefault(place)
                waiting.append(texts.formula(place))


def _field(scene: Scene) -> Iterator[Printed]:
    if isinstance(scene.field, Change):
        yield from (*scene.field.formulas, scene.field.time)
    else:
        yield from scene.field
    yield from scene.zero
    if scene.clock is not None:
        yield scene.clock


def names(formula: Formula) -> Iterator[str]:
    """The names and printed roots in a formula."""
    if isinstance(formula, Name):
        yield formula.name
    if isinstance(formula, Root):
        yield to_latex(formula)
    for child in formula.children():
        yield from names(child)
