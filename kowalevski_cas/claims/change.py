"""Changes of variables: invertible, with the equations that they lead to, in the right unit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, ask, green, refuted
from kowalevski_cas.claims.formulas import equal, show
from kowalevski_cas.claims.identity import Identity, Pair
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import NotationError
from kowalevski_cas.proof.outcome import Step, Verdict
from kowalevski_cas.paper.scene import Change, Scene
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.stage.change import Carrier
from kowalevski_cas.paper.texts import Printed, Texts


@dataclass(frozen=True, eq=False)
class ChangedEquation(Identity):
    """A printed equation of motion holds in the new variables, and in the old ones.

    In the new scene the field is derived through the inverse change; in
    ``old``, where the new variables are defined by the change, the same
    equation is differentiated directly. Both have to agree.
    """

    old: Scene

    def decide(self, bench: Bench) -> Finding:
        """Decide the identity on both scenes."""
        forward = super().decide(bench)
        backward = Identity(f"{self.id}/old", self.old, self.printed, self.words).decide(bench)
        if forward.verdict.green != backward.verdict.green:
            return Finding(Verdict.ERROR, message="the two directions of the change disagree")
        return forward

    def questions(self, bench: Bench) -> Iterator[Question]:
        for scene in (self.scene, self.old):
            yield from Identity(self.id, scene, self.printed, self.words).questions(bench)

    def scenes(self) -> Iterator[Scene]:
        yield from (self.scene, self.old)


@dataclass(frozen=True, eq=False)
class InvertibleChange(Claim):
    """The change to ``scene`` has an inverse, and ``pairs`` are conjugates of each other."""

    old: Scene
    pairs: tuple[tuple[str, str], ...]

    def decide(self, bench: Bench) -> Finding:
        """Solve for the old variables; conjugate the new ones."""
        stage = bench.stage(self.scene)
        change = self.scene.field
        assert isinstance(change, Change)
        try:
            inverse = Carrier(change, stage).inverse()
        except StageError as error:
            return Finding(Verdict.REFUTED, message=str(error))
        old = bench.stage(self.old)
        if not all((left - right).is_zero for left, right in self._pairs(old)):
            found = counterexample(
                bench,
                self.old,
                self.id,
                self._pairs,
                words="the variable, and its partner conjugated",
            )
            return refuted(found) if found else Finding(Verdict.UNDECIDED)
        steps = []
        if bench.explain:
            shown = tuple(
                equal(stage.formula(name), show(value, stage)) for name, value in inverse.items()
            )
            steps.append(Step("The inverse, as solved for:", shown))
        return green((), steps)

    def questions(self, bench: Bench) -> Iterator[Question]:
        # The field of the scene is derived through the inverse, or there is none.
        old, _ = bench.stage(self.old), bench.stage(self.scene).field
        yield ask(old, [left - right for left, right in self._pairs(old)])

    def establishes(self) -> Iterator[Printed]:
        change = self.scene.field
        assert isinstance(change, Change)
        yield from change.formulas

    def expressions(self) -> Iterator[str]:
        for pair in self.pairs:
            yield from pair

    def _pairs(self, stage: Stage) -> list[Pair]:
        return [
            (scalar(stage.formula(second), stage), scalar(stage.formula(first), stage, True))
            for first, second in self.pairs
        ]

    def scenes(self) -> Iterator[Scene]:
        yield from (self.scene, self.old)

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        first = self.pairs[0][0]
        claim = replace(self, pairs=((first, first),))
        yield Neighbour(f"{first} as its own conjugate", claim, texts)


@dataclass(frozen=True, eq=False)
class Unit(Claim):
    """The printed square of the imaginary unit makes the change lead to the printed ``rows``.

    A row may be misprinted itself; so the unit is right if the opposite sign does
    not make more rows true, and at least one row is.
    """

    rows: tuple[Printed, ...]

    def decide(self, bench: Bench) -> Finding:
        """Count the rows that hold with the printed unit and with its neighbours."""
        own = self._rows_that_hold(bench)
        others = [bench.with_texts(n.texts) for n in self.neighbours(bench.texts)]
        best = max((self._rows_that_hold(other) for other in others), key=len, default=[])
        if own and len(own) >= len(best):
            return green(())
        for row in best or self.rows:
            finding = self._row(row).decide(bench)
            if finding.counterexample is not None:
                words = f"the two sides of {row.place} after the change with this unit"
                return refuted(replace(finding.counterexample, words=words))
        return Finding(Verdict.UNDECIDED)

    def questions(self, bench: Bench) -> Iterator[Question]:
        """Whether rows hold that have to: those of the printed unit, or those of a better one."""
        own = self._rows_that_hold(bench)
        others = [bench.with_texts(n.texts) for n in self.neighbours(bench.texts)]
        best = max((self._rows_that_hold(other) for other in others), key=len, default=[])
        for row in own if own and len(own) >= len(best) else best or self.rows:
            yield from self._row(row).questions(bench)

    def _row(self, row: Printed) -> Identity:
        return Identity(f"{self.id}/{row.place}", self.scene, row, "")

    def _rows_that_hold(self, bench: Bench) -> list[Printed]:
        stage = bench.stage(self.scene)
        found = []
        for row in self.rows:
            try:
                pairs = self._row(row).pairs(bench.texts.formula(row), stage)
            except (StageError, NotationError):
                continue
            if all((left - right).is_zero for left, right in pairs):
                found.append(row)
        return found

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        """The other sign on the right side."""
        assert self.printed is not None
        for neighbour in super().neighbours(texts):
            edit = neighbour.edit
            if edit and edit.path[:1] == (1,) and edit.kind == "sign":
                yield neighbour
