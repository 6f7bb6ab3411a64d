"""The correction of a refuted claim, decided like any claim.

A correction is accepted by the derivation, in a line of its own. Whatever is read so rests on it:
on a proof of the claim as it is corrected.
"""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.algebra import POINTS
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.bench import Decided
from kowalevski_cas.verify.corrections import corrections, printed_of, recorded_correction
from kowalevski_cas.verify.outcome import CORRECTED, Correction, Outcome, Verdict
from kowalevski_cas.verify.statement import Statement
from kowalevski_cas.verify.teller import Teller
from kowalevski_cas.verify.vacuous import says_something


class Mender(Teller):
    """Corrections of claims, and their acceptance."""

    def correct(self, printed: Statement) -> Correction | None:
        """The nearest true statement, decided in every arithmetic."""
        found = (self.proposed(*candidate) for candidate in self._candidates(printed))
        return next((one for one in found if one is not None), None)

    def _candidates(self, printed: Statement) -> Iterator[tuple[Neighbour, Statement]]:
        """What the derivation accepts, what is recorded, and what is found; true, or not."""
        claim = printed.claim
        accepted = [
            tex for place, tex in self.derivation.accepted.items() if place == claim.printed
        ]
        recorded = self.record.get(claim.id, {}).get("correction")
        for tex in (*accepted, *([recorded] if isinstance(recorded, str) else [])):
            found = recorded_correction(claim, printed.on, tex)
            if found is not None and says_something(*found, printed):
                if tex in accepted or self._leaves_true(claim, found[0]):
                    yield found
        for found in corrections(printed):
            if self._leaves_true(claim, found[0]):
                yield found

    def _leaves_true(self, claim: Claim, neighbour: Neighbour) -> bool:
        """Whether the other claims that are true of a changed formula stay true."""
        place, edit = neighbour.printed, neighbour.edit
        if place is None or edit is None:
            return True
        texts = self.texts.edited(place, edit)
        for other in self.derivation.claims:
            if other is not claim and place in other.reads():
                try:
                    now = Statement(other, self.on(other))
                    evidence = self._evidence(now, other.id)
                except (NotationError, Meaningless, FormatError):
                    continue  # it is not true now
                if isinstance(evidence, tuple) and not self._holds(other, texts, now.digest):
                    return False
        return True

    def _holds(self, claim: Claim, texts: Texts, digest: str) -> bool:
        """Whether a claim is true under other texts; it is if its problem has this digest."""
        try:
            statement = Statement(claim, self.on(claim, texts))
            return statement.digest == digest or statement.holds()
        except (NotationError, Meaningless, ZeroDivisionError):
            return False

    def proposed(self, neighbour: Neighbour, statement: Statement) -> Correction | None:
        """A neighbour as a correction, if what it says is proved."""
        name = f"{CORRECTED}/{statement.claim.id}"
        decided = self.anew(statement, name, lambda: self._proved(statement, name))
        if decided is None:
            return None
        needed, text = self.certified(decided, name)
        return Correction(
            printed_of(neighbour), neighbour.words,
            Verdict.CONDITIONAL if needed else Verdict.PROVED, needed, statement.digest,
            neighbour.printed, neighbour.edit, certificate=text,
        )  # fmt: skip

    def _proved(self, statement: Statement, name: str) -> Decided | None:
        """What FLINT accepts of a statement that is proved in every exact arithmetic."""
        verdicts = self._evidence(statement, name)
        exact = dict.fromkeys(("flint", *(a for a in self.arithmetics if a not in POINTS)))
        decided = [self._judged(statement, verdicts, arithmetic) for arithmetic in exact]
        return decided[0] if all(d.verdict is Verdict.PROVED for d in decided) else None

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
