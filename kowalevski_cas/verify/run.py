"""The run: every claim of a derivation, in the order of the paper, in every arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from time import perf_counter

from kowalevski_cas.algebra import POINTS
from kowalevski_cas.notation import Formula, NotationError
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.accept import Unproved
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.bench import Bench, Decided
from kowalevski_cas.verify.certificate import CORRECTED, Stored, certificate
from kowalevski_cas.verify.corrections import correction, printed_of, recorded_correction
from kowalevski_cas.verify.explain import conditions, counterexample, why
from kowalevski_cas.verify.limits import time_limit
from kowalevski_cas.verify.outcome import (
    Condition,
    Correction,
    Counterexample,
    Outcome,
    Run,
    Screened,
    Step,
    Verdict,
)
from kowalevski_cas.verify.statement import Statement

Progress = Callable[[str, int, int], None]

DECIDED = (Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED)


def disagreement(verdicts: Mapping[str, Verdict]) -> bool:
    """Whether two arithmetics decided differently; an undecided one disagrees with none."""
    green = {v.green for v in verdicts.values() if v in DECIDED}
    return len(green) > 1


def verify(
    derivation: Derivation,
    arithmetics: Sequence[str],
    only: Sequence[str] = (),
    explain: bool = False,
    progress: Progress = lambda claim, done, total: None,
    certificates: Mapping[str, Stored] | None = None,
    timeout: float | None = None,
    sources: Mapping[str, str] | None = None,
    seed: int = 1,
    record: Mapping[str, Mapping[str, object]] | None = None,
) -> Run:
    """Decide the claims of a derivation.

    With ``only``, no other claim is decided. With ``explain``, outcomes tell their steps and what
    they rest on. ``certificates`` saves the searches whose results they hold. ``timeout`` is in
    seconds, for each claim in each arithmetic. ``sources`` holds displays, by id, that are to be
    read instead of what the derivation prints. ``seed`` chooses the points of the arithmetics that
    only screen. ``record`` says which corrections are tried first.
    """
    session = Session(
        derivation, arithmetics, explain, certificates, timeout, sources, seed, record
    )
    return session.run(only, progress)


class Session(Bench):
    """A run: what is decided of claims, with conditions, counterexamples and corrections."""

    def run(self, only: Sequence[str] = (), progress: Progress = lambda *_: None) -> Run:
        """Decide the chosen claims."""
        derivation = self.derivation
        chosen = [c for c in derivation.claims if not only or c.id in only]
        outcomes = []
        for done, claim in enumerate(chosen):
            progress(claim.id, done, len(chosen))
            outcomes.append(self.decide(claim))
        return Run(
            derivation=derivation.name,
            title=derivation.title,
            author=derivation.author,
            source=derivation.source,
            sections=tuple((s.number, s.title) for s in derivation.sections),
            outcomes=tuple(outcomes),
            arithmetics=tuple(self.arithmetics),
            versions={},
            digest=combined(f"{o.claim} {o.digest}" for o in outcomes),
            vocabulary=self.texts.vocabulary,
        )

    # -- one claim -----------------------------------------------------------------

    def decide(self, claim: Claim) -> Outcome:
        """The outcome for one claim."""
        on = self.on(claim)
        before = self._products()
        seconds: dict[str, float] = {}
        start = perf_counter()
        statement: Statement | None = None
        try:
            statement = Statement(claim, on)
            verdicts = self._evidence(statement, claim.id)
        except TimeoutError:
            return self._unread(claim, on, Verdict.TIMEOUT, self._late("the search"))
        except (NotationError, Meaningless, FormatError) as error:
            return self._unread(claim, on, Verdict.ERROR, str(error), statement)
        searching = perf_counter() - start
        found: dict[str, Decided | Screened] = {}
        for arithmetic in self.arithmetics:
            start = perf_counter()
            found[arithmetic] = self._decide(statement, verdicts, arithmetic)
            seconds[arithmetic] = perf_counter() - start
        seconds[self.arithmetics[0]] += searching
        products = self._products() - before
        outcome = self._outcome(claim, on, statement, found)
        mended = None
        if outcome.verdict is Verdict.REFUTED:
            start = perf_counter()
            try:
                mended = self._correct(claim, on)
            except (FormatError, Unproved) as error:
                outcome = replace(outcome, verdict=Verdict.ERROR, message=str(error))
            seconds[self.arithmetics[0]] += perf_counter() - start
        outcome = replace(outcome, correction=mended, products=products, seconds=seconds)
        return self._with_acceptance(claim, outcome)

    # -- certificates --------------------------------------------------------------

    def certificates(self, claim: Claim) -> Iterator[tuple[str, str]]:
        """The certificate of a claim, and that of its correction, by name.

        Raises ``FormatError`` or ``Rejected`` if one cannot be written, :class:`Unproved` if the
        claim is not decided.
        """
        statement = Statement(claim, self.on(claim))
        decided = self._judged(statement, self._evidence(statement, claim.id), "flint")
        yield claim.id, self._certificate(decided)
        if decided.verdict is not Verdict.REFUTED:
            return
        recorded = self.record.get(claim.id, {}).get("correction")
        on = statement.on
        found = recorded_correction(claim, on, recorded) if isinstance(recorded, str) else None
        if found is None or self.mended(found.claim, on.under(found.texts)) is None:
            found = correction(claim, on)
        if found is not None:
            name = f"{CORRECTED}/{claim.id}"
            mended = Statement(found.claim, statement.on.under(found.texts))
            yield (
                name,
                self._certificate(self._judged(mended, self._evidence(mended, name), "flint")),
            )

    @staticmethod
    def _certificate(decided: Decided) -> str:
        if decided.verdicts is None or decided.verdict not in DECIDED:
            raise Unproved(f"the claim is {decided.verdict}")
        return certificate(decided.statement, decided.verdicts, decided.accepted)

    # -- outcomes ------------------------------------------------------------------

    def _outcome(
        self,
        claim: Claim,
        on: Elaborations,
        statement: Statement,
        found: Mapping[str, Decided | Screened],
    ) -> Outcome:
        first = found[self.arithmetics[0]]
        verdicts = {name: one.verdict for name, one in found.items()}
        verdict, message = first.verdict, first.message
        if disagreement(verdicts):
            shown = ", ".join(f"{name}: {v}" for name, v in verdicts.items())
            verdict, message = Verdict.ERROR, f"the arithmetics disagree ({shown})"
        else:
            answered = (*DECIDED, Verdict.PROBABLE, Verdict.ENCLOSED)
            open_ones = [one for one in found.values() if one.verdict not in answered]
            if open_ones:
                verdict, message = open_ones[0].verdict, open_ones[0].message
        outcome = replace(
            self._unread(claim, on, verdict, message, statement),
            verdicts=verdicts,
            corrected=self._corrected(claim, statement),
        )
        if isinstance(first, Screened):
            return replace(
                outcome, counterexample=first.counterexample, chance=first.chance,
                radius=first.radius,
            )  # fmt: skip
        return self._explained(outcome, statement, first)

    def _explained(self, outcome: Outcome, statement: Statement, decided: Decided) -> Outcome:
        """An outcome with its conditions, its counterexample and its steps."""
        accepted = decided.accepted
        if self.arithmetics[0] != "flint" and outcome.verdict is Verdict.PROVED:
            accepted = self._judged(statement, decided.verdicts, "flint").accepted
        if outcome.verdict is Verdict.PROVED:
            needed = conditions(statement, accepted, self.explain)
            if needed:
                verdicts: dict[str, Verdict] = {
                    name: Verdict.CONDITIONAL if v is Verdict.PROVED else v
                    for name, v in outcome.verdicts.items()
                }
                outcome = replace(
                    outcome, verdict=Verdict.CONDITIONAL, conditions=needed, verdicts=verdicts
                )
        against: Counterexample | None = None
        if outcome.verdict is Verdict.REFUTED and isinstance(decided.verdicts, Denial):
            try:
                against = counterexample(statement, decided.verdicts, decided.accepted)
            except OverflowError as error:
                return replace(outcome, verdict=Verdict.ERROR, message=str(error))
            if against is None:
                denied = statement.goals[decided.verdicts.goal]
                outcome = replace(outcome, message=why(denied, decided.verdicts.evidence))
        told: tuple[Step, ...] = ()
        if self.explain and decided.verdicts is not None:
            from kowalevski_cas.verify.steps import steps  # a verdict needs none

            told = steps(statement, decided.verdicts)
        return replace(
            outcome,
            counterexample=against,
            steps=told,
            rests_on=self.rests_on(statement) if self.explain else (),
        )

    def _unread(
        self,
        claim: Claim,
        on: Elaborations,
        verdict: Verdict,
        message: str,
        statement: Statement | None = None,
    ) -> Outcome:
        """An outcome that says what the claim is, and no more than the verdict."""
        places = [claim.printed] if claim.printed else list(claim.establishes())
        formulas: tuple[Formula, ...] = ()
        branches: tuple[Formula, ...] = ()
        sources = []
        try:
            sources = [on.texts.statement(place).source for place in places]
            formulas = claim.formulas(on.texts)
            chosen = dict.fromkeys(place for s in claim.scenes() for place in s.branches())
            branches = tuple(map(on.texts.formula, chosen))
        except NotationError:
            pass
        granted = dict.fromkeys(tex for scene in claim.scenes() for tex in scene.nonzero)
        return Outcome(
            claim=claim.id,
            section=self.derivation.section_of(claim).number,
            scene=claim.scene.name,
            formulas=formulas,
            source=r",\quad ".join(sources),
            words=claim.words,
            verdict=verdict,
            message=message,
            digest="" if statement is None else statement.digest,
            granted=tuple(map(on.texts.expression, granted)),
            branches=branches,
            verdicts={name: verdict for name in self.arithmetics},
        )

    # -- corrections ---------------------------------------------------------------

    def _correct(self, claim: Claim, on: Elaborations) -> Correction | None:
        """The nearest true statement, decided in every arithmetic."""
        recorded = self.record.get(claim.id, {}).get("correction")
        try:
            with time_limit(self.patience):
                if isinstance(recorded, str):
                    known = self._proposed(recorded_correction(claim, on, recorded), on)
                    if known is not None:
                        return known
                return self._proposed(correction(claim, on), on)
        except TimeoutError:
            return None

    def _proposed(self, neighbour: Neighbour | None, on: Elaborations) -> Correction | None:
        """A neighbour as a correction, if it is proved."""
        mended = (
            None if neighbour is None else self.mended(neighbour.claim, on.under(neighbour.texts))
        )
        if neighbour is None or mended is None:
            return None
        verdict, needed = mended
        return Correction(
            printed_of(neighbour),
            neighbour.words,
            verdict,
            needed,
            neighbour.printed,
            neighbour.edit,
        )

    def mended(
        self, claim: Claim, on: Elaborations
    ) -> tuple[Verdict, tuple[Condition, ...]] | None:
        """The verdict on a corrected claim, and its conditions; ``None`` if it is not proved."""
        statement = Statement(claim, on)
        try:
            verdicts = self._evidence(statement, f"{CORRECTED}/{claim.id}")
        except TimeoutError:
            return None
        exact = dict.fromkeys(("flint", *(a for a in self.arithmetics if a not in POINTS)))
        decided = [self._judged(statement, verdicts, arithmetic) for arithmetic in exact]
        for one in decided:
            if one.verdict is Verdict.ERROR:
                raise Unproved(one.message)
        if any(one.verdict is not Verdict.PROVED for one in decided):
            return None
        needed = conditions(statement, decided[0].accepted, self.explain)
        return (Verdict.CONDITIONAL if needed else Verdict.PROVED), needed

    def _with_acceptance(self, claim: Claim, outcome: Outcome) -> Outcome:
        """The outcome, with its correction accepted; an error if what is accepted is not proved."""
        place = claim.printed
        if outcome.verdict is Verdict.ERROR:
            return outcome
        if place is None or place not in self.accepted or place not in set(claim.establishes()):
            return outcome
        formulas, correction = (self.accepted[place],), outcome.correction
        if correction is not None and correction.formulas == formulas:
            return replace(outcome, correction=replace(correction, accepted=True))
        if outcome.verdict.likely and outcome.formulas == formulas:
            return outcome
        message = f"what the derivation accepts at {place.place} has not been proved"
        return replace(outcome, verdict=Verdict.ERROR, message=message)

    def _corrected(self, claim: Claim, statement: Statement) -> tuple[str, ...]:
        """The claims whose accepted corrections a statement rests on."""
        own = set(claim.about())
        used = {p for p in statement.places() if p in self.accepted and p not in own}
        ids = (self.established.get(place, place.place) for place in self.accepted if place in used)
        return tuple(dict.fromkeys(ids))

    def rests_on(self, statement: Statement) -> tuple[str, ...]:
        """The claims before this one that establish the places on which it stands."""
        ids = dict.fromkeys(self.established.get(place) for place in statement.places())
        before = self.order[statement.claim.id]
        return tuple(i for i in ids if i is not None and self.order[i] < before)


def combined(parts: Iterable[str]) -> str:
    """One digest of many texts."""
    return sha256("\n".join(parts).encode()).hexdigest()[:16]
