"""A run over an author's texts: what does not change is decided once.

Where the author differs from the derivation, the cause of what is refuted is the formula in which
what the derivation has would have to be restored.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import zip_longest

from kowalevski_cas.audit.session import AS_BEFORE, AuditSession, formulas
from kowalevski_cas.limits import time_limit
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.corrections import printed_of, statement_of
from kowalevski_cas.verify.outcome import Correction, Outcome, Verdict
from kowalevski_cas.verify.statement import Statement


class AuthorSession(AuditSession):
    """A run over ``sources``, the displays that an author has typed otherwise than the derivation.

    What rests on displays that are ``refused``, and claims in ``other`` words than the derivation
    quotes, gets no verdict, but the reason. Nothing of it is kept in ``base``, the run over the
    derivation's own texts.
    """

    def __init__(
        self,
        base: AuditSession,
        sources: Mapping[Display, str],
        refused: Mapping[Display, str],
        other: Mapping[str, str],
    ) -> None:
        super().__init__(
            base.derivation, base.arithmetics, base.explain, base.stored, base.timeout,
            record=base.record,
        )  # fmt: skip
        self.patience = base.patience
        self.base = base
        self.known = base.outcomes
        self.refused, self.other = refused, other
        self.causes = {**base.causes}
        self.misprints = {**base.misprints}
        self.texts = self._with(base.texts, sources)
        self.elaborations = base.elaborations.apart(self.texts)
        self.changed = frozenset(
            printed for display in sources for printed in self._changed(display)
        )
        """The statements that are not those of the derivation."""

    @staticmethod
    def _with(texts: Texts, sources: Mapping[Display, str]) -> Texts:
        for display, tex in sources.items():
            texts = texts.with_source(display, tex)
        return texts

    def _changed(self, display: Display) -> Iterator[Printed]:
        new, old = formulas(self.texts, display), formulas(self.base.texts, display)
        for number, (one, other) in enumerate(zip_longest(new, old), 1):
            if one != other:
                yield display[number]

    def decide(self, claim: Claim) -> Outcome:
        """The outcome for a claim: that of the derivation, if its problem is the same."""
        if why := self.other.get(claim.id) or self._refusal(claim):
            return self.outcome_without_evidence(claim, self.on(claim), Verdict.UNDECIDED, why)
        known = self.known[claim.id]
        if not claim.reads() & self.changed or self._same(claim, known):
            return known
        self.causes.pop(claim.id, None)
        outcome = super().decide(claim)
        unclear = outcome.verdict in (Verdict.ERROR, Verdict.UNDECIDED, Verdict.TIMEOUT)
        with suppress(TimeoutError), time_limit(self.timeout):
            if unclear and not self._blame_changes(claim):
                outcome = outcome._replace(correction=self._restored(claim, self.on(claim)))
        return outcome

    def _refusal(self, claim: Claim) -> str:
        """Why nothing is said about a claim that rests on a display which is refused."""
        ids = {
            p.display.id: self.refused[p.display]
            for p in claim.reads()
            if p.display in self.refused
        }
        return "; ".join(f"{id}: {ids[id]}" for id in sorted(ids))

    def stands(self, id: str) -> bool:
        """What the derivation accepts, it has to prove on its own texts."""
        return self.base.stands(id)

    def _unexplained(self, claim: Claim, outcome: Outcome) -> bool:
        return outcome is not self.known[claim.id] and super()._unexplained(claim, outcome)

    def _same(self, claim: Claim, known: Outcome) -> bool:
        """Whether a claim that is true in the derivation is typed as the same problem."""
        try:
            with time_limit(self.timeout):
                on = self.on(claim)
                said = claim.formulas(on.texts) == known.formulas
                return known.verdict.green and said and Statement(claim, on).digest == known.digest
        except Exception:  # then deciding it says why
            return False

    def with_acceptance(self, claim: Claim, outcome: Outcome) -> Outcome:
        """Nothing is wrong with the derivation where the author has caused what is."""
        return outcome if claim.id in self.causes else super().with_acceptance(claim, outcome)

    def known_corrections(self, printed: Statement) -> Sequence[Correction]:
        if self._blame_changes(printed.claim):
            return []
        try:
            restored = self._restored(printed.claim, printed.on)
            return [restored] if restored else super().known_corrections(printed)
        except Exception:  # candidates are made of what an author types
            return []

    def _restored(self, claim: Claim, on: Elaborations) -> Correction | None:
        """What the derivation has for a claim, if the author has changed that and it is true."""
        own = tuple(place for place in claim.establishes() if place in self.changed)
        known = self.known[claim.id]
        good: Outcome | Correction | None = known if known.verdict.green else known.correction
        if not own:
            return None
        self.causes[claim.id] = own
        if good is None or not self._as_in_base(claim, self._without(own)):
            return None
        with suppress(NotationError, Meaningless):
            for neighbour in claim.neighbours(on.texts):
                if printed_of(neighbour) == good.formulas:
                    return self.correction_of(neighbour, statement_of(neighbour, on))
        return Correction(
            good.formulas, AS_BEFORE, good.verdict, good.conditions, good.digest,
            certificate=good.certificate,
        )  # fmt: skip

    def _blame_changes(self, claim: Claim) -> bool:
        """Whether changes elsewhere are what makes a claim come out otherwise than in the base."""
        own = set(claim.establishes())
        suspects: dict[Display, list[Printed]] = {}
        for printed in sorted(claim.reads() & self.changed, key=lambda p: p.place):
            if printed not in own:
                suspects.setdefault(printed.display, []).append(printed)
        if not suspects:
            return False
        if not self.known[claim.id].verdict.green and self._as_in_base(claim, self.texts):
            return False
        guilty = [ps for ps in suspects.values() if self._as_in_base(claim, self._without(ps))]
        every = [place for places in suspects.values() for place in places]
        if not guilty and self._as_in_base(claim, self._without(every)):
            guilty = [every]
        if guilty:
            self.causes[claim.id] = tuple(place for places in guilty for place in places)
        return bool(guilty)

    def _without(self, places: Iterable[Printed]) -> Texts:
        """The author's texts with the displays of some places as the derivation has them."""
        gone = {printed.display for printed in places}
        kept = {printed.display for printed in self.changed} - gone
        return self._with(self.base.texts, {one: self.texts.sources[one.id] for one in kept})

    def _as_in_base(self, claim: Claim, texts: Texts) -> bool:
        """Whether a claim is as true as in the base, with its correction where that has one."""
        known = self.known[claim.id]
        if texts is self.base.texts:
            return True
        if known.verdict.green:
            return self._true(claim, texts)
        proposed = known.correction
        if proposed is not None and proposed.printed is not None and proposed.edit is not None:
            return self._true(claim, texts.with_edit(proposed.printed, proposed.edit))
        try:
            return Statement(claim, self.on(claim, texts)).digest == known.digest
        except TimeoutError:
            raise
        except Exception:  # as above
            return False
