"""The correction of a refuted claim, decided like any claim; certificates of both.

A correction is accepted by the derivation, in a line of its own. Whatever is read so rests on it:
on a proof of the claim as it is corrected.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

from kowalevski_cas.algebra import POINTS
from kowalevski_cas.notation import Edit, Formula, NotationError
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.bench import Decided
from kowalevski_cas.verify.certificate import CORRECTED, certificate
from kowalevski_cas.verify.corrections import corrections, printed_of, recorded_correction
from kowalevski_cas.verify.necessary import conditions, failures
from kowalevski_cas.verify.outcome import Condition, Correction, Outcome, Verdict, as_recorded
from kowalevski_cas.verify.statement import Statement
from kowalevski_cas.verify.teller import DECIDED, Teller
from kowalevski_cas.verify.vacuous import says_something


class Mender(Teller):
    """Corrections of claims, their acceptance, and certificates."""

    def known_corrections(self, printed: Statement) -> Sequence[Correction]:
        """What the derivation accepts, or else is recorded, decided in every arithmetic."""
        return [*islice(self._proposed(self._known(printed)), 1)]

    def corrected_by(self, printed: Statement, most: int) -> Iterator[Correction]:
        """The nearest true statements, so many at most, decided in every arithmetic."""
        return islice(self._proposed(self._near(printed)), most)

    def _proposed(self, candidates: Iterable[tuple[Neighbour, Statement]]) -> Iterator[Correction]:
        found = (self.proposed(*candidate) for candidate in candidates)
        return (one for one in found if one is not None)

    def _known(self, printed: Statement) -> Iterator[tuple[Neighbour, Statement]]:
        """What the derivation accepts, and what is recorded; true, or not."""
        claim = printed.claim
        accepted = [
            (tex, "") for place, tex in self.derivation.accepted.items() if place == claim.printed
        ]
        entry = self.record.get(claim.id, {})
        recorded = str(entry.get("correction") or ""), str(entry.get("mended", ""))
        for known in (*accepted, *([recorded] if recorded[0] else [])):
            found = recorded_correction(claim, printed.on, *known)
            if found is not None and says_something(*found, printed):
                if known in accepted or self._leaves_true(claim, found[0]):
                    yield found

    def _near(self, printed: Statement) -> Iterator[tuple[Neighbour, Statement]]:
        """What is found near a claim that is true, and leaves true what is true."""
        for found in corrections(printed):
            if self._leaves_true(printed.claim, found[0]):
                yield found

    def _leaves_true(self, claim: Claim, neighbour: Neighbour) -> bool:
        """Whether the other claims that are true of a changed formula stay true."""
        place, edit = neighbour.printed, neighbour.edit
        if place is None or edit is None:
            return True
        others = (c for c in self.derivation.claims if c is not claim and place in c.reads())
        return all(self.keeps(other, place, edit) for other in others if self._is_true(other))

    def _is_true(self, claim: Claim) -> bool:
        try:
            return isinstance(self._evidence(Statement(claim, self.on(claim)), claim.id), tuple)
        except (NotationError, Meaningless, FormatError):
            return False

    def keeps(self, claim: Claim, place: Printed, edit: Edit) -> bool:
        """Whether a claim that is true stays so under an edit, as if it says the same."""
        try:
            edited = claim.edited(self.texts, place, edit)
            statement = Statement(edited.claim, self.on(edited.claim, edited.texts))
            same = statement.digest == Statement(claim, self.on(claim)).digest
            return same or statement.holds()
        except (NotationError, Meaningless, ZeroDivisionError):
            return False

    def proposed(self, neighbour: Neighbour, statement: Statement) -> Correction | None:
        """A neighbour as a correction, if what it says is proved."""
        mended = self.mended(statement)
        if mended is None:
            return None
        place, edit = neighbour.printed, neighbour.edit
        formulas, blamed = printed_of(neighbour), tuple[Formula, ...]()
        if place is not None and edit is None:  # a relation of constants, which is not printed
            formulas = (neighbour.texts.formula(place),)
        elif edit is not None and place not in {*neighbour.claim.establishes()}:
            formulas, blamed = (edit.formula,), (edit.statement.formula,)
        return Correction(formulas, neighbour.words, *mended, place, edit, blamed=blamed)

    def mended(self, statement: Statement) -> tuple[Verdict, tuple[Condition, ...], str] | None:
        """The verdict on a corrected claim, its conditions and its digest, if it is proved."""
        name = f"{CORRECTED}/{statement.claim.id}"
        verdicts = self._evidence(statement, name)
        exact = dict.fromkeys(("flint", *(a for a in self.arithmetics if a not in POINTS)))
        decided = [self._judged(statement, verdicts, arithmetic) for arithmetic in exact]
        for one in decided:
            if one.verdict is Verdict.ERROR:
                raise Unproved(one.message)
        if any(one.verdict is not Verdict.PROVED for one in decided):
            return None
        needed = conditions(statement, decided[0].accepted, self.stored.get(name))
        verdict = Verdict.CONDITIONAL if needed else Verdict.PROVED
        return verdict, needed, statement.digest

    # -- acceptance ----------------------------------------------------------------

    def with_acceptance(self, claim: Claim, outcome: Outcome) -> Outcome:
        """The outcome, with its correction accepted; an error if what is accepted is not proved."""
        place = claim.printed
        if place not in self.accepted or place not in set(claim.establishes()):
            return outcome
        if outcome.verdict is not Verdict.REFUTED and not outcome.verdict.likely:
            return outcome
        if not self._confirms(claim, outcome):
            message = f"what the derivation accepts at {place.place} has not been proved"
            return outcome._replace(verdict=Verdict.ERROR, message=message)
        correction = outcome.correction
        if correction is None:
            return outcome
        return outcome._replace(correction=correction._replace(accepted=True))

    def _confirms(self, claim: Claim, outcome: Outcome) -> bool:
        """Whether an outcome shows what the derivation accepts in place of what is printed."""
        if claim.printed not in self.accepted:
            return False
        formulas = claim.formulas(self.texts.reading({claim.printed: self.accepted[claim.printed]}))
        if outcome.correction is not None:
            return outcome.correction.formulas == formulas
        return outcome.verdict.likely and outcome.formulas == formulas

    # -- certificates --------------------------------------------------------------

    def certificates(self, claim: Claim) -> Iterator[tuple[str, str]]:
        """The certificate of a claim, and that of a correction that is known, by name.

        Raises ``FormatError`` or ``Rejected`` if one cannot be written, :class:`Unproved` if the
        claim is not decided.
        """
        statement = Statement(claim, self.on(claim))
        decided = self._judged(statement, self._evidence(statement, claim.id), "flint")
        self.verdicts[claim.id] = decided.verdict
        yield claim.id, self._certificate(decided, claim.id)
        if decided.verdict is Verdict.REFUTED:
            for _, mended in self._known(statement):
                if self.mended(mended) is not None:
                    yield self._corrected(mended)
                    return

    def certificate_of(
        self, claim: Claim, corrections: Sequence[Correction]
    ) -> Iterator[tuple[str, str]]:
        """The certificate of the first correction of a claim, with its name."""
        on = self.on(claim)
        for one in corrections[:1]:
            tex = as_recorded(one.formulas, one.words, claim.formulas(on.texts))
            found = recorded_correction(claim, on, tex, one.elsewhere)
            if found is not None:
                yield self._corrected(found[1])

    def _corrected(self, corrected: Statement) -> tuple[str, str]:
        name = f"{CORRECTED}/{corrected.claim.id}"
        decided = self._judged(corrected, self._evidence(corrected, name), "flint")
        return name, self._certificate(decided, name)

    def _certificate(self, decided: Decided, name: str) -> str:
        statement, verdicts, accepted = decided.statement, decided.verdicts, decided.accepted
        if verdicts is None or decided.verdict not in DECIDED:
            raise Unproved(f"the claim is {decided.verdict}")
        green = decided.verdict is Verdict.PROVED
        failing = failures(statement, accepted, self.stored.get(name)) if green else {}
        return certificate(statement, verdicts, accepted, failing)
