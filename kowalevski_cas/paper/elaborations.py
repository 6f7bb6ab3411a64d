"""The elaborations of scenes under the same texts; those that texts share are made once."""

from __future__ import annotations

from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts


class Elaborations:
    """Calling it gives the setting of a scene; ``under`` other texts, the same or others."""

    def __init__(self, texts: Texts, known: dict[object, Elaboration] | None = None) -> None:
        self.texts = texts
        self._known: dict[object, Elaboration] = {} if known is None else known
        self._own: dict[Scene, Elaboration] = {}

    def __call__(self, scene: Scene) -> Elaboration:
        """The setting that a scene means."""
        if scene not in self._own:
            key = (scene, self.texts.changes(scene.places))
            if key not in self._known:
                self._known[key] = Elaboration(scene, self.texts, self)
            self._own[scene] = self._known[key]
        return self._own[scene]

    def under(self, texts: Texts) -> Elaborations:
        """The elaborations under other texts."""
        return self if texts is self.texts else Elaborations(texts, self._known)

    def apart(self, texts: Texts) -> Elaborations:
        """The elaborations under other texts, of which these here do not hear."""
        return Elaborations(texts, {**self._known})
