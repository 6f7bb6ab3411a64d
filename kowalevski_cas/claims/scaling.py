"""Scalings: units in which the equations have no parameters."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Formula, Relation
from kowalevski_cas.proof.outcome import Verdict
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.stage.field import printed_field

Measure = tuple[tuple[str, ...], int, str]
"""Variables, the power of the unit of time in their unit, and the rest of that unit."""


@dataclass(frozen=True, eq=False)
class Scaling(Claim):
    """In units built on the printed unit of time the equations become those of ``simple``."""

    simple: Scene
    measures: tuple[Measure, ...]

    def decide(self, bench: Bench) -> Finding:
        """Scale the field of the scene and compare it with the simple one."""
        stage = bench.stage(self.scene)
        assert self.printed is not None
        formula = bench.texts.formula(self.printed)
        pairs = self.pairs(formula, stage)
        if all((left - right).is_zero for left, right in pairs):
            return green(conditions_of([x for pair in pairs for x in pair], stage))
        found = counterexample(
            bench, self.scene, self.id, lambda finder: self.pairs(formula, finder),
            words="a component of the scaled equations, and of the simple ones",
        )  # fmt: skip
        return refuted(found) if found else Finding(Verdict.UNDECIDED)

    def pairs(self, formula: Formula, stage: Stage) -> list[tuple[Element, Element]]:
        """The components of the scaled field, and of the simple one."""
        assert not isinstance(formula, Relation)
        time = scalar(formula, stage)
        units = {
            name: time**power * scalar(stage.formula(rest), stage)
            for names, power, rest in self.measures
            for name in names
        }
        own = {name: scalar(stage.formula(name), stage) for name in stage.generators}
        scaled = self._field(
            self.scene, stage, {**own, **{n: own[n] * unit for n, unit in units.items()}}
        )
        simple = self._field(self.simple, stage, own)
        return [(scaled[n] * time * unit.inverse(), simple[n]) for n, unit in units.items()]

    @staticmethod
    def _field(scene: Scene, stage: Stage, values: dict[str, Element]) -> dict[str, Element]:
        """The printed field of a scene at these values of its variables."""
        assert isinstance(scene.field, tuple)
        image = Stage(scene, stage.arithmetic, stage.texts, stage.ring, values)
        return printed_field(scene.field, image)

    def residuals(self, formula: Formula, stage: Stage) -> list[Element]:
        return [left - right for left, right in self.pairs(formula, stage)]

    def scenes(self) -> Iterator[Scene]:
        yield from (self.scene, self.simple)
