"""Equivalent equations: one left side is the other times a factor that does not vanish."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import equation, equations, show
from kowalevski_cas.claims.membership import combination
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.proof.outcome import Step, Verdict
from kowalevski_cas.stage import Stage
from kowalevski_cas.paper.texts import Printed


@dataclass(frozen=True, eq=False)
class Equivalence(Claim):
    """The printed equation says the same as the equation ``to``; the factor between is found."""

    to: Printed

    def decide(self, bench: Bench) -> Finding:
        """Divide one left side by the other; the factor and its inverse name the conditions."""
        stage = bench.stage(self.scene)
        factor = self._factor(bench)
        if factor is None:
            return self._refute(bench)
        conditions = conditions_of([factor, factor.inverse(), *self._sides(stage)], stage)
        steps = (
            [Step("The left side is that of the other equation times", (show(factor, stage),))]
            if bench.explain
            else ()
        )
        return green(conditions, steps)

    def _factor(self, bench: Bench) -> Element | None:
        """The left side of the printed equation over that of the other one."""
        for top, bottom in ((self._printed, self.to), (self.to, self._printed)):
            found = combination(
                bench,
                self.scene,
                (self.id, top.place),
                partial(equation, top),
                partial(equations, [bottom]),
            )
            if found and not found[0].is_zero:
                return found[0] if top is self._printed else found[0].inverse()
        return None

    @property
    def _printed(self) -> Printed:
        assert self.printed is not None
        return self.printed

    def _sides(self, stage: Stage) -> list[Element]:
        return [equation(self._printed, stage), equation(self.to, stage)]

    def questions(self, bench: Bench) -> Iterator[Question]:
        """Whether each equation holds where the other one does."""
        stage = bench.stage(self.scene)
        for holds, follows in ((self.to, self._printed), (self._printed, self.to)):
            yield ask(stage, [equation(follows, stage)], partial(equations, [holds]))

    def _refute(self, bench: Bench) -> Finding:
        """A point where one equation holds and the other does not, in either direction."""
        for holds, fails in ((self.to, self._printed), (self._printed, self.to)):
            found = counterexample(
                bench,
                self.scene,
                (self.id, holds.place),
                partial(_against_zero, fails),
                partial(equations, [holds]),
                f"the left side of one equation where the other one ({holds.place}) holds; zero",
            )
            if found is not None:
                return refuted(found)
        return Finding(Verdict.UNDECIDED, message="neither a factor nor a point was found")

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield self.to


def _against_zero(printed: Printed, stage: Stage) -> list[tuple[Element, Element]]:
    return [(equation(printed, stage), stage.ring.zero)]
