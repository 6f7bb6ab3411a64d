"""The run: every claim of a derivation, in the order of the paper, in every arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import cached_property
from itertools import count, permutations
from math import inf
from time import perf_counter
from traceback import format_exc
from typing import Any

from kowalevski_cas.algebra import POINTS, load, load_points
from kowalevski_cas.library import library
from kowalevski_cas.limits import ProcessDied, tell, time_limit, watched
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.processes import each
from kowalevski_cas.verify.blame import Blame, Repairs
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.confirm import Disagreement, receive
from kowalevski_cas.verify.corrector import Corrector
from kowalevski_cas.verify.outcome import CORRECTED, Correction, Outcome, Run, Screened, Verdict
from kowalevski_cas.verify.statement import Statement
from kowalevski_cas.verify.workbench import Decided

FALSE_AS_READ = "false as it was read"
"""The words for a claim that fails, and that may have been meant otherwise."""

Progress = Callable[[str, int, int], None]

Work = Callable[[Callable[[Any], Any], Sequence[Any]], Iterable[Any]]
"""How something is done for each of several items: here, or in processes of their own."""

FRAMES = 20
"""The innermost calls of a stack that are shown."""

PROVING = 3
"""How many times as long as the search for a correction its proof may take with it."""

LEAST = 0.5
"""Seconds for a correction, however little the refutation has left."""


def run_together(
    sessions: Sequence[Session], only: Sequence[str] = (), progress: Progress = lambda *_: None
) -> list[Run]:
    """The runs of sessions; processes share the claims of all of them.

    A session asks another one for what it rests on there.
    """
    for one, other in permutations(sessions, 2):
        if one.bases.get(other.derivation.name) is other.derivation:
            one.elsewhere[other.derivation.name] = other
    chosen = [(session, session.chosen(only)) for session in sessions]
    tasks = [(session, claim) for session, claims in chosen for claim in claims]
    begun = count()

    def decided(number: int) -> Outcome:
        session, claim = tasks[number]
        tell(claim.id)
        return session.outcome(claim)

    def heard(claim: str, _: int) -> None:
        progress(claim, next(begun), len(tasks))

    with _checking_here(sessions):
        outcomes = each(decided, range(len(tasks)), heard=heard)
        received = [receive(one, tasks[k][0].timeout) for k, one in enumerate(outcomes)]
        ours = iter(received)
        found = [(session, [next(ours) for _ in claims]) for session, claims in chosen]
        return [session.result(_corrected(session, ones)) for session, ones in found]


@contextmanager
def _checking_here(sessions: Iterable[Session]) -> Iterator[None]:
    """Processes that are begun here leave it to this one to have their certificates checked."""
    for session in sessions:
        session.checks = False
    try:
        yield
    finally:
        for session in sessions:
            session.checks = True


def _corrected(session: Session, outcomes: Sequence[Outcome]) -> list[Outcome]:
    """The outcomes with corrections that other processes find, and are received from them."""
    found = session.with_corrections(outcomes, each)
    pairs = zip(outcomes, found, strict=True)
    return [new if new is old else receive(new, known=old) for old, new in pairs]


class Session(Corrector):
    """A run: each claim is decided once, and what it rests on before it."""

    patience: float | None = None
    """The seconds for a correction, if they are fewer than what a claim has left."""

    @cached_property
    def elsewhere(self) -> dict[str, Session]:
        """The runs of derivations on which this one rests, as far as they were asked."""
        return {}

    def chosen(self, only: Sequence[str]) -> list[Claim]:
        """The claims with these ids, or all if there are none."""
        for name in self.arithmetics:  # no claim is charged for what is imported
            (load_points if name in POINTS else load)(name)
        return [c for c in self.derivation.claims if not only or c.id in only]

    def run(self, only: Sequence[str] = ()) -> Run:
        """Decide the claims with these ids, or all, and before them those that they rest on.

        With a limit of time, the run has processes of its own.
        """
        if self.timeout is None or watched():
            found = [self.outcome(claim) for claim in self.chosen(only)]
            return self.result(self.with_corrections(found, map))
        (run,) = run_together([self], only)
        return run

    def result(self, outcomes: Sequence[Outcome]) -> Run:
        """The run in which these outcomes were found."""
        derivation = self.derivation
        return Run(
            derivation=derivation.name,
            title=derivation.title,
            author=derivation.author,
            source=derivation.source,
            sections=tuple((s.number, s.title) for s in derivation.sections),
            outcomes=tuple(map(self.settled, outcomes)),
            arithmetics=tuple(self.arithmetics),
            versions={},
            vocabulary=self.texts.vocabulary,
            edition=derivation.edition,
            main=derivation.main,
        )

    def settled(self, outcome: Outcome) -> Outcome:
        """An outcome, undecided if what is refuted may have been meant otherwise."""
        doubt = self.derivation.doubts.get(outcome.claim)
        mended = outcome.correction is not None and doubt is not Doubt.ALWAYS
        if outcome.verdict is not Verdict.REFUTED or doubt is None or mended:
            return outcome
        return outcome._replace(
            verdict=Verdict.UNDECIDED, message=FALSE_AS_READ, certificate="", correction=None,
            alternatives=(),
        )  # fmt: skip

    def outcome(self, claim: Claim) -> Outcome:
        """The outcome for one claim; it is undecided if something that it rests on is."""
        if claim.id not in self.found:
            found = self.found[claim.id] = self.decide(claim)
            missing = [id for id in found.corrected if not self.stands(id)]
            decided = found.verdict is Verdict.REFUTED or found.verdict.likely
            if decided and missing:
                unread = self.outcome_without_evidence(
                    claim, self.on(claim), Verdict.UNDECIDED, f"rests on {', '.join(missing)}"
                )
                self.found[claim.id] = unread._replace(
                    digest=found.digest, corrected=found.corrected, seconds=found.seconds
                )
        return self.found[claim.id]

    def certificates(self, claim: Claim) -> Iterator[tuple[str, str]]:
        """The certificate of a claim, and that of its correction, by name."""
        yield from self.outcome(claim).certificates.items()

    def stands(self, id: str) -> bool:
        """Whether the correction of a claim that its derivation accepts is proved."""
        name, _, own = id.rpartition("/")
        derivation = self.bases[name] if name else self.derivation
        claim = next((c for c in derivation.claims if c.id == own), None)
        if claim is None:
            return False
        if name and name not in self.elsewhere:
            kept = load_certificates(library() / name)
            self.elsewhere[name] = Session(
                derivation, ["flint"], certificates=kept, timeout=self.timeout
            )
        session = self.elsewhere[name] if name else self
        outcome = session.outcome(claim)
        return session._confirms(claim, outcome if session.checks else receive(outcome))

    def decide(self, claim: Claim) -> Outcome:
        """The outcome for one claim, if all stands that it rests on; an error, whatever happens."""
        on = self.on(claim)
        try:
            with time_limit(inf):  # if the process dies here, this claim is lost, and not the run
                return self.with_acceptance(claim, self._corrected(claim, on))
        except TimeoutError as error:
            late = str(error) or f"not decided within {self.timeout:g} s"
            return self.outcome_without_evidence(claim, on, Verdict.TIMEOUT, late)
        except (
            NotationError, Meaningless, FormatError, ProcessDied, Unproved, Disagreement
        ) as error:  # fmt: skip
            return self.outcome_without_evidence(claim, on, Verdict.ERROR, str(error))
        except (Exception, SystemExit) as error:
            return self._broken(claim, error)

    def _broken(self, claim: Claim, error: BaseException) -> Outcome:
        """The outcome for a claim where something goes wrong that nobody has thought of."""
        said = f"it cannot be computed ({type(error).__name__}: {error})"
        outcome = self.outcome_without_evidence(claim, self.on(claim), Verdict.ERROR, said)
        return outcome._replace(stack=format_exc(limit=-FRAMES))

    def _corrected(self, claim: Claim, on: Elaborations) -> Outcome:
        """The outcome for one claim, with the nearest true statement if it is refuted."""
        start = perf_counter()
        with time_limit(self.timeout):
            statement = Statement(claim, on)
            outcome = self.anew(statement, claim.id, lambda: self._decided(statement, start))
        if outcome.verdict is Verdict.REFUTED:
            outcome = self._timed(claim, outcome, lambda: self.known_corrections(statement))
        names = (claim.id, f"{CORRECTED}/{claim.id}")
        notes = [self.rejected.pop(name) for name in names if name in self.rejected]
        return outcome._replace(note="\n".join(notes))

    def _decided(self, statement: Statement, start: float) -> Outcome:
        """The outcome for one claim, without a correction."""
        verdicts = self._evidence(statement, statement.claim.id)
        found: dict[str, Decided | Screened] = {}
        seconds: dict[str, float] = {}
        for arithmetic in self.arithmetics:
            found[arithmetic] = self._decide(statement, verdicts, arithmetic)
            seconds[arithmetic] = perf_counter() - start
            start = perf_counter()
        return self._outcome(statement, found)._replace(seconds=seconds)

    # -- corrections -----------------------------------------------------------------

    def with_corrections(self, outcomes: Sequence[Outcome], work: Work) -> list[Outcome]:
        """The outcomes with the corrections of what is refuted, where none is known.

        What claims share is looked at first, then they are one by one.
        """
        found = {outcome.claim: outcome for outcome in outcomes}
        blame = self.blame(found)
        if failing := blame.open():
            (shared,) = work(lambda _: self._shared(blame), ["shared"])
            for id, corrections in shared.items():
                found[id] = found[id].corrected_by(corrections)
            left = [claim for claim in failing if claim.id not in shared]

            def alone(place: int) -> Outcome:
                claim = left[place]
                tell(claim.id)
                try:
                    with time_limit(inf):
                        return self._timed(claim, found[claim.id], lambda: blame.alone(claim))
                except (Exception, SystemExit) as error:
                    return self._broken(claim, error)

            for outcome in work(alone, range(len(left))):
                found[outcome.claim] = outcome
        return [*found.values()]

    def blame(self, outcomes: Mapping[str, Outcome]) -> Blame:
        """The search for what makes claims fail, of which these are the outcomes so far."""
        verdicts = {id: outcome.verdict for id, outcome in outcomes.items()}
        explained = [id for id, outcome in outcomes.items() if outcome.correction]
        return Blame(self, verdicts, explained, self.patience or (self.timeout or inf) / 2)

    @property
    def _longest(self) -> float | None:
        """The seconds in which what is found for a correction is to be proved as well."""
        return self.timeout if self.patience is None else PROVING * self.patience

    def _shared(self, blame: Blame) -> Repairs:
        """What mends several claims, if it is found in time."""
        with suppress(Exception), time_limit(inf), time_limit(self._longest):
            return blame.shared()
        return {}  # what goes wrong with one of the claims is told where it is by itself

    def _timed(
        self, claim: Claim, outcome: Outcome, search: Callable[[], Sequence[Correction]]
    ) -> Outcome:
        """An outcome with the corrections that are found in time, and with what that took."""
        first, start = self.arithmetics[0], perf_counter()
        limits = [] if self.patience is None else [PROVING * self.patience]
        limits += (
            [] if self.timeout is None else [max(self.timeout - outcome.seconds[first], LEAST)]
        )
        try:
            with time_limit(min(limits, default=None)):
                outcome = outcome.corrected_by(search())
        except TimeoutError:
            late = "no correction was found within the time"
            verdict = Verdict.TIMEOUT if claim.printed in self.accepted else outcome.verdict
            outcome = outcome._replace(verdict=verdict, message=outcome.message or late)
        except (FormatError, Unproved, Disagreement, ProcessDied) as error:
            outcome = outcome._replace(verdict=Verdict.ERROR, message=str(error))
        spent = outcome.seconds[first] + perf_counter() - start
        return outcome._replace(seconds={**outcome.seconds, first: spent})
