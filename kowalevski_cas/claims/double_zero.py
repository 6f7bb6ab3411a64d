"""Double zeros: an expression vanishes with its gradient wherever given equations hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations_with_replacement

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import combined, equations
from kowalevski_cas.claims.membership import combination, label
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Relation
from kowalevski_cas.proof.outcome import Step, Verdict
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.paper.texts import Printed


@dataclass(frozen=True, eq=False)
class DoubleZero(Claim):
    """The printed expression is a quadratic form in the left sides of the ``given`` equations.

    So it vanishes with all its partial derivatives by the variables where they hold.
    """

    given: tuple[Printed, ...]
    main: tuple[tuple[str, ...], ...] = ()

    def decide(self, bench: Bench) -> Finding:
        """Find the quadratic form by division; else a point where a derivative is not zero."""
        stage = bench.stage(self.scene)
        form = self.form(bench)
        if form is None:
            found = (
                counterexample(
                    bench,
                    self.scene,
                    (self.id, k),
                    partial(self.against_zero, k),
                    self.generators,
                    "the expression, or a partial derivative, where the given equations hold; zero",
                )
                for k in range(len(self.vanishing(stage)))
            )
            first = next((f for f in found if f is not None), None)
            return refuted(first) if first else Finding(Verdict.UNDECIDED)
        return green(conditions_of(form, stage), self._steps(form, stage) if bench.explain else ())

    def form(self, bench: Bench) -> list[Element] | None:
        """The coefficients of the quadratic form, checked."""
        return combination(
            bench, self.scene, self.id, self.value, self.products, self.main, self.generators
        )

    def value(self, stage: Stage) -> Element:
        """The printed expression."""
        assert self.printed is not None
        formula = stage.texts.formula(self.printed)
        if isinstance(formula, Relation):
            raise StageError(f"an expression is expected at {self.printed.place}")
        return scalar(formula, stage)

    def generators(self, stage: Stage) -> list[Element]:
        """The left sides of the given equations."""
        return equations(self.given, stage)

    def products(self, stage: Stage) -> list[Element]:
        """The products of two of them."""
        pairs = combinations_with_replacement(self.generators(stage), 2)
        return [first * second for first, second in pairs]

    def vanishing(self, stage: Stage) -> list[Element]:
        """The expression and its gradient."""
        value = self.value(stage)
        return [value, *gradient(value, stage.scene.variables)]

    def against_zero(self, index: int, stage: Stage) -> list[tuple[Element, Element]]:
        """The expression (0) or a partial derivative, and zero."""
        return [(self.vanishing(stage)[index], stage.ring.zero)]

    def questions(self, bench: Bench) -> Iterator[Question]:
        stage = bench.stage(self.scene)
        yield ask(stage, self.vanishing(stage), self.generators)

    def _steps(self, form: Sequence[Element], stage: Stage) -> list[Step]:
        pairs = combinations_with_replacement(map(label, self.given), 2)
        return [Step("The quadratic form that division found:", (combined(form, pairs, stage),))]

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield from self.given
