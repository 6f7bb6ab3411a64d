"""What a search has found, as claims like any other."""

from __future__ import annotations

from collections.abc import Iterable

from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.claims import FirstIntegral
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.scene import Scene


def with_integrals(derivation: Derivation, scene: Scene, found: Iterable[Element]) -> Derivation:
    """A derivation that rests on another one and claims elements to be integrals on a scene."""
    section = Section("1", "What was found", copied=False)
    words = derivation.texts().vocabulary
    for number, element in enumerate(found, 1):
        tex = to_latex(formula_of(element, words))
        place = section.lemma(f"found-{number}", tex, "found by the program")
        section.states(FirstIntegral, place, on=scene, says="it is constant along every motion")
    title = f"First integrals on the scene “{scene.name}”"
    return Derivation(derivation.name, title, "", "", (section,), rests_on=(derivation,))
