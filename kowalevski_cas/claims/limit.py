"""Limits: a specialisation commutes with the derivation of a cofactor matrix."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import matrix_formula, show
from kowalevski_cas.claims.invariant_relations import InvariantRelations
from kowalevski_cas.claims.membership import combination
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Formula, edits
from kowalevski_cas.proof.outcome import Step, Verdict
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.stage import Stage
from kowalevski_cas.stage.field import time_scale
from kowalevski_cas.paper.texts import Printed, Texts

Matrix = list[list[Element]]


@dataclass(frozen=True, eq=False)
class Limit(Claim):
    r"""The cofactor matrix of ``general`` goes over into the one of ``special``.

    On the scene of the limit let F be the general functions and e those of the
    special system. With F = T e, F' = M F specialised and e' = N e found
    directly, both derivations agree if :math:`\dot T + T N - \kappa M T`
    annihilates e and vanishes where e does; :math:`\kappa` is the ratio of the
    times. (Cofactors are unique only up to syzygies, so identities are compared.)
    """

    general: InvariantRelations
    special: InvariantRelations

    def decide(self, bench: Bench) -> Finding:
        """Specialise the matrix, find the other one, and compare the identities."""
        stage = bench.stage(self.scene)
        matrix = self.general.matrix(bench)
        direct = self.special.matrix(bench)
        if matrix is None:
            return Finding(Verdict.UNDECIDED, message="the general cofactor matrix is missing")
        functions = self.special.functions(stage)
        transition = self._transition(bench)
        if transition is None or direct is None:
            return self._refute(bench)
        assert self.scene.clock is not None
        scale = time_scale(self.scene.clock, stage)
        limit = [[stage.carry(entry) * scale for entry in row] for row in matrix]
        rows = [[stage.carry(entry) for entry in row] for row in direct]
        left, right = _times(transition, rows), _times(limit, transition)
        rest = [
            [stage.derivative(t) + a - b for t, a, b in zip(*line, strict=True)]
            for line in zip(transition, left, right, strict=True)
        ]
        annihilated = all(_applied(row, functions).is_zero for row in rest)
        on_set = all(
            entry.is_zero or self._vanishes(bench, (i, j), entry)
            for i, row in enumerate(rest)
            for j, entry in enumerate(row)
        )
        if not (annihilated and on_set):
            return Finding(Verdict.UNDECIDED, message="the two matrices could not be compared")
        entries = [e for m in (transition, limit, rows) for row in m for e in row]
        steps = [
            Step("The specialised functions through those of the special system:",
                 _shown(transition, stage)),
            Step("The cofactor matrix found directly, with which the specialised one agrees:",
                 _shown(rows, stage)),
        ] if bench.explain else ()  # fmt: skip
        return green(conditions_of(entries, stage), steps)

    beyond_points = "whether the two cofactor matrices agree cannot be seen at points"

    def questions(self, bench: Bench) -> Iterator[Question]:
        """Whether the general functions vanish where the special ones do."""
        stage = bench.stage(self.scene)
        yield ask(stage, self.general.functions(stage), self.special.functions)

    def _transition(self, bench: Bench) -> Matrix | None:
        """The matrix T with F = T e, found by division."""
        rows = []
        for k in range(len(self.general.relations)):
            row = combination(
                bench,
                self.scene,
                (self.id, "transition", k),
                partial(self._general, index=k),
                self.special.functions,
            )
            if row is None:
                return None
            rows.append(row)
        return rows

    def _general(self, stage: Stage, index: int) -> Element:
        return self.general.functions(stage)[index]

    def _vanishes(self, bench: Bench, place: tuple[int, int], entry: Element) -> bool:
        """Whether an entry is a combination of the special functions."""
        neutral = entry.neutral()
        row = combination(
            bench,
            self.scene,
            (self.id, "rest", *place),
            lambda stage: stage.ring.from_neutral(neutral),
            self.special.functions,
        )
        return row is not None

    def _refute(self, bench: Bench) -> Finding:
        found = counterexample(
            bench,
            self.scene,
            self.id,
            lambda stage: [(f, stage.ring.zero) for f in self.general.functions(stage)],
            self.special.functions,
            "a specialised function where the special ones vanish, and zero",
        )
        return refuted(found) if found else Finding(Verdict.UNDECIDED)

    def scenes(self) -> Iterator[Scene]:
        yield from (self.scene, self.general.scene, self.special.scene)

    def places(self) -> Iterator[Printed]:
        yield from (*self.general.places(), *self.special.places())

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        for printed in self.special.relations:
            for edit in edits(texts.statement(printed), texts.vocabulary):
                if edit.kind == "sign":
                    yield Neighbour(edit.words, self, texts.edited(printed, edit), printed, edit)


def _times(left: Matrix, right: Matrix) -> Matrix:
    return [[_applied(row, list(column)) for column in zip(*right, strict=True)] for row in left]


def _applied(row: list[Element], column: list[Element]) -> Element:
    total = row[0].ring.zero
    for a, b in zip(row, column, strict=True):
        total = total + a * b
    return total


def _shown(matrix: Matrix, stage: Stage) -> tuple[Formula, ...]:
    return (matrix_formula([show(entry, stage) for entry in row] for row in matrix),)
