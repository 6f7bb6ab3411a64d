"""Reality: expressions that are real or purely imaginary on real motions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.proof.outcome import Verdict
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Texts


@dataclass(frozen=True, eq=False)
class Reality(Claim):
    """Some expressions equal their conjugates, others are the negatives of theirs."""

    real: tuple[str, ...]
    imaginary: tuple[str, ...]

    def decide(self, bench: Bench) -> Finding:
        """Compare each expression with its conjugate."""
        stage = bench.stage(self.scene)
        pairs = self._pairs(stage)
        if all((left - right).is_zero for left, right in pairs):
            return green(conditions_of([x for pair in pairs for x in pair], stage))
        found = counterexample(
            bench,
            self.scene,
            self.id,
            self._pairs,
            words="the expression, and what it should equal",
        )
        return refuted(found) if found else Finding(Verdict.UNDECIDED)

    def questions(self, bench: Bench) -> Iterator[Question]:
        stage = bench.stage(self.scene)
        yield ask(stage, [left - right for left, right in self._pairs(stage)])

    def _pairs(self, stage: Stage) -> list[tuple[Element, Element]]:
        pairs = []
        for tex in self.real:
            formula = stage.formula(tex)
            pairs.append((scalar(formula, stage), scalar(formula, stage, True)))
        for tex in self.imaginary:
            formula = stage.formula(tex)
            pairs.append((scalar(formula, stage), -scalar(formula, stage, True)))
        return pairs

    def expressions(self) -> Iterator[str]:
        yield from (*self.real, *self.imaginary)

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        for tex in self.real:
            rest = tuple(t for t in self.real if t != tex)
            claim = replace(self, real=rest, imaginary=(*self.imaginary, tex))
            yield Neighbour(f"{tex} imaginary instead of real", claim, texts)
        for tex in self.imaginary:
            rest = tuple(t for t in self.imaginary if t != tex)
            claim = replace(self, imaginary=rest, real=(*self.real, tex))
            yield Neighbour(f"{tex} real instead of imaginary", claim, texts)
