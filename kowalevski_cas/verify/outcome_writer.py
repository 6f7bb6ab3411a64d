"""What is said about a claim that is decided: conditions, a counterexample, the steps."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.verify.archive import Archive
from kowalevski_cas.verify.arithmetics import Arithmetics, Decided
from kowalevski_cas.verify.certify import certify
from kowalevski_cas.verify.counterexamples import counterexample, why
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import (
    DECIDED,
    Counterexample,
    Outcome,
    ReportedStep,
    Screened,
    Verdict,
)
from kowalevski_cas.verify.statement import Statement


def disagreement(verdicts: Mapping[str, Verdict]) -> bool:
    """Whether two arithmetics decided differently; an undecided one disagrees with none."""
    green = {v.green for v in verdicts.values() if v in DECIDED}
    return len(green) > 1


class OutcomeWriter:
    """Outcomes of claims that are decided, and of those that are not."""

    def __init__(
        self,
        interpretation: Interpretation,
        arithmetics: Arithmetics,
        archive: Archive,
        explain: bool = False,
    ) -> None:
        self._interpretation = interpretation
        self._arithmetics = arithmetics
        self._archive = archive
        self.explain = explain
        """Whether outcomes tell their steps."""

    def outcome(self, statement: Statement, found: Mapping[str, Decided | Screened]) -> Outcome:
        """The outcome for a statement, by what each arithmetic says."""
        first = found[self._arithmetics.names[0]]
        verdicts = {name: answer.verdict for name, answer in found.items()}
        verdict, message = first.verdict, first.message
        if disagreement(verdicts):
            shown = ", ".join(f"{name}: {v}" for name, v in verdicts.items())
            verdict, message = Verdict.ERROR, f"the arithmetics disagree ({shown})"
        else:
            answered = (*DECIDED, Verdict.PROBABLE, Verdict.ENCLOSED)
            open_ones = [answer for answer in found.values() if answer.verdict not in answered]
            if open_ones:
                verdict, message = open_ones[0].verdict, open_ones[0].message
        outcome = self.without_evidence(statement.claim, statement.on, verdict, message, statement)
        used = self._interpretation.corrections_used(statement)
        outcome = outcome._replace(verdicts=verdicts, corrected=used)
        if isinstance(first, Screened):
            return outcome._replace(
                counterexample=first.counterexample, chance=first.chance, radius=first.radius
            )
        return self._explain(outcome, statement, first)

    def _explain(self, outcome: Outcome, statement: Statement, decided: Decided) -> Outcome:
        """An outcome with its conditions, its counterexample and its steps."""
        if outcome.verdict in DECIDED:
            if self._arithmetics.names[0] != "flint":
                decided = self._arithmetics.judge(statement, decided.verdicts, "flint")
            stored = self._archive.certificates.get(statement.claim.id)
            needed, text, divided = certify(decided, stored)
            outcome = outcome._replace(certificate=text, divided=divided)
            if outcome.verdict is Verdict.PROVED:
                outcome = outcome._replace(message=statement.claim.remark(statement.on))
            if needed:
                verdicts: dict[str, Verdict] = {
                    name: Verdict.CONDITIONAL if v is Verdict.PROVED else v
                    for name, v in outcome.verdicts.items()
                }
                outcome = outcome._replace(
                    verdict=Verdict.CONDITIONAL, conditions=needed, verdicts=verdicts
                )
        against: Counterexample | None = None
        if outcome.verdict is Verdict.REFUTED and isinstance(decided.verdicts, Denial):
            try:
                against = counterexample(statement, decided.verdicts, decided.accepted)
            except OverflowError as error:
                return outcome._replace(verdict=Verdict.ERROR, message=str(error))
            if against is None:
                denied = statement.goals[decided.verdicts.goal]
                message = why(statement.claim, denied, decided.verdicts.evidence)
                outcome = outcome._replace(message=message)
        told: tuple[ReportedStep, ...] = ()
        if self.explain and decided.verdicts is not None:
            from kowalevski_cas.verify.steps import steps  # a verdict needs none

            told = steps(statement, decided.verdicts)
        return outcome._replace(
            counterexample=against, steps=told, rests_on=self._interpretation.rests_on(statement)
        )

    def without_evidence(
        self,
        claim: Claim,
        on: Elaborations,
        verdict: Verdict,
        message: str,
        statement: Statement | None = None,
    ) -> Outcome:
        """An outcome that says what the claim is, and no more than the verdict."""
        formulas: tuple[Formula, ...] = ()
        branches: tuple[Formula, ...] = ()
        sources = []
        try:
            sources = [on.texts.statement(place).source for place in claim.shown()]
            formulas = claim.formulas(on.texts)
            chosen = dict.fromkeys(place for s in claim.scenes() for place in s.branches())
            branches = tuple(map(on.texts.formula, chosen))
        except Exception:  # what is wrong with the formulas, the verdict says
            pass
        granted = dict.fromkeys(tex for scene in claim.scenes() for tex in scene.nonzero)
        return Outcome(
            claim=claim.id,
            section=self._interpretation.section_of(claim),
            scene=claim.scene.name,
            formulas=formulas,
            source=r",\quad ".join(sources),
            words=claim.words,
            verdict=verdict,
            message=message,
            digest="" if statement is None else statement.digest,
            granted=tuple(map(on.texts.expression, granted)),
            branches=branches,
            verdicts={name: verdict for name in self._arithmetics.names},
            ours=claim.ours,
            cites=self._interpretation.cites(claim),
        )

    def resting(self, claim: Claim, outcome: Outcome, stands: Callable[[str], bool]) -> Outcome:
        """The outcome for a claim; it is undecided if something that it rests on is."""
        missing = [id for id in outcome.corrected if not stands(id)]
        decided = outcome.verdict is Verdict.REFUTED or outcome.verdict.likely
        if not (decided and missing):
            return outcome
        on, why_not = self._interpretation.on(claim), f"rests on {', '.join(missing)}"
        unread = self.without_evidence(claim, on, Verdict.UNDECIDED, why_not)
        return unread._replace(
            digest=outcome.digest, corrected=outcome.corrected, seconds=outcome.seconds
        )
