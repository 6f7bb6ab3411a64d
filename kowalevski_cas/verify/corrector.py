"""The correction of a refuted claim, decided like any claim.

A correction is accepted by the derivation, in a line of its own. Whatever is read so rests on it:
on a proof of the claim as it is corrected.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import islice
from math import inf

from kowalevski_cas.limits import clock, time_limit
from kowalevski_cas.notation import Edit, Formula, NotationError
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.archive import Archive
from kowalevski_cas.verify.arithmetics import Arithmetics, Decided
from kowalevski_cas.verify.certify import certify
from kowalevski_cas.verify.corrections import corrections, formulas_printed_by, recorded_correction
from kowalevski_cas.verify.dependent import depend
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import CORRECTED, Correction, Outcome, Verdict
from kowalevski_cas.verify.statement import Statement
from kowalevski_cas.verify.vacuous import says_something


class Corrector:
    """Corrections of claims, and their acceptance.

    ``record`` says which corrections are tried first, and where there is none.
    """

    def __init__(
        self,
        interpretation: Interpretation,
        arithmetics: Arithmetics,
        archive: Archive,
        record: Mapping[str, Mapping[str, object]] | None = None,
    ) -> None:
        self.interpretation = interpretation
        self._arithmetics = arithmetics
        self._archive = archive
        self.record = record or {}

    def known(self, printed: Statement) -> Sequence[Correction]:
        """What the derivation accepts, or else is recorded, decided in every arithmetic."""
        return [*islice(self._proposal(self._accepted_or_recorded(printed)), 1)]

    def needs_search(self, outcome: Outcome) -> bool:
        """Whether it is refuted, without a correction, and no search is recorded that found none.

        Who has no certificate of it searches all anew.
        """
        then = self.record.get(outcome.claim, {})
        same = then.get("statement") == outcome.digest and "correction" in then
        kept = outcome.claim in self._archive.certificates
        none = same and kept and then["correction"] is None
        return outcome.verdict is Verdict.REFUTED and not outcome.correction and not none

    def near(self, printed: Statement, most: int, seconds: float = inf) -> Iterator[Correction]:
        """The nearest true statements, so many at most, decided in every arithmetic.

        Behind the first one others are sought for so many seconds; if one of these takes longer
        to be decided, there are no more.
        """
        ends = [inf]
        found = self._proposal(self._near(printed, lambda: clock() < ends[-1]))
        yield from islice(found, 1)
        ends.append(clock() + seconds)
        others: list[Correction] = []
        with suppress(TimeoutError), time_limit(2 * seconds):
            others.extend(islice(found, most - 1))
        yield from others

    def _proposal(self, candidates: Iterable[tuple[Neighbour, Statement]]) -> Iterator[Correction]:
        found = (self.correction_of(*candidate) for candidate in candidates)
        return (proposal for proposal in found if proposal is not None)

    def _accepted_or_recorded(self, printed: Statement) -> Iterator[tuple[Neighbour, Statement]]:
        """What the derivation accepts, and what is recorded; true, or not."""
        claim = printed.claim
        known_by_place = self.interpretation.derivation.accepted
        accepted = [(tex, "") for place, tex in known_by_place.items() if place == claim.printed]
        entry = self.record.get(claim.id, {})
        recorded = str(entry.get("correction") or ""), str(entry.get("mended", ""))
        for known in (*accepted, *([recorded] if recorded[0] else [])):
            found = recorded_correction(claim, printed.on, *known)
            if found is not None and says_something(*found, printed):
                if known in accepted or self._leaves_true(claim, found[0]):
                    yield found

    def _near(
        self, printed: Statement, goes_on: Callable[[], bool]
    ) -> Iterator[tuple[Neighbour, Statement]]:
        """What is found near a claim that is true, and leaves true what is true."""
        for found in corrections(printed, goes_on):
            if self._leaves_true(printed.claim, found[0]) and self._is_new(printed, found[1]):
                yield found

    def _is_new(self, printed: Statement, statement: Statement) -> bool:
        """Whether no other claim that is true says so already."""
        for claim in self.interpretation.derivation.claims:
            if claim is not printed.claim and claim.scene.field == printed.claim.scene.field:
                with suppress(NotationError, Meaningless):
                    other = self.interpretation.statement(claim)
                    if depend(statement, other) and not depend(printed, other):
                        return not self.is_true(claim)
        return True

    def _leaves_true(self, claim: Claim, neighbour: Neighbour) -> bool:
        """Whether the other claims that are true of a changed formula stay true."""
        place, edit = neighbour.printed, neighbour.edit
        if place is None or edit is None:
            return True
        others = (c for c in self.interpretation.readers(place) if c is not claim)
        return all(self.keeps(other, place, edit) for other in others if self.is_true(other))

    def is_true(self, claim: Claim) -> bool:
        """Whether evidence is found for a claim as it is printed."""
        try:
            statement = self.interpretation.statement(claim)
            return isinstance(self._archive.evidence(statement, claim.id), tuple)
        except (NotationError, Meaningless, FormatError):
            return False

    def keeps(self, claim: Claim, place: Printed, edit: Edit) -> bool:
        """Whether a claim that is true stays so under an edit, as if it says the same."""
        try:
            edited = claim.edited(self.interpretation.texts, place, edit)
            statement = self.interpretation.statement(edited.claim, edited.texts)
            same = statement.digest == self.interpretation.statement(claim).digest
            return same or statement.holds()
        except (NotationError, Meaningless, ZeroDivisionError):
            return False

    def correction_of(self, neighbour: Neighbour, statement: Statement) -> Correction | None:
        """A neighbour as a correction, if what it says is proved."""
        name = f"{CORRECTED}/{statement.claim.id}"
        decided = self._archive.anew(statement, name, lambda: self._accepts(statement, name))
        if decided is None:
            return None
        needed, text, divided = certify(decided, self._archive.certificates.get(name))
        place, edit = neighbour.printed, neighbour.edit
        formulas, blamed = formulas_printed_by(neighbour), tuple[Formula, ...]()
        if place is not None and edit is None:  # a relation of constants, which is not printed
            formulas = (neighbour.texts.formula(place),)
        elif edit is not None and place not in {*neighbour.claim.establishes()}:
            formulas, blamed = (edit.formula,), (edit.statement.formula,)
        verdict = Verdict.CONDITIONAL if needed else Verdict.PROVED
        return Correction(
            formulas, neighbour.words, verdict, needed, statement.digest, place, edit,
            certificate=text, divided=divided, blamed=blamed,
        )  # fmt: skip

    def _accepts(self, statement: Statement, name: str) -> Decided | None:
        """What FLINT accepts of a statement that is proved in every exact arithmetic."""
        verdicts = self._archive.evidence(statement, name)
        judge, exact = self._arithmetics.judge, self._arithmetics.exact
        decided = [judge(statement, verdicts, arithmetic) for arithmetic in exact]
        return decided[0] if all(d.verdict is Verdict.PROVED for d in decided) else None

    # -- acceptance ----------------------------------------------------------------

    def accept(self, claim: Claim, outcome: Outcome) -> Outcome:
        """The outcome, with its correction accepted; an error if what is accepted is not proved."""
        place = claim.printed
        if place not in self.interpretation.accepted or place not in set(claim.establishes()):
            return outcome
        if outcome.verdict is not Verdict.REFUTED and not outcome.verdict.likely:
            return outcome
        if not self.confirms(claim, outcome):
            message = f"what the derivation accepts at {place.place} has not been proved"
            return outcome._replace(verdict=Verdict.ERROR, message=message, certificate="")
        correction = outcome.correction
        if correction is None:
            return outcome
        return outcome._replace(correction=correction._replace(accepted=True))

    def confirms(self, claim: Claim, outcome: Outcome) -> bool:
        """Whether an outcome shows what the derivation accepts in place of what is printed."""
        place, accepted = claim.printed, self.interpretation.accepted
        if place not in accepted:
            return False
        formulas = claim.formulas(self.interpretation.texts.reading({place: accepted[place]}))
        if outcome.correction is not None:
            return outcome.correction.formulas == formulas
        return outcome.verdict.likely and outcome.formulas == formulas
