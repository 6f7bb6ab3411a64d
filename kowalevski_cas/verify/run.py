"""The run: every claim of a derivation, in the order of the paper, in every arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from time import perf_counter

from kowalevski_cas.algebra import POINTS, load, load_points
from kowalevski_cas.notation import Formula, NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.accept import Accepted, Judge, Unproved
from kowalevski_cas.problem.evaluate import Evaluation, Meaningless
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.certificate import CORRECTED, Stored, certificate
from kowalevski_cas.verify.corrections import correction, printed_of
from kowalevski_cas.verify.explain import conditions, counterexample, steps, why
from kowalevski_cas.verify.limits import time_limit
from kowalevski_cas.verify.outcome import (
    Condition,
    Correction,
    Counterexample,
    Outcome,
    Run,
    Verdict,
)
from kowalevski_cas.verify.screen import Screened, screen
from kowalevski_cas.verify.statement import Statement, Verdicts, finder_of

Progress = Callable[[str, int, int], None]

DECIDED = (Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED)


def disagreement(verdicts: Mapping[str, Verdict]) -> bool:
    """Whether two arithmetics decided differently; an undecided one disagrees with none."""
    green = {v.green for v in verdicts.values() if v in DECIDED}
    return len(green) > 1


@dataclass
class Decided:
    """A statement with its evidence, and what an arithmetic accepted of it."""

    statement: Statement
    verdicts: Verdicts | None
    accepted: Accepted
    verdict: Verdict
    message: str = ""


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


class Session:
    """The state of a run: texts, the settings of scenes, and their evaluations."""

    def __init__(
        self,
        derivation: Derivation,
        arithmetics: Sequence[str],
        explain: bool = False,
        certificates: Mapping[str, Stored] | None = None,
        timeout: float | None = None,
        sources: Mapping[str, str] | None = None,
        seed: int = 1,
        record: Mapping[str, Mapping[str, object]] | None = None,
    ) -> None:
        self.derivation = derivation
        self.arithmetics = arithmetics
        self.explain = explain
        self.timeout = timeout
        self.stored = certificates or {}
        self.record = record or {}
        self.points = {name: load_points(name, seed) for name in arithmetics if name in POINTS}
        self.texts = derivation.texts(sources)
        self.elaborations = Elaborations(self.texts)
        self.evaluations: dict[tuple[str, Setting], Evaluation] = {}
        self.order = {claim.id: k for k, claim in enumerate(derivation.claims)}
        self.established: dict[Printed, str] = {}
        for claim in derivation.claims:
            for printed in claim.establishes():
                self.established.setdefault(printed, claim.id)
        self.accepted = self._accepted()

    def _accepted(self) -> dict[Printed, Formula]:
        """What the derivation accepts in place of what is printed."""
        return {
            place: self.texts.expression(tex) for place, tex in self.derivation.accepted.items()
        }

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

    def on(self, claim: Claim) -> Elaborations:
        """The texts for a claim: with the accepted corrections, but for those that it is about."""
        own = set(claim.establishes())
        read = {place: f for place, f in self.accepted.items() if place not in own}
        return self.elaborations.under(self.texts.reading(read)) if read else self.elaborations

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

    def _evidence(self, statement: Statement, name: str) -> Verdicts | None:
        """The evidence that is stored for a statement, or that a search finds."""
        stored = self.stored.get(name)
        verdicts = None if stored is None else stored.verdicts(statement)
        if verdicts is not None:
            return verdicts
        with time_limit(self.timeout):
            return statement.search()

    def _decide(
        self, statement: Statement, verdicts: Verdicts | None, arithmetic: str
    ) -> Decided | Screened:
        try:
            with time_limit(self.timeout):
                points = self.points.get(arithmetic)
                if points is not None:
                    return screen(statement, verdicts, points)
                return self._judged(statement, verdicts, arithmetic)
        except TimeoutError:
            return Decided(statement, verdicts, Accepted(), Verdict.TIMEOUT, self._late(arithmetic))

    def _judged(self, statement: Statement, verdicts: Verdicts | None, arithmetic: str) -> Decided:
        judge = Judge(self.evaluations_in(arithmetic))
        if verdicts is None:
            message = "neither a proof nor a point where it fails was found"
            return Decided(statement, None, judge.accepted, Verdict.UNDECIDED, message)
        try:
            if isinstance(verdicts, Denial):
                judge.denies(statement.goals[verdicts.goal], verdicts.evidence)
                return Decided(statement, verdicts, judge.accepted, Verdict.REFUTED)
            for goal, evidence in zip(statement.goals, verdicts, strict=True):
                judge.holds(goal, evidence)
        except Unproved as error:
            where = self._file(statement)
            message = f"{where}the evidence does not prove it ({arithmetic}: {error})"
            return Decided(statement, verdicts, judge.accepted, Verdict.ERROR, message)
        return Decided(statement, verdicts, judge.accepted, Verdict.PROVED)

    def _file(self, statement: Statement) -> str:
        """The file that has evidence for a statement, to begin a message with."""
        for name in (statement.claim.id, f"{CORRECTED}/{statement.claim.id}"):
            stored = self.stored.get(name)
            if stored is not None and stored.data.get("digest") == statement.digest:
                return f"{stored.path}: "
        return ""

    def evaluations_in(self, arithmetic: str) -> Callable[[Setting], Evaluation]:
        """The evaluations of settings in an arithmetic, each made once."""

        def of(setting: Setting) -> Evaluation:
            if arithmetic == "flint":
                return finder_of(setting)
            key = (arithmetic, setting)
            if key not in self.evaluations:
                made = Evaluation(setting, load(arithmetic), others=of)
                self.evaluations[key] = made.adjoin_roots()
            return self.evaluations[key]

        return of

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
        found = correction(claim, statement.on, recorded if isinstance(recorded, str) else None)
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
                verdicts = {
                    name: Verdict.CONDITIONAL if v is Verdict.PROVED else v
                    for name, v in outcome.verdicts.items()
                }
                outcome = replace(
                    outcome, verdict=Verdict.CONDITIONAL, conditions=needed, verdicts=verdicts
                )
        against: Counterexample | None = None
        if outcome.verdict is Verdict.REFUTED and isinstance(decided.verdicts, Denial):
            against = counterexample(statement, decided.verdicts, decided.accepted)
            if against is None:
                denied = statement.goals[decided.verdicts.goal]
                outcome = replace(outcome, message=why(denied, decided.verdicts.evidence))
        told = ()
        if self.explain and decided.verdicts is not None:
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
        sources = []
        try:
            sources = [on.texts.statement(place).source for place in places]
            formulas = claim.formulas(on.texts)
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
            verdicts={name: verdict for name in self.arithmetics},
        )

    def _late(self, what: str) -> str:
        return f"not decided within {self.timeout:g} s by {what}"

    # -- corrections ---------------------------------------------------------------

    def _correct(self, claim: Claim, on: Elaborations) -> Correction | None:
        """The nearest true statement, decided in every arithmetic."""
        recorded = self.record.get(claim.id, {}).get("correction")
        try:
            with time_limit(self.timeout):
                wanted = recorded if isinstance(recorded, str) else None
                neighbour = correction(claim, on, wanted)
            if neighbour is None:
                return None
            mended = self.mended(neighbour.claim, on.under(neighbour.texts))
        except TimeoutError:
            return None
        if mended is None:
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
        """The verdict on a corrected claim, and its conditions."""
        statement = Statement(claim, on)
        verdicts = self._evidence(statement, f"{CORRECTED}/{claim.id}")
        exact = [a for a in self.arithmetics if a not in POINTS] or ["flint"]
        decided = [self._judged(statement, verdicts, arithmetic) for arithmetic in exact]
        for one in decided:
            if one.verdict is Verdict.ERROR:
                raise Unproved(one.message)
        if any(one.verdict is not Verdict.PROVED for one in decided):
            return None
        accepted = self._judged(statement, verdicts, "flint").accepted
        needed = conditions(statement, accepted, self.explain)
        return (Verdict.CONDITIONAL if needed else Verdict.PROVED), needed

    def _with_acceptance(self, claim: Claim, outcome: Outcome) -> Outcome:
        """An error, if the derivation accepts for this claim what nobody has proved."""
        for place in claim.establishes():
            if place not in self.accepted or place != claim.printed:
                continue
            proposed = outcome.correction.formulas if outcome.correction else ()
            as_printed = outcome.verdict.likely and outcome.formulas == (self.accepted[place],)
            if not as_printed and proposed != (self.accepted[place],):
                message = f"what the derivation accepts at {place.place} has not been proved"
                return replace(outcome, verdict=Verdict.ERROR, message=message)
        return outcome

    def _corrected(self, claim: Claim, statement: Statement) -> tuple[str, ...]:
        """The claims whose accepted corrections a statement rests on."""
        own = set(claim.establishes())
        used = {p for p in statement.places() if p in self.accepted and p not in own}
        ids = (self.established.get(place, place.place) for place in self.accepted if place in used)
        return tuple(dict.fromkeys(ids))

    def rests_on(self, statement: Statement) -> tuple[str, ...]:
        """The claims before this one that establish the places on which it stands."""
        ids = dict.fromkeys(self.established.get(place) for place in statement.places())
        before = self.order[statement.claim.id]
        return tuple(i for i in ids if i is not None and self.order[i] < before)

    def _products(self) -> int:
        return sum(at.ring.products for at in self._all_evaluations())

    def _all_evaluations(self) -> Iterator[Evaluation]:
        yield from self.evaluations.values()
        for setting in self.elaborations.made():
            if "finder" in setting.__dict__:
                yield setting.finder


def combined(parts: Iterable[str]) -> str:
    """One digest of many texts."""
    return sha256("\n".join(parts).encode()).hexdigest()[:16]
