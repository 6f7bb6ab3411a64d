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
from kowalevski_cas.proof.outcome import Counterexample, Step, Verdict
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
        formula = bench.texts.formula(self.printed)
        rates = self.residuals(formula, stage)
        steps = [Step("The derivative along the vector field, as generated:", show(r, stage))
                 for r in rates] if bench.explain and self.on else []  # fmt: skip
        if not self.on or all(rate.is_zero for rate in rates):
            return self._everywhere(bench, rates, stage)
        off = self._moves(bench, (), "the derivative off the set, and zero")
        if bench.refute and off is None:
            return Finding(Verdict.UNDECIDED, message="no point was found where it moves")
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
                assert off is not None
                steps.append(Step(f"Off the set it moves: at a point there the derivative is ${off.left}$."))
            return green(conditions_of(entries, stage), steps)
        on_set = self._moves(bench, self.on, "the derivative on the set, and zero")
        return refuted(on_set, steps) if on_set else Finding(Verdict.UNDECIDED)

    def _everywhere(self, bench: Bench, rates: list[Element], stage: Stage) -> Finding:
        """The finding when no set is named, or none is needed."""
        if any(not rate.is_zero for rate in rates):
            moves = self._moves(bench, (), "the derivative, and zero")
            return refuted(moves) if moves else Finding(Verdict.UNDECIDED)
        if self.on:
            message = "it is a first integral off the set as well"
            return Finding(Verdict.REFUTED, message=message)
        return green(conditions_of(rates, stage))

    def _moves(
        self, bench: Bench, on: tuple[Printed, ...], words: str
    ) -> Counterexample | None:
        """An exact point, on a set, where the derivative does not vanish."""
        assert self.printed is not None
        formula = bench.texts.formula(self.printed)
        return counterexample(
            bench,
            self.scene,
            (self.id, on),
            lambda finder: [(r, finder.ring.zero) for r in self.residuals(formula, finder)],
            lambda finder: [equation(printed, finder) for printed in on],
            words,
        )

    def generators(self, stage: Stage) -> Sequence[Element]:
        """The left sides of the equations of the set."""
        return [equation(printed, stage) for printed in self.on]

    def residuals(self, formula: Formula, stage: Stage) -> list[Element]:
        if isinstance(formula, Relation):
            formula = next(m for m in members(formula) if not isinstance(m, Name))
        return [stage.derivative(scalar(formula, stage))]
