"""What every kind of claim has in common."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.notation import Edit, Formula, edits
from kowalevski_cas.proof.outcome import Condition, Correction, Counterexample, Step, Verdict
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.stage import Stage
from kowalevski_cas.paper.texts import Printed, Texts


@dataclass(frozen=True)
class Finding:
    """The verdict on a claim in one arithmetic, with its evidence.

    ``correction`` is the nearest true statement where the claim itself proves
    one; a formula that is one edit away is searched for elsewhere. ``chance`` and
    ``radius`` are those of an outcome.
    """

    verdict: Verdict
    conditions: tuple[Condition, ...] = ()
    steps: tuple[Step, ...] = ()
    counterexample: Counterexample | None = None
    message: str = ""
    correction: Correction | None = None
    chance: float | None = None
    radius: float | None = None


@dataclass(frozen=True)
class Neighbour:
    """A statement that differs a little: a mutant, or a candidate for a correction."""

    words: str
    claim: Claim
    texts: Texts
    printed: Printed | None = None
    edit: Edit | None = None


@dataclass(frozen=True, eq=False)
class Claim(ABC):
    """One statement of the paper, on its scene.

    ``printed`` is the place of the formula, if the claim is one formula;
    ``words`` says what is claimed.
    """

    id: str
    scene: Scene
    printed: Printed | None
    words: str

    @abstractmethod
    def decide(self, bench: Bench) -> Finding:
        """Decide the claim in the arithmetic of the bench."""

    beyond_points = ""
    """What is claimed and cannot be seen at points, if there is something."""

    def residuals(self, formula: Formula, stage: Stage) -> list[Element] | None:
        """Elements that vanish if the formula is true in place of the printed one.

        ``None`` if the kind of claim has no such test, so that a neighbour has
        to be decided in full.
        """
        return None

    def questions(self, bench: Bench) -> Iterator[Question]:
        """What can be asked at points; the claim is false if one answer is no."""
        if self.printed is not None:
            stage = bench.stage(self.scene)
            residuals = self.residuals(bench.texts.formula(self.printed), stage)
            if residuals is not None:
                yield ask(stage, residuals)

    def places(self) -> Iterator[Printed]:
        """The places of the paper that the claim names, its own first; not those of its scene."""
        if self.printed is not None:
            yield self.printed

    def expressions(self) -> Iterator[str]:
        """The expressions, in LaTeX, that the claim names besides those at its places."""
        yield from ()

    def scenes(self) -> Iterator[Scene]:
        """The scenes that the claim needs."""
        yield self.scene

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        """Statements one edit away, the most plausible corrections first."""
        names = frozenset(self.scene.names()) - {*self.scene.undefined}
        for printed in self.establishes():
            for edit in edits(texts.statement(printed), texts.vocabulary, names):
                yield Neighbour(edit.words, self, texts.edited(printed, edit), printed, edit)

    def establishes(self) -> Iterator[Printed]:
        """The places that are right if the claim is."""
        if self.printed is not None:
            yield self.printed


def ask(
    stage: Stage,
    residuals: Sequence[Element] = (),
    given: Callable[[Stage], Sequence[Element]] = lambda stage: (),
    rows: Sequence[Sequence[Element]] = (),
    rank: int = 0,
    somewhere: Sequence[Element] = (),
) -> Question:
    """A question to points of a stage of programs; see :class:`Question`."""
    from kowalevski_cas.stage.programs import ProgramStage, programs

    assert isinstance(stage, ProgramStage)
    return Question(
        stage.programs,
        residuals=programs(residuals),
        given=programs(given(stage)),
        rows=[programs(row) for row in rows],
        rank=rank,
        somewhere=programs(somewhere),
    )


def green(conditions: tuple[Condition, ...], steps: Sequence[Step] = ()) -> Finding:
    """A finding for a statement that holds, perhaps under conditions."""
    verdict = Verdict.CONDITIONAL if conditions else Verdict.PROVED
    return Finding(verdict, conditions, tuple(steps))


def refuted(counterexample: Counterexample, steps: Sequence[Step] = ()) -> Finding:
    """A finding for a statement that an exact point refutes."""
    return Finding(Verdict.REFUTED, (), tuple(steps), counterexample)
