"""The elaborations of scenes under the same texts; those that texts share are made once."""

from __future__ import annotations

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.generators import free_names
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts


class Elaborations:
    """Calling it gives the setting of a scene; ``under`` other texts, the same or others.

    Settings know the functions in formulas that were ``met`` as well as those of their scenes.
    One that knows those in formulas ``beside`` is taken where it knows the others too.
    """

    def __init__(
        self,
        texts: Texts,
        known: dict[object, Elaboration] | None = None,
        met: tuple[Formula, ...] = (),
        beside: tuple[Formula, ...] = (),
    ) -> None:
        self.texts, self.met, self.beside = texts, met, beside
        self._known: dict[object, Elaboration] = {} if known is None else known
        self._own: dict[Scene, Elaboration] = {}

    def __call__(self, scene: Scene) -> Elaboration:
        """The setting that a scene means."""
        if scene not in self._own:
            known = dict.fromkeys(((), self.beside))
            settings = filter(self._suffices, (self._elaborate(scene, one) for one in known))
            self._own[scene] = next(settings, None) or self._elaborate(scene, self.met)
        return self._own[scene]

    def _suffices(self, setting: Elaboration) -> bool:
        """Whether a setting knows the functions in what was met."""
        functions = setting.transcendental.knows(self.met, free_names(setting, self.met))
        return functions and setting.radicals.knows(self.met, setting.scene)

    def _elaborate(self, scene: Scene, met: tuple[Formula, ...]) -> Elaboration:
        key = (scene, self.texts.changes(scene.places), met)
        if key not in self._known:
            self._known[key] = Elaboration(scene, self.texts, self.meeting(met), met)
        return self._known[key]

    def meeting(self, formulas: tuple[Formula, ...]) -> Elaborations:
        """The elaborations that know the functions in some formulas as well."""
        if formulas == self.met:
            return self
        return Elaborations(self.texts, self._known, formulas, self.beside)

    def with_beside(self, formulas: tuple[Formula, ...]) -> Elaborations:
        """The elaborations that know the functions in some formulas, if these are enough."""
        return Elaborations(self.texts, self._known, self.met, formulas)

    def under(self, texts: Texts) -> Elaborations:
        """The elaborations under other texts."""
        if texts is self.texts:
            return self
        return Elaborations(texts, self._known, beside=self.beside)

    def apart(self, texts: Texts) -> Elaborations:
        """The elaborations under other texts, of which these here do not hear."""
        return Elaborations(texts, {**self._known})
