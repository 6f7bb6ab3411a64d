"""Identities: the members of a printed chain of equalities are equal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import components, equal, members, show
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Constant, Derivative, Formula, Relation, to_latex
from kowalevski_cas.proof.outcome import Step, Verdict
from kowalevski_cas.stage import Stage, StageError, evaluate
from kowalevski_cas.paper.texts import Printed

Pair = tuple[Element, Element]

LONGEST = 24
"""How many terms a derivative has at most that is shown."""


@dataclass(frozen=True, eq=False)
class Identity(Claim):
    """All members of a printed chain are equal; ``= const`` says that they do not move."""

    def decide(self, bench: Bench) -> Finding:
        """Prove by bringing every difference to zero; refute at an exact point."""
        stage = bench.stage(self.scene)
        formula = bench.texts.formula(self.stated)
        pairs = self.pairs(formula, stage)
        steps = self.steps(formula, stage) if bench.explain else ()
        if all((left - right).is_zero for left, right in pairs):
            return green(conditions_of([x for pair in pairs for x in pair], stage), steps)
        found = counterexample(
            bench, self.scene, self.id, lambda finder: self.pairs(formula, finder)
        )
        if found is None:
            return Finding(Verdict.UNDECIDED, message="no exact point was found")
        return refuted(found, steps)

    @property
    def stated(self) -> Printed:
        """The place of the equation that has to hold."""
        assert self.printed is not None
        return self.printed

    def pairs(self, formula: Formula, stage: Stage) -> list[Pair]:
        """What has to be equal, component by component."""
        if not isinstance(formula, Relation):
            raise StageError(f"an equation is expected instead of {to_latex(formula)}")
        if r"\ne" in formula.signs:
            raise StageError(f"an equality is expected instead of {to_latex(formula)}")
        values = [components(evaluate(member, stage)) for member in members(formula)]
        pairs = [pair for left, right in pairwise(values) for pair in zip(left, right, strict=True)]
        if isinstance(formula.members[-1], Constant):
            pairs += [(stage.derivative(value), stage.ring.zero) for value in values[0]]
        return pairs

    def residuals(self, formula: Formula, stage: Stage) -> list[Element] | None:
        return [left - right for left, right in self.pairs(formula, stage)]

    def steps(self, formula: Formula, stage: Stage) -> Sequence[Step]:
        """The derivatives that the program generated for the left side."""
        assert isinstance(formula, Relation)
        left = formula.members[0]
        if not _differentiates(left):
            return ()
        steps = []
        for value in components(evaluate(left, stage)):
            words = "The derivative along the vector field, as generated"
            terms = sum(map(len, value.terms().values()))
            if terms > LONGEST:
                steps.append(Step(f"{words}, has {terms} terms."))
            else:
                steps.append(Step(f"{words}:", (equal(left, show(value, stage)),)))
        return steps


def _differentiates(formula: Formula) -> bool:
    return isinstance(formula, Derivative) or any(map(_differentiates, formula.children()))
