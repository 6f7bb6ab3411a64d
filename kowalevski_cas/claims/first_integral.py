"""First integrals: an expression does not move, everywhere or on an invariant set."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import equations, members, show
from kowalevski_cas.claims.membership import combination, combination_steps, label
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Formula, Name, Power, Relation, to_latex
from kowalevski_cas.proof.outcome import Counterexample, Step, Verdict
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Printed


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
        rate = self.rate(stage)
        if not self.on or rate.is_zero:
            return self._everywhere(bench, rate, stage)
        off = self._moves(bench, (), "the derivative off the set, and zero")
        if bench.refute and off is None:
            return Finding(Verdict.UNDECIDED, message="no point was found where it moves")
        found = combination(bench, self.scene, self.id, self.rate, self.generators, self.main)
        if found is None:
            on_set = self._moves(bench, self.on, "the derivative on the set, and zero")
            return refuted(on_set) if on_set else Finding(Verdict.UNDECIDED)
        steps: list[Step] = []
        if bench.explain and off is not None:
            names = [(label(printed),) for printed in self.on]
            value = off.left if isinstance(off.left, str) else to_latex(off.left)
            steps = [
                Step("The derivative along the vector field, as generated:", (show(rate, stage),)),
                *combination_steps("it", found, stage, names),
                Step(f"Off the set it moves: at a point there the derivative is ${value}$."),
            ]
        return green(conditions_of(found, stage), steps)

    def rate(self, stage: Stage) -> Element:
        """The derivative of the printed expression; of a member that moves, if one does."""
        assert self.printed is not None
        rates = self._rates(stage.texts.formula(self.printed), stage)
        return next((rate for rate in rates if not rate.is_zero), rates[0])

    def _everywhere(self, bench: Bench, rate: Element, stage: Stage) -> Finding:
        """The finding when no set is named, or none is needed."""
        if not rate.is_zero:
            moves = self._moves(bench, (), "the derivative, and zero")
            return refuted(moves) if moves else Finding(Verdict.UNDECIDED)
        if self.on:
            message = "it is a first integral off the set as well"
            return Finding(Verdict.REFUTED, message=message)
        return green(conditions_of([rate], stage))

    def _moves(self, bench: Bench, on: tuple[Printed, ...], words: str) -> Counterexample | None:
        """An exact point, on a set, where the derivative does not vanish."""
        return counterexample(
            bench,
            self.scene,
            (self.id, on),
            lambda stage: [(self.rate(stage), stage.ring.zero)],
            partial(equations, on),
            words,
        )

    def generators(self, stage: Stage) -> Sequence[Element]:
        """The left sides of the equations of the set."""
        return equations(self.on, stage)

    def residuals(self, formula: Formula, stage: Stage) -> list[Element] | None:
        return None if self.on else self._rates(formula, stage)

    def questions(self, bench: Bench) -> Iterator[Question]:
        if not self.on:
            yield from super().questions(bench)
            return
        stage = bench.stage(self.scene)
        yield ask(stage, somewhere=[self.rate(stage)])
        yield ask(stage, [self.rate(stage)], self.generators)

    def _rates(self, formula: Formula, stage: Stage) -> list[Element]:
        return [stage.derivative(scalar(m, stage)) for m in self.constants(stage, formula)]

    def constants(self, stage: Stage, formula: Formula) -> list[Formula]:
        """The members that have to be constant; not names that are defined by the others."""
        chain = members(formula) if isinstance(formula, Relation) else [formula]
        here = {n for n, place in self.scene.definitions.items() if place == self.printed}
        chain = [m for m in chain if not (isinstance(m, Name) and m.name in here)] or chain
        known = [member for member in chain if not _is_level(member, stage)]
        return known or chain


def _is_level(formula: Formula, stage: Stage) -> bool:
    """Whether a member is a name, or its power, for the value of the integral only."""
    if isinstance(formula, Power):
        formula = formula.base
    return isinstance(formula, Name) and not stage.knows(formula.name)
