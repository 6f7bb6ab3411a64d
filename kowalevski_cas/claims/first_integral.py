"""First integrals: an expression does not move, everywhere or on an invariant set."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import (
    Claim,
    Finding,
    conditions_of,
    counterexample,
    equation,
    green,
    members,
    refuted,
    show,
)
from kowalevski_cas.claims.membership import combination, combination_steps
from kowalevski_cas.notation import Formula, Name, Relation
from kowalevski_cas.proof.outcome import Step, Verdict
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.texts import Printed


@dataclass(frozen=True, eq=False)
class FirstIntegral(Claim):
    """The printed expression is constant along every motion on the set ``on``.

    With a set, the claim includes that it is not constant off the set.
    """

    on: tuple[Printed, ...] = ()
    main: tuple[tuple[str, ...], ...] = ()

    def decide(self, bench: Bench) -> Finding:
        """Differentiate; on a set, divide the derivative by its equations."""
        stage = bench.stage(self.scene)
        assert self.printed is not None
        formula = bench.texts.statement(self.printed).formula
        rates = self.residuals(formula, stage)
        steps = [Step("The derivative along the vector field, as generated:", show(r, stage))
                 for r in rates] if bench.explain and self.on else []  # fmt: skip
        off = counterexample(
            bench,
            self.scene,
            (self.id, "off"),
            lambda finder: [(r, finder.ring.zero) for r in self.residuals(formula, finder)],
            words="the derivative, and zero",
        )
        if not self.on:
            if all(rate.is_zero for rate in rates):
                return green(conditions_of(rates, stage))
            return refuted(off) if off else Finding(Verdict.UNDECIDED)
        if off is None:
            return Finding(
                Verdict.REFUTED, message="it is a first integral off the set as well", steps=tuple(steps)
            )
        found = [
            combination(
                bench,
                self.scene,
                (self.id, k),
                lambda finder, k=k: self.residuals(formula, finder)[k],
                self.generators,
                self.main,
            )
            for k in range(len(rates))
        ]
        if all(row is not None for row in found):
            entries = [entry for row in found if row for entry in row]
            if bench.explain:
                steps += combination_steps("it", found[0] or [], stage)
                steps.append(Step("Off the set it moves.", ""))
            return green(conditions_of(entries, stage), steps)
        on_set = counterexample(
            bench,
            self.scene,
            (self.id, "on"),
            lambda finder: [(r, finder.ring.zero) for r in self.residuals(formula, finder)],
            self.generators,
            "the derivative on the set, and zero",
        )
        return refuted(on_set, steps) if on_set else Finding(Verdict.UNDECIDED)

    def generators(self, stage: Stage) -> Sequence[Element]:
        """The left sides of the equations of the set."""
        return [equation(printed, stage) for printed in self.on]

    def residuals(self, formula: Formula, stage: Stage) -> list[Element]:
        if isinstance(formula, Relation):
            formula = next(m for m in members(formula) if not isinstance(m, Name))
        return [stage.derivative(scalar(formula, stage))]
