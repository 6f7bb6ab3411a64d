"""What the derivation has in place of what an author has changed, as a correction."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress

from kowalevski_cas.audit.causes import AuditBase, Causes
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.corrections import formulas_printed_by, statement_of
from kowalevski_cas.verify.decider import Decider
from kowalevski_cas.verify.outcome import Correction, Outcome
from kowalevski_cas.verify.statement import Statement

AS_BEFORE = "as the derivation has it"
"""The words for a correction that restores what the author has changed."""


class Restoration:
    """The corrections of an author's claims that restore what the derivation, the ``base``, has.

    Which of the ``changed`` statements make a claim false is noted among the ``causes``.
    """

    def __init__(
        self, base: AuditBase, decider: Decider, changed: frozenset[Printed], causes: Causes
    ) -> None:
        self._base, self._decider = base, decider
        self._changed, self._causes = changed, causes

    def accept(self, claim: Claim, outcome: Outcome) -> Outcome:
        """Nothing is wrong with the derivation where the author has caused what is."""
        caused = claim.id in self._causes.places
        return outcome if caused else self._decider.corrector.accept(claim, outcome)

    def known(self, printed: Statement) -> Sequence[Correction]:
        """What was there before; if that explains nothing, what the derivation knows."""
        if self.blames_changes(printed.claim):
            return []
        try:
            restored = self.restored(printed.claim, printed.on)
            return [restored] if restored else self._decider.corrector.known(printed)
        except Exception:  # candidates are made of what an author types
            return []

    def restored(self, claim: Claim, on: Elaborations) -> Correction | None:
        """What the derivation has for a claim, if the author has changed that and it is true."""
        places = tuple(place for place in claim.establishes() if place in self._changed)
        known = self._base.outcomes[claim.id]
        good: Outcome | Correction | None = known if known.verdict.green else known.correction
        if not places:
            return None
        self._causes.places[claim.id] = places
        if good is None or not self._is_as_in_base(claim, self._without(places)):
            return None
        with suppress(NotationError, Meaningless):
            for neighbour in claim.neighbours(on.texts):
                if formulas_printed_by(neighbour) == good.formulas:
                    return self._decider.corrector.correction_of(
                        neighbour, statement_of(neighbour, on)
                    )
        return Correction(
            good.formulas, AS_BEFORE, good.verdict, good.conditions, good.digest,
            certificate=good.certificate,
        )  # fmt: skip

    def blames_changes(self, claim: Claim) -> bool:
        """Whether changes elsewhere are what makes a claim come out otherwise than in the base."""
        established = set(claim.establishes())
        suspects: dict[Display, list[Printed]] = {}
        for printed in sorted(claim.reads() & self._changed, key=lambda p: p.place):
            if printed not in established:
                suspects.setdefault(printed.display, []).append(printed)
        if not suspects:
            return False
        green = self._base.outcomes[claim.id].verdict.green
        if not green and self._is_as_in_base(claim, self._decider.interpretation.texts):
            return False
        guilty = [ps for ps in suspects.values() if self._is_as_in_base(claim, self._without(ps))]
        every = [place for places in suspects.values() for place in places]
        if not guilty and self._is_as_in_base(claim, self._without(every)):
            guilty = [every]
        if guilty:
            self._causes.places[claim.id] = tuple(place for places in guilty for place in places)
        return bool(guilty)

    def _without(self, places: Iterable[Printed]) -> Texts:
        """The author's texts with the displays of some places as the derivation has them."""
        gone = {printed.display for printed in places}
        kept = {printed.display for printed in self._changed} - gone
        typed = self._decider.interpretation.texts.sources
        before = self._base.decider.interpretation.texts
        return with_sources(before, {place: typed[place.id] for place in kept})

    def _is_as_in_base(self, claim: Claim, texts: Texts) -> bool:
        """Whether a claim is as true as in the base, with its correction where that has one."""
        known = self._base.outcomes[claim.id]
        interpretation = self._decider.interpretation
        if texts is self._base.decider.interpretation.texts:
            return True
        if known.verdict.green:
            return interpretation.holds(claim, texts)
        proposed = known.correction
        if proposed is not None and proposed.printed is not None and proposed.edit is not None:
            edited = texts.with_edit(proposed.printed, proposed.edit)
            return interpretation.holds(claim, edited)
        try:
            return interpretation.statement(claim, texts).digest == known.digest
        except TimeoutError:
            raise
        except Exception:  # as above
            return False


def with_sources(texts: Texts, sources: Mapping[Display, str]) -> Texts:
    """Texts in which some displays are typed otherwise."""
    for display, tex in sources.items():
        texts = texts.with_source(display, tex)
    return texts
