"""Invariant relations: the derivatives of some functions are combinations of these functions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of, locus_of
from kowalevski_cas.claims.formulas import equal, equations, matrix_formula, show
from kowalevski_cas.claims.membership import combination
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Derivative, Name, Product
from kowalevski_cas.proof.outcome import Condition, Counterexample, Step, Verdict
from kowalevski_cas.stage import Stage
from kowalevski_cas.paper.texts import Printed

Matrix = list[list[Element]]

ORDERS = 3
"""Up to which order derivatives are looked at for a motion that leaves the set."""


@dataclass(frozen=True, eq=False)
class InvariantRelations(Claim):
    """The printed equations define an invariant set: (F)' = M F with a matrix M that is found."""

    relations: tuple[Printed, ...]
    names: tuple[str, ...]
    main: tuple[tuple[str, ...], ...] = ()

    def decide(self, bench: Bench) -> Finding:
        """Find the cofactor matrix by division and check it; look for points of failure."""
        stage = bench.stage(self.scene)
        matrix = self.matrix(bench)
        if matrix is None:
            found = self._point_of_failure(bench, "refuted", ())
            return refuted(found) if found else Finding(Verdict.UNDECIDED)
        if any(is_nonzero_number(function) for function in self.functions(stage)):
            return self._empty(bench)
        entries = [entry for row in matrix for entry in row]
        conditions = tuple(
            self._where_it_fails(bench, condition)
            for condition in conditions_of([*entries, *self.functions(stage)], stage)
        )
        return green(conditions, self._steps(matrix, stage) if bench.explain else ())

    def _empty(self, bench: Bench) -> Finding:
        """The finding when an equation of the set holds nowhere."""
        found = counterexample(
            bench,
            self.scene,
            (self.id, "empty"),
            lambda stage: [(f, stage.ring.zero) for f in self.functions(stage)
                           if is_nonzero_number(f)],
            words="the two sides of an equation of the set, here as everywhere",
        )  # fmt: skip
        return refuted(found) if found else Finding(Verdict.UNDECIDED)

    def functions(self, stage: Stage) -> list[Element]:
        """The left sides of the equations."""
        return equations(self.relations, stage)

    def rate(self, stage: Stage, index: int, order: int = 1) -> Element:
        """The derivative of one of the functions, of any order."""
        value = self.functions(stage)[index]
        for _ in range(order):
            value = stage.derivative(value)
        return value

    def matrix(self, bench: Bench) -> Matrix | None:
        """The cofactor matrix, checked; ``None`` if there is none."""
        rows = []
        for k in range(len(self.relations)):
            row = combination(
                bench,
                self.scene,
                (self.id, k),
                partial(self.rate, index=k),
                self.functions,
                self.main,
            )
            if row is None:
                return None
            rows.append(row)
        return rows

    def questions(self, bench: Bench) -> Iterator[Question]:
        """Whether the functions do not move where they vanish."""
        stage = bench.stage(self.scene)
        rates = [self.rate(stage, index) for index in range(len(self.relations))]
        yield ask(stage, rates, self.functions)

    def _where_it_fails(self, bench: Bench, condition: Condition) -> Condition:
        """A condition with a point of the set on its locus where the derivative does not vanish."""
        stage = bench.stage(self.scene)
        locus = locus_of(condition, stage)
        if locus is None:
            return condition
        if condition in conditions_of(self.functions(stage), stage):
            return replace(condition, words=f"the relations have no meaning for {locus.words}")
        found = self._point_of_failure(bench, locus.words, locus.equations)
        if found is None:
            return condition
        return replace(condition, words=f"it fails for {locus.words}", witness=found)

    def _point_of_failure(
        self, bench: Bench, key: str, locus: tuple[str, ...]
    ) -> Counterexample | None:
        """A point of the set, on a locus, where a derivative of one of the functions is not zero.

        The first derivative may vanish where the motion leaves the set all the
        same; so derivatives up to :data:`ORDERS` are tried.
        """

        def rates(stage: Stage, index: int, order: int) -> list[tuple[Element, Element]]:
            return [(self.rate(stage, index, order), stage.ring.zero)]

        for order in range(1, ORDERS + 1):
            for k, name in enumerate(self.names):
                found = counterexample(
                    bench,
                    self.scene,
                    (self.id, key, order, k),
                    partial(rates, index=k, order=order),
                    lambda stage: [*stage.equations(locus), *self.functions(stage)],
                    f"the derivative of order {order} of ${name}$ at a point of the set, and zero",
                )
                if found is not None:
                    return found
        return None

    def _steps(self, matrix: Matrix, stage: Stage) -> list[Step]:
        names = [Name(name) for name in self.names]
        rates = matrix_formula([Derivative(name, "prime")] for name in names)
        found = matrix_formula([show(entry, stage) for entry in row] for row in matrix)
        product = Product((found, matrix_formula([name] for name in names)))
        return [Step("The cofactor matrix that the program found:", (equal(rates, product),))]

    def establishes(self) -> Iterator[Printed]:
        yield from self.relations

    def places(self) -> Iterator[Printed]:
        yield from self.relations


def is_nonzero_number(element: Element) -> bool:
    """Whether an element is a number other than zero."""
    parts = element.terms()
    return bool(parts) and all(not any(e) for terms in parts.values() for e in terms)
