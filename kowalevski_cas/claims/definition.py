"""Definitions: what a printed formula defines makes an equation true."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import ask
from kowalevski_cas.claims.identity import Identity, Pair
from kowalevski_cas.notation import Formula
from kowalevski_cas.proof.outcome import Step
from kowalevski_cas.paper.scene import head
from kowalevski_cas.stage import Stage
from kowalevski_cas.paper.texts import Printed


@dataclass(frozen=True, eq=False)
class Definition(Identity):
    """With the printed definition, on which the scene rests, ``equation`` holds.

    So a closed form solves a differential equation, or new variables separate one.
    """

    equation: Printed

    @property
    def stated(self) -> Printed:
        return self.equation

    def pairs(self, formula: Formula, stage: Stage) -> list[Pair]:
        """The members of the equation, and those of the definition that have a value."""
        assert self.printed is not None
        pairs = super().pairs(formula, stage)
        names = (n for n, place in self.scene.definitions.items() if place == self.printed)
        if any(head(name)[1] for name in names):
            return pairs  # a function has values for its arguments only
        return [*pairs, *super().pairs(stage.texts.formula(self.printed), stage)]

    def residuals(self, formula: Formula, stage: Stage) -> list[Element] | None:
        return None  # another definition is another scene

    def questions(self, bench: Bench) -> Iterator[Question]:
        stage = bench.stage(self.scene)
        pairs = self.pairs(bench.texts.formula(self.equation), stage)
        yield ask(stage, [left - right for left, right in pairs])

    def steps(self, formula: Formula, stage: Stage) -> Sequence[Step]:
        """The equation, which the report prints nowhere else for this claim."""
        return [Step("With it the program proves:", (formula,))]

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield self.equation
