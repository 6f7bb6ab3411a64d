"""How one claim is decided: what it says, its evidence, its outcome, within the time for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from math import inf
from traceback import format_exc
from typing import Protocol

from kowalevski_cas.limits import RUN_OVER, ProcessDied, clock, time_limit
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.archive import Archive
from kowalevski_cas.verify.arithmetics import Arithmetics, Decided
from kowalevski_cas.verify.confirm import Disagreement
from kowalevski_cas.verify.corrector import Corrector
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import CORRECTED, Correction, Outcome, Screened, Verdict
from kowalevski_cas.verify.outcome_writer import OutcomeWriter
from kowalevski_cas.verify.statement import Statement

FRAMES = 20
"""The innermost calls of a stack that are shown."""

PROVING = 3
"""How many times as long as the search for a correction its proof may take with it."""

LEAST = 0.5
"""Seconds for a correction, however little the refutation has left."""


class Corrections(Protocol):
    """Who knows corrections, and which of them are accepted."""

    def known(self, printed: Statement) -> Sequence[Correction]:
        """The corrections of a refuted statement that need no search."""

    def accept(self, claim: Claim, outcome: Outcome) -> Outcome:
        """The outcome for a claim, with its correction accepted."""


class Decider:
    """Claims under an interpretation, their evidence from an archive or a search.

    Args:
        interpretation: what the claims say.
        arithmetics: in which they are decided.
        archive: the evidence that is known.
        record: says which corrections are tried first, and where there is none.
        explain: whether outcomes tell their steps.
        timeout: in seconds, for each claim.
        patience: the seconds for a correction, if they are fewer than what a claim has left.
    """

    def __init__(
        self,
        interpretation: Interpretation,
        arithmetics: Arithmetics,
        archive: Archive,
        record: Mapping[str, Mapping[str, object]] | None = None,
        explain: bool = False,
        timeout: float | None = None,
        patience: float | None = None,
    ) -> None:
        self.interpretation, self.arithmetics, self.archive = interpretation, arithmetics, archive
        self.timeout, self.patience = timeout, patience
        self.writer = OutcomeWriter(interpretation, arithmetics, archive, explain)
        self.corrector = Corrector(interpretation, arithmetics, archive, record)

    def under(self, interpretation: Interpretation) -> Decider:
        """One like this for another interpretation, with nothing of what is found here."""
        return Decider(
            interpretation, self.arithmetics.fresh(), Archive(self.archive.certificates),
            self.corrector.record, self.writer.explain, self.timeout, self.patience,
        )  # fmt: skip

    def decide(self, claim: Claim, corrections: Corrections | None = None) -> Outcome:
        """The outcome for one claim, if all stands that it rests on; an error, whatever happens."""
        on, corrections = self.interpretation.on(claim), corrections or self.corrector
        try:
            with time_limit(inf):  # if the process dies here, this claim is lost, and not the run
                return corrections.accept(claim, self._with_correction(claim, corrections))
        except TimeoutError as error:
            late = str(error) or f"not decided within {self.timeout:g} s"
            return self.writer.without_evidence(claim, on, Verdict.TIMEOUT, late)
        except (
            NotationError, Meaningless, FormatError, ProcessDied, Unproved, Disagreement
        ) as error:  # fmt: skip
            return self.writer.without_evidence(claim, on, Verdict.ERROR, str(error))
        # SystemExit is no Exception, and would end the whole run with this claim
        except (Exception, SystemExit) as error:
            return self.error_outcome(claim, error)

    def late(self, claim: Claim) -> Outcome:
        """The outcome for a claim that is not decided before the run ends."""
        on = self.interpretation.on(claim)
        return self.writer.without_evidence(claim, on, Verdict.TIMEOUT, RUN_OVER)

    def error_outcome(self, claim: Claim, error: BaseException) -> Outcome:
        """The outcome for a claim where something goes wrong that nobody has thought of."""
        said = f"it cannot be computed ({type(error).__name__}: {error})"
        on = self.interpretation.on(claim)
        outcome = self.writer.without_evidence(claim, on, Verdict.ERROR, said)
        return outcome._replace(stack=format_exc(limit=-FRAMES))

    def _with_correction(self, claim: Claim, corrections: Corrections) -> Outcome:
        """The outcome for one claim, with the nearest true statement if it is refuted."""
        start = clock()
        with time_limit(self.timeout):
            statement = self.interpretation.statement(claim)
            outcome = self.archive.anew(statement, claim.id, lambda: self.outcome(statement, start))
        if outcome.verdict is Verdict.REFUTED:
            outcome = self.correct(claim, outcome, lambda: corrections.known(statement))
        return outcome._replace(note=self.archive.rejections((claim.id, f"{CORRECTED}/{claim.id}")))

    def outcome(self, statement: Statement, start: float) -> Outcome:
        """The outcome for a statement, without a correction; ``start`` is when it was begun."""
        evidence = cache(partial(self.archive.evidence, statement, statement.claim.id))
        found: dict[str, Decided | Screened] = {}
        seconds: dict[str, float] = {}
        for arithmetic in self.arithmetics.names:
            found[arithmetic] = self.arithmetics.decide(statement, evidence, arithmetic)
            seconds[arithmetic] = clock() - start
            start = clock()
        return self.writer.outcome(statement, found)._replace(seconds=seconds)

    def correct(
        self, claim: Claim, outcome: Outcome, search: Callable[[], Sequence[Correction]]
    ) -> Outcome:
        """An outcome with the corrections that are found in time, and with what that took."""
        first, start = self.arithmetics.names[0], clock()
        limits = [] if self.patience is None else [PROVING * self.patience]
        limits += (
            [] if self.timeout is None else [max(self.timeout - outcome.seconds[first], LEAST)]
        )
        try:
            with time_limit(min(limits, default=None)):
                outcome = outcome.corrected_by(search())
        except TimeoutError:
            late = "no correction was found within the time"
            verdict = (
                Verdict.TIMEOUT
                # what rests on an accepted correction needs its proof: a refutation is not enough
                # there
                if claim.printed in self.interpretation.accepted
                else outcome.verdict
            )
            outcome = outcome._replace(verdict=verdict, message=outcome.message or late)
        except (FormatError, Unproved, Disagreement, ProcessDied) as error:
            outcome = outcome._replace(verdict=Verdict.ERROR, message=str(error))
        spent = outcome.seconds[first] + clock() - start
        return outcome._replace(seconds={**outcome.seconds, first: spent})
