"""Coefficients: what multiplies a variable in an expression that is linear in it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kowalevski_cas.arithmetic.derivation import along
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import members, show
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Formula, Relation, Sum, Unwritten
from kowalevski_cas.proof.outcome import Step, Verdict
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Printed

Pair = tuple[Element, Element]


@dataclass(frozen=True, eq=False)
class Coefficient(Claim):
    """The coefficient of ``variable``.

    Either the printed equation holds up to unwritten terms that are free of the
    variable; or, with ``derivative_of``, the derivative of the expression printed
    there is linear in the variable, with the printed coefficient.
    """

    variable: str
    derivative_of: Printed | None = None

    def decide(self, bench: Bench) -> Finding:
        """Compare partial derivatives by the variable."""
        stage = bench.stage(self.scene)
        assert self.printed is not None
        formula = bench.texts.formula(self.printed)
        pairs = self.pairs(formula, stage)
        shown = show(pairs[0][0], stage)
        steps = (
            [Step(f"The coefficient of ${self.variable}$, as generated:", (shown,))]
            if bench.explain
            else ()
        )
        if all((left - right).is_zero for left, right in pairs):
            return green(conditions_of([x for pair in pairs for x in pair], stage), steps)
        found = counterexample(
            bench, self.scene, self.id, lambda finder: self.pairs(formula, finder)
        )
        return refuted(found, steps) if found else Finding(Verdict.UNDECIDED)

    def pairs(self, formula: Formula, stage: Stage) -> list[Pair]:
        """Coefficients that have to be equal, the generated one first."""
        chain = members(formula) if isinstance(formula, Relation) else [formula]
        if self.derivative_of is None:
            left, right = (scalar(_written(member), stage) for member in chain)
            if not any(_has_unwritten(member) for member in chain):
                return [(left, right)]
            return [(self._partial(left, stage), self._partial(right, stage))]
        expression = stage.texts.formula(self.derivative_of)
        generated = self._partial(stage.derivative(scalar(expression, stage)), stage)
        pairs = [(generated, scalar(member, stage)) for member in chain]
        return [*pairs, (self._partial(generated, stage), stage.ring.zero)]

    def residuals(self, formula: Formula, stage: Stage) -> list[Element]:
        return [left - right for left, right in self.pairs(formula, stage)]

    def _partial(self, element: Element, stage: Stage) -> Element:
        return along(element, {self.variable: stage.ring.one})

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        if self.derivative_of is not None:
            yield self.derivative_of


def _has_unwritten(formula: Formula) -> bool:
    return isinstance(formula, Sum) and any(isinstance(t, Unwritten) for t in formula.terms)


def _written(formula: Formula) -> Formula:
    """A sum without the terms that the author does not print."""
    if isinstance(formula, Sum):
        return Sum(tuple(term for term in formula.terms if not isinstance(term, Unwritten)))
    return formula
