"""The run: every claim of a derivation, in the order of the paper, in every arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from itertools import count, permutations
from typing import TYPE_CHECKING, Any

from kowalevski_cas.library import library
from kowalevski_cas.limits import is_watched, tell
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation, Doubt
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.processes import each
from kowalevski_cas.verify.archive import Archive
from kowalevski_cas.verify.arithmetics import Arithmetics
from kowalevski_cas.verify.certificate import Stored, load_certificates
from kowalevski_cas.verify.confirm import is_received, receive, received
from kowalevski_cas.verify.decider import Decider
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Outcome, Run, Verdict

if TYPE_CHECKING:
    from kowalevski_cas.verify.blame import Blame
    from kowalevski_cas.verify.repair import Work

Progress = Callable[[str, int, int], None]


def run_together(
    sessions: Sequence[Session], only: Sequence[str] = (), progress: Progress = lambda *_: None
) -> list[Run]:
    """The runs of sessions; processes share the claims of all of them.

    A session asks another one for what it rests on there.
    """
    found = zip(sessions, decide_together(sessions, only, progress), strict=True)
    return [session.result(correct_together(session, outcomes)) for session, outcomes in found]


def decide_together(
    sessions: Sequence[Session], only: Sequence[str] = (), progress: Progress = lambda *_: None
) -> list[list[Outcome]]:
    """The outcomes for each session, without the corrections for which one has to search."""
    for one, other in permutations(sessions, 2):
        if one.interpretation.bases.get(other.derivation.name) is other.derivation:
            one.elsewhere[other.derivation.name] = other
    chosen = [(session, session.chosen(only)) for session in sessions]
    tasks = [(session, claim) for session, claims in chosen for claim in claims]
    begun, first = count(), 0

    def decide_one(number: int) -> tuple[int, Outcome]:
        session, claim = tasks[number]
        tell(claim.id)
        return number, session.decide(claim)

    def not_decided(number: int) -> tuple[int, Outcome]:
        session, claim = tasks[number]
        return number, session.decider.late(claim)

    def hear(claim: str, _: int) -> None:
        progress(claim, next(begun), len(tasks))

    while numbers := range(first, first := len(tasks)):
        # each is checked as soon as it is there, while others are decided
        found = each(received(decide_one), numbers, heard=hear, ordered=False, late=not_decided)
        for number, outcome in found:
            session, claim = tasks[number]
            session.decided[claim.id] = receive(outcome, session.decider.timeout)
        behind = (pair for k in numbers for pair in tasks[k][0].behind(tasks[k][1]))
        tasks += dict.fromkeys(pair for pair in behind if pair[1].id not in pair[0].decided)
    return [[session.outcome(claim) for claim in claims] for session, claims in chosen]


def correct_together(
    session: Session, outcomes: Sequence[Outcome], blame: Blame | None = None
) -> list[Outcome]:
    """The outcomes with corrections that other processes find, and are received from them."""

    def work(work: Callable[[Any], Any], of: Sequence[Any], late: Callable[[Any], Any]) -> Any:
        return each(received(work), of, late=late)

    found = session.with_corrections(outcomes, work, blame)
    pairs = zip(outcomes, found, strict=True)
    return [new if new is old else receive(new, known=old) for old, new in pairs]


class Session:
    """A run: each claim is decided once, and what it rests on before it.

    Args:
        derivation: whose claims are decided.
        arithmetics: in which, one after the other.
        explain: whether outcomes tell their steps.
        certificates: save the searches whose results they hold.
        timeout: in seconds, for each claim.
        texts: are read instead of what the derivation prints, or are what it prints.
        seed: chooses the points of the arithmetics that only screen.
        record: says which corrections are tried first, and where there is none.
        patience: the seconds for a correction, if they are fewer than what a claim has left.
    """

    def __init__(
        self,
        derivation: Derivation,
        arithmetics: Sequence[str],
        explain: bool = False,
        certificates: Mapping[str, Stored] | None = None,
        timeout: float | None = None,
        texts: Texts | None = None,
        seed: int = 1,
        record: Mapping[str, Mapping[str, object]] | None = None,
        patience: float | None = None,
    ) -> None:
        self.decider = Decider(
            Interpretation(derivation, texts), Arithmetics(arithmetics, seed),
            Archive(certificates), record, explain, timeout, patience,
        )  # fmt: skip
        self.elsewhere: dict[str, Session] = {}
        """The runs of derivations on which this one rests, as far as they were asked."""
        self.decided: dict[str, Outcome] = {}
        """What other processes say of claims, and the checker has accepted here."""
        self._outcomes: dict[str, Outcome] = {}
        self._standing: dict[str, bool] = {}

    def under(self, interpretation: Interpretation) -> Session:
        """A run like this of what claims say under other texts."""
        session = copy(self)
        session.decider = self.decider.under(interpretation)
        session.decided, session.elsewhere = {}, {}
        session._outcomes, session._standing = {}, {}
        return session

    @property
    def interpretation(self) -> Interpretation:
        """What the claims say."""
        return self.decider.interpretation

    @property
    def derivation(self) -> Derivation:
        """Whose claims are decided."""
        return self.interpretation.derivation

    @property
    def texts(self) -> Texts:
        """What is read."""
        return self.interpretation.texts

    def on(self, claim: Claim, texts: Texts | None = None) -> Elaborations:
        """The texts for a claim, those of the run or others, with the accepted corrections."""
        return self.interpretation.on(claim, texts)

    def chosen(self, only: Sequence[str]) -> list[Claim]:
        """The claims with these ids, or all if there are none."""
        self.decider.arithmetics.load()
        return [c for c in self.derivation.claims if not only or c.id in only]

    def run(self, only: Sequence[str] = ()) -> Run:
        """Decide the claims with these ids, or all, and before them those that they rest on.

        With a limit of time, the run has processes of its own.
        """
        if self.decider.timeout is None or is_watched():
            found = [self.outcome(claim) for claim in self.chosen(only)]
            return self.result(self.with_corrections(found, lambda work, of, _: map(work, of)))
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
            arithmetics=self.decider.arithmetics.names,
            versions={},
            vocabulary=self.texts.vocabulary,
            edition=derivation.edition,
            main=derivation.main,
            expected=derivation.expected,
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
        known = self._outcomes
        if claim.id not in known:
            known[claim.id] = self.decided.get(claim.id) or self.decide(claim)
            known[claim.id] = self.decider.writer.resting(claim, known[claim.id], self.stands)
        return known[claim.id]

    def decide(self, claim: Claim) -> Outcome:
        """The outcome for one claim, if all stands that it rests on."""
        return self.decider.decide(claim)

    def certificates(self, claim: Claim) -> Iterator[tuple[str, str]]:
        """The certificate of a claim, and that of its correction, by name."""
        yield from self.outcome(claim).certificates.items()

    def stands(self, id: str) -> bool:
        """Whether the correction of a claim that its derivation accepts is proved."""
        if id not in self._standing:
            self._standing[id] = self._is_proved(id)
        return self._standing[id]

    def behind(self, claim: Claim) -> Iterator[tuple[Session, Claim]]:
        """The claims whose accepted corrections one that is decided rests on, with their runs."""
        pairs = map(self._accepting, self.decided[claim.id].corrected)
        return (pair for pair in pairs if pair is not None)

    def _accepting(self, id: str) -> tuple[Session, Claim] | None:
        """The claim with this id, in a derivation before this one if it names one, and its run."""
        name, _, claim_id = id.rpartition("/")
        derivation = self.interpretation.bases[name] if name else self.derivation
        claim = next((c for c in derivation.claims if c.id == claim_id), None)
        if claim is None:
            return None
        if name and name not in self.elsewhere:
            kept = load_certificates(library() / name)
            limit = self.decider.timeout
            self.elsewhere[name] = Session(derivation, ["flint"], certificates=kept, timeout=limit)
        return self.elsewhere[name] if name else self, claim

    def _is_proved(self, id: str) -> bool:
        if (accepting := self._accepting(id)) is None:
            return False
        session, claim = accepting
        outcome = session.outcome(claim)
        # in a worker nobody has checked the certificate yet, and verdicts rest on what it proves
        return session.decider.corrector.confirms(
            claim, receive(outcome) if is_received() else outcome
        )

    def with_corrections(
        self, outcomes: Sequence[Outcome], work: Work, blame: Blame | None = None
    ) -> list[Outcome]:
        """The outcomes with the corrections of what is refuted, where none is known.

        ``blame`` searches for what makes claims fail, instead of the search that suits the run.
        """
        if not any(map(self.decider.corrector.needs_search, outcomes)):
            return [*outcomes]
        from kowalevski_cas.verify.repair import blame_of, repair  # what is corrected needs none

        return repair(self.decider, outcomes, work, blame or blame_of(self.decider, outcomes))
