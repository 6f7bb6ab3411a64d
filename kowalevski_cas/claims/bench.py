"""The bench on which a claim is decided: an arithmetic, texts, and what searches have found."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import Any, TypeVar

from kowalevski_cas.arithmetic import POINTS, Arithmetic, load
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.stage import Stage
from kowalevski_cas.paper.texts import Printed, Texts

Found = TypeVar("Found")
Key = str | int | Printed | tuple["Key", ...]
"""What a search is for: the kind of search, the claim, and what tells its searches apart."""


class Bench:
    """Stages for one arithmetic and one set of texts, made when they are asked for.

    ``shelf`` holds what searches found, in neutral form, so that a search is run
    once and its result is checked in every arithmetic. With ``explain`` findings
    tell their steps; without ``refute`` nobody looks for points where a
    statement fails, which is enough to ask whether it is true.
    """

    def __init__(
        self,
        arithmetic: str,
        texts: Texts,
        explain: bool = False,
        shelf: dict[str, Any] | None = None,
        stages: dict[Any, Stage] | None = None,
        refute: bool = True,
    ) -> None:
        self.arithmetic = arithmetic
        self.texts = texts
        self.explain = explain
        self.refute = refute
        self._shelf = shelf if shelf is not None else {}
        self._stages = stages if stages is not None else {}
        self._finder: Bench | None = None

    def stage(self, scene: Scene) -> Stage:
        """The stage of a scene; shared by all texts that do not differ on it."""
        key = (self.arithmetic, scene, self.texts.changes(self._places(scene)))
        if key not in self._stages and self.arithmetic in POINTS:
            # Programs know no arithmetic: all that look at points share them.
            shared = ("programs", *key[1:])
            if shared not in self._stages:
                from kowalevski_cas.stage.programs import ProgramStage

                self._stages[shared] = ProgramStage(self.finder.stage(scene))
            self._stages[key] = self._stages[shared]
        elif key not in self._stages:
            kind: Arithmetic = load(self.arithmetic)
            self._stages[key] = Stage(scene, kind, self.texts)
        return self._stages[key].under(self.texts)

    @staticmethod
    @cache
    def _places(scene: Scene) -> frozenset[Printed]:
        return frozenset(scene.places())

    def with_texts(self, texts: Texts, refute: bool = True) -> Bench:
        """A bench for other texts, which shares the stages that stay the same."""
        return Bench(self.arithmetic, texts, False, {}, self._stages, refute)

    @property
    def finder(self) -> Bench:
        """The bench on which searches are made: with FLINT."""
        if self.arithmetic == "flint":
            return self
        if self._finder is None:
            self._finder = Bench("flint", self.texts, False, self._shelf, self._stages, self.refute)
        return self._finder

    def found(self, key: Key, search: Callable[[Bench], Found]) -> Found:
        """What a search found, from the shelf if it was made before."""
        label = "/".join(_labels(key))
        if label not in self._shelf:
            self._shelf[label] = search(self.finder)
        result: Found = self._shelf[label]
        return result

    def found_elements(
        self, key: Key, scene: Scene, search: Callable[[Stage], Sequence[Element] | None]
    ) -> list[Element] | None:
        """Elements that a search found on the stage of a scene, brought into this arithmetic."""

        def neutral(bench: Bench) -> list[Any] | None:
            elements = search(bench.stage(scene))
            return None if elements is None else [element.neutral() for element in elements]

        found = self.found(key, neutral)
        ring = self.stage(scene).ring
        return None if found is None else [ring.from_neutral(n) for n in found]


def _labels(key: Key) -> Iterator[str]:
    if isinstance(key, tuple):
        for part in key:
            yield from _labels(part)
    else:
        yield key.place if isinstance(key, Printed) else str(key)
