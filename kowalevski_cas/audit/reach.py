"""The places that take part in deciding a claim, as far as names lead from it."""

from __future__ import annotations

from kowalevski_cas.audit.roles import parts_of
from kowalevski_cas.claims import Claim
from kowalevski_cas.paper.scene import Change, Scene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.proof.dependencies import Dependencies, names


class Reach(Dependencies):
    """Dependencies with all that is computed on a scene whether or not a claim names it.

    Roots are adjoined when a scene is set up; conditions are compared with what
    the scene takes for granted and with its loci.
    """

    def places(self, claim: Claim) -> frozenset[Printed]:
        """Every place whose text can change the verdict on a claim.

        Raises ``NotationError`` if a formula on the way cannot be read.
        """
        found = self.foundations(claim)
        parts = dict.fromkeys(parts_of(claim))
        found.update(parts)
        used = {name for place in parts for name in names(self.texts.formula(place))}
        for scene in claim.scenes():
            closure = self._closure(scene)
            for name in sorted(used):
                found.update(closure.of(name))
            found.update(self._set_up(scene))
            if isinstance(scene.field, Change):
                found.update(self._set_up(scene.field.source))
        return frozenset(found)

    def _set_up(self, scene: Scene) -> dict[Printed, None]:
        places = [p for p in (scene.unit, scene.clock, *scene.roots.values()) if p is not None]
        found = dict.fromkeys((*places, *scene.zero))
        used = {name for place in found for name in names(self.texts.formula(place))}
        spoken = [root for root in scene.roots if root.startswith(r"\sqrt")]
        spoken += scene.nonzero
        for locus in scene.loci:
            spoken += (*locus.equations, locus.condition)
        for tex in spoken:
            used.update(names(self.texts.expression(tex)))
        closure = self._closure(scene)
        for name in sorted(used):
            found.update(closure.of(name))
        return found
