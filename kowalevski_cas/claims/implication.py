"""Implications: an equation holds wherever given equations hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of, locus_of
from kowalevski_cas.claims.formulas import equations
from kowalevski_cas.claims.membership import combination, combination_steps, label
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Formula, Relation
from kowalevski_cas.proof.outcome import Condition, Step, Verdict
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.paper.texts import Printed


@dataclass(frozen=True, eq=False)
class Implication(Claim):
    """The printed equation (or expression, equal to zero) follows from the ``given`` ones.

    With a ``root``, it follows for one of the two values of this root, and for
    the same one as the equations in ``together``.
    """

    given: tuple[Printed, ...]
    root: str | None = None
    together: tuple[Printed, ...] = ()
    main: tuple[tuple[str, ...], ...] = ()

    def decide(self, bench: Bench) -> Finding:
        """Find the combination of the given equations, and try the places that it leaves out."""
        stage = bench.stage(self.scene)
        targets = self._targets(stage)
        rows = []
        for k in range(len(targets)):
            row = combination(
                bench,
                self.scene,
                (self.id, k),
                partial(self._target, index=k),
                self.generators,
                self.main,
            )
            if row is None:
                return self._refute(bench)
            rows.append(row)
        entries = [entry for row in rows for entry in row]
        steps: list[Step] = []
        if bench.explain:
            names = [(label(printed),) for printed in self.given]
            steps = combination_steps("left minus right side", rows[0], stage, names)
        conditions = []
        for condition in conditions_of([*entries, *targets], stage):
            kept, note = self._on_locus(bench, condition)
            conditions += kept
            steps += note
        return green(tuple(conditions), steps)

    def generators(self, stage: Stage) -> list[Element]:
        """The left minus the right sides of the given equations."""
        return equations(self.given, stage)

    def value(self, stage: Stage, formula: Formula | None = None) -> Element:
        """What has to vanish."""
        assert self.printed is not None
        formula = formula or stage.texts.formula(self.printed)
        if not isinstance(formula, Relation):
            return scalar(formula, stage)
        if len(formula.members) != 2 or r"\ne" in formula.signs:
            raise StageError(f"an equation with two sides is expected for {self.id}")
        left, right = formula.members
        return scalar(left, stage) - scalar(right, stage)

    def _targets(self, stage: Stage) -> list[Element]:
        value = self.value(stage)
        if self.root is None:
            return [value]
        bit = stage.ring.roots.index(self.root)
        others = [value, *equations(self.together, stage)]
        return [value * other.conjugate_root(bit) for other in others]

    def _target(self, stage: Stage, index: int) -> Element:
        return self._targets(stage)[index]

    def _on_locus(self, bench: Bench, condition: Condition) -> tuple[list[Condition], list[Step]]:
        """Whether the statement holds on the locus that a condition leaves out, after all."""
        locus = locus_of(condition, bench.stage(self.scene))
        if locus is None or self.root is not None:
            return [condition], []

        def generators(stage: Stage) -> Sequence[Element]:
            return [*stage.equations(locus.equations), *self.generators(stage)]

        row = combination(bench, self.scene, (self.id, locus.words), self.value, generators)
        if row is None or any(cofactor.denominator for cofactor in row):
            return [condition], []
        return [], [Step(f"For {locus.words} it holds as well, by a separate division.")]

    def questions(self, bench: Bench) -> Iterator[Question]:
        stage = bench.stage(self.scene)
        yield ask(stage, self._targets(stage), self.generators)

    def _refute(self, bench: Bench) -> Finding:
        def pairs(stage: Stage) -> list[tuple[Element, Element]]:
            return [(target, stage.ring.zero) for target in self._targets(stage)]

        found = counterexample(
            bench, self.scene, self.id, pairs, self.generators,
            "left minus right side where the given equations hold, and zero",
        )  # fmt: skip
        return refuted(found) if found else Finding(Verdict.UNDECIDED)

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield from (*self.given, *self.together)
