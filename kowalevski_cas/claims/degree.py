"""Degree: how a variable enters the derivative of everything that is free of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from kowalevski_cas.arithmetic.derivation import along
from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.proof.outcome import Verdict
from kowalevski_cas.stage import Stage
from kowalevski_cas.paper.texts import Texts


@dataclass(frozen=True, eq=False)
class Degree(Claim):
    r"""The derivative of any expression free of ``variable`` has at most this degree in it.

    By the chain rule this is so exactly if every component of the field but the
    variable's own has at most this degree: the derivative is
    :math:`\sum_v \partial f/\partial v\; \dot v`, in which f may be any v.
    """

    variable: str
    degree: int

    def decide(self, bench: Bench) -> Finding:
        """Differentiate each component by the variable once more than the degree."""
        stage = bench.stage(self.scene)
        rest = self._derivatives(stage)
        if all(element.is_zero for element in rest):
            return green(conditions_of(rest, stage))
        found = counterexample(
            bench,
            self.scene,
            self.id,
            lambda finder: [(e, finder.ring.zero) for e in self._derivatives(finder)],
            words=f"the partial derivative of order {self.degree + 1} of a component, and zero",
        )
        return refuted(found) if found else Finding(Verdict.UNDECIDED)

    def questions(self, bench: Bench) -> Iterator[Question]:
        stage = bench.stage(self.scene)
        yield ask(stage, self._derivatives(stage))

    def _derivatives(self, stage: Stage) -> list[Element]:
        elements = [x for name, x in stage.field.items() if name != self.variable]
        for _ in range(self.degree + 1):
            elements = [along(x, {self.variable: stage.ring.one}) for x in elements]
        return elements

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        claim = replace(self, degree=self.degree - 1)
        yield Neighbour(f"degree {claim.degree} instead of {self.degree}", claim, texts)
