"""The arithmetics of a run: what each of them says of a statement and its evidence."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from kowalevski_cas.algebra import POINTS, load, load_points
from kowalevski_cas.notation import to_plain
from kowalevski_cas.paper.independence import decides
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.examine import Accepted, Unproved, Vacuous
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.verify.outcome import Screened, Verdict
from kowalevski_cas.verify.statement import Statement, Verdicts

if TYPE_CHECKING:
    from kowalevski_cas.problem.sampled import Sampled


Evidence = Callable[[], Verdicts | None]
"""What gives the evidence that there is for a statement."""


class Decided(NamedTuple):
    """A statement with its evidence, and what an arithmetic accepted of it."""

    statement: Statement
    verdicts: Verdicts | None
    accepted: Accepted
    verdict: Verdict
    message: str = ""


class Arithmetics:
    """Several arithmetics, in which each space is evaluated once.

    Args:
        names: of the arithmetics, the first of which has the word.
        seed: chooses the points of those that only screen.
    """

    def __init__(self, names: Sequence[str], seed: int = 1) -> None:
        self.names = tuple(names)
        self._seed = seed
        self._points = {name: load_points(name, seed) for name in names if name in POINTS}
        self._evaluations: dict[tuple[str, Setting], Evaluation] = {}
        self._stages: dict[Setting, Sampled] = {}

    def fresh(self) -> Arithmetics:
        """The same arithmetics, in which nothing is evaluated yet."""
        return Arithmetics(self.names, self._seed)

    def load(self) -> None:
        """Import their libraries, so that no claim is charged for that."""
        for name in self.names:
            (load_points if name in POINTS else load)(name)

    @property
    def exact(self) -> tuple[str, ...]:
        """FLINT, and the other ones that prove."""
        return tuple(dict.fromkeys(("flint", *(n for n in self.names if n not in POINTS))))

    def decide(
        self, statement: Statement, evidence: Evidence, arithmetic: str
    ) -> Decided | Screened:
        """What one arithmetic says of a statement; the evidence is searched for if it needs it."""
        points = self._points.get(arithmetic)
        if points is None:
            return self.judge(statement, evidence(), arithmetic)
        from kowalevski_cas.verify.screen import screen  # proving needs no points

        return screen(statement, evidence, points, self._stages)

    def judge(self, statement: Statement, verdicts: Verdicts | None, arithmetic: str) -> Decided:
        """What an exact arithmetic accepts; raises :class:`Unproved` for evidence that fails."""
        judge = Judge(self._evaluations_in(arithmetic))

        def undecide(message: str) -> Decided:
            return Decided(statement, None, judge.accepted, Verdict.UNDECIDED, message)

        if verdicts is None:
            return undecide("neither a proof nor a point where it fails was found")
        try:
            if isinstance(verdicts, Denial):
                judge.denies(statement.goals[verdicts.goal], verdicts.evidence)
                denied = statement.claimed[verdicts.goal]
                if not (statement.claim.refuted_by(verdicts) and decides(denied)):
                    return undecide("what would prove it is false, which does not refute it")
                return Decided(statement, verdicts, judge.accepted, Verdict.REFUTED)
            for goal, evidence in zip(statement.goals, verdicts, strict=True):
                judge.holds(goal, evidence)
        except Vacuous as error:
            from kowalevski_cas.verify.conditions import (
                divisors_on_set,  # what is decided needs none
            )

            divided = ", ".join(map(to_plain, divisors_on_set(statement.goals, statement.legend)))
            nowhere = f"the motion is divided by {divided}, which vanishes on the whole set"
            return undecide(nowhere if divided else str(error))
        except Unproved as error:
            message = f"the evidence does not prove it ({arithmetic}: {error})"
            raise Unproved(message) from None
        return Decided(statement, verdicts, judge.accepted, Verdict.PROVED)

    def _evaluations_in(self, arithmetic: str) -> Callable[[Setting], Evaluation]:
        """The evaluations of spaces in an arithmetic, each made once."""

        def of(space: Setting) -> Evaluation:
            if arithmetic == "flint":
                return finder_of(space)
            key = (arithmetic, space)
            if key not in self._evaluations:
                made = Evaluation(space, load(arithmetic), others=of)
                self._evaluations[key] = made.adjoin_roots()
            return self._evaluations[key]

        return of
