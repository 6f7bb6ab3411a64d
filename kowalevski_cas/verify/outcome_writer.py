"""What is said about a claim that is decided: conditions, a counterexample, the steps."""

from __future__ import annotations

from collections.abc import Mapping

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.verify.certificate import Supported, certificate
from kowalevski_cas.verify.confirm import Disagreement, Issued, confirm, divisors_by_goal
from kowalevski_cas.verify.counterexamples import counterexample, why
from kowalevski_cas.verify.necessary import conditions
from kowalevski_cas.verify.outcome import (
    DECIDED,
    Condition,
    Counterexample,
    Divided,
    Outcome,
    ReportedStep,
    Screened,
    Verdict,
)
from kowalevski_cas.verify.statement import Statement
from kowalevski_cas.verify.workbench import Decided, Workbench


def disagreement(verdicts: Mapping[str, Verdict]) -> bool:
    """Whether two arithmetics decided differently; an undecided one disagrees with none."""
    green = {v.green for v in verdicts.values() if v in DECIDED}
    return len(green) > 1


class OutcomeWriter(Workbench):
    """Outcomes of claims that are decided, and of those that are not."""

    def _outcome(self, statement: Statement, found: Mapping[str, Decided | Screened]) -> Outcome:
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
        outcome = self.outcome_without_evidence(
            statement.claim, statement.on, verdict, message, statement
        )
        outcome = outcome._replace(verdicts=verdicts, corrected=self.corrections_used(statement))
        if isinstance(first, Screened):
            return outcome._replace(
                counterexample=first.counterexample, chance=first.chance, radius=first.radius
            )
        return self._explained(outcome, statement, first)

    def _explained(self, outcome: Outcome, statement: Statement, decided: Decided) -> Outcome:
        """An outcome with its conditions, its counterexample and its steps."""
        if outcome.verdict in DECIDED:
            if self.arithmetics[0] != "flint":
                decided = self._judged(statement, decided.verdicts, "flint")
            needed, text, divided = self.certified(decided, statement.claim.id)
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
            counterexample=against, steps=told, rests_on=self.rests_on(statement)
        )

    def certified(self, decided: Decided, name: str) -> tuple[tuple[Condition, ...], str, Divided]:
        """The conditions of what FLINT accepts, its certificate, and what FLINT divides by.

        ``name`` is that of the file. The checker has accepted it, if it is this process that has
        to have it checked.

        Raises :class:`Disagreement` if the checker rejects it, or has other conditions.
        """
        statement, verdicts, accepted = decided.statement, decided.verdicts, decided.accepted
        if verdicts is None or decided.verdict not in DECIDED:
            raise Disagreement(f"the arithmetics disagree (flint: {decided.verdict})")
        needed: tuple[Condition, ...] = ()
        failing: dict[Formula, Supported | None] = {}
        if not isinstance(verdicts, Denial):
            needed, failing = conditions(statement, accepted, self.stored.get(name))
        text = certificate(statement, verdicts, accepted, failing)
        sign: str = "denied"
        divided: Divided = ()
        if not isinstance(verdicts, Denial):
            sign, divided = "holds", divisors_by_goal(accepted)
        if self.checks:
            issued = Issued(statement.claim.id, statement.digest, sign, text, divided)
            confirm(issued, goals=statement.goals)
        return needed, text, divided

    def outcome_without_evidence(
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
            ours=claim.ours,
        )

    def corrections_used(self, statement: Statement) -> tuple[str, ...]:
        """The claims whose accepted corrections a statement rests on.

        Those of another derivation come first, after its name and a slash.
        """
        own, used = set(statement.claim.about()), {*statement.stands_on}
        ids = [id for place, id in self.read_elsewhere.items() if place in used]
        ids += [
            self.established.get(place, place.place)
            for place in self.accepted
            if place in used and place not in own
        ]
        return tuple(dict.fromkeys(ids))

    def rests_on(self, statement: Statement) -> tuple[str, ...]:
        """The claims before this one that establish the places on which it stands."""
        ids = dict.fromkeys(self.established.get(place) for place in statement.stands_on)
        before = self.order[statement.claim.id]
        return tuple(i for i in ids if i is not None and self.order[i] < before)
