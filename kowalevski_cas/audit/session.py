"""A run over an author's texts: what does not change is decided once, and causes are named.

The derivation's own texts, with their corrections, are the base. Where a claim
fails on the author's texts because of a definition that the author has changed,
the definition is the cause, and the claim is not corrected to fit it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from kowalevski_cas.audit.differences import changed_places, spliced, usable_evidence
from kowalevski_cas.audit.memory import Base, Decided, Key, Memory
from kowalevski_cas.audit.reach import Reach
from kowalevski_cas.claims import Claim, Finding
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.proof.dependencies import Dependencies
from kowalevski_cas.proof.evidence import Evidence
from kowalevski_cas.proof.verify import Session
from kowalevski_cas.verify.limits import time_limit
from kowalevski_cas.verify.outcome import Correction, Outcome, Verdict

AS_BEFORE = "as the derivation has it"
"""The words for a correction that restores what the author has changed."""


class AuditSession(Session):
    """A run over the displays in ``sources``, which differ from those of the derivation."""

    def __init__(
        self, memory: Memory, base: Base | None = None, sources: Mapping[Display, str] | None = None
    ) -> None:
        derivation = memory.derivation
        super().__init__(
            derivation,
            memory.arithmetics,
            False,
            usable_evidence(memory, sources or {}),
            memory.timeout,
        )
        self.memory = memory
        self.stages = memory.stages
        self.base = base
        self.causes: dict[str, tuple[Printed, ...]] = {}
        self.changed: frozenset[Printed] = frozenset()
        if base is not None:
            self.texts = base.own
            for display, tex in (sources or {}).items():
                self.texts = self.texts.with_source(display, tex)
            self.dependencies = Dependencies(self.texts)
        self.reach = Reach(self.texts)
        if base is not None:
            self.changed = changed_places(self.texts, base.own, sources or {})

    def needed(self, chosen: Sequence[Claim]) -> list[Claim]:
        """All claims: an audit leaves none out."""
        return list(chosen)

    def decide(self, claim: Claim) -> Outcome:
        """The outcome for a claim, from memory if the texts it rests on were met before."""
        key, finer = self._keys(claim)
        known = self.memory.outcomes.get(key) or self.memory.outcomes.get(finer)
        if known is None:
            known = self._decided(claim)
            self.memory.outcomes[finer] = known
        self.memory.outcomes[key] = known
        for display, tex in known.corrected:
            if self.texts.sources.get(display.id) != tex:
                self.texts = self.texts.with_source(display, tex)
        self.causes[claim.id] = known.causes
        return known.outcome

    def _keys(self, claim: Claim) -> tuple[Key, Key]:
        """The texts on which a claim can rest, and those that names lead to."""
        places = self.memory.places(claim)
        key = (claim, self.texts.changes(places), self.changed & places)
        if key in self.memory.outcomes:
            return key, key
        if self.reach.texts is not self.texts:
            self.reach = Reach(self.texts)
        try:
            places = self.reach.places(claim)
        except NotationError:
            return key, key
        return key, (claim, "reach", self.texts.changes(places), self.changed & places)

    def _decided(self, claim: Claim) -> Decided:
        before = self.texts.sources
        outcome = super().decide(claim)
        own = self._own(claim)
        if own and not outcome.verdict.green and outcome.correction is None:
            found = None
            if outcome.verdict is Verdict.ERROR and outcome.digest:
                found = self._correct(claim, Evidence(outcome.digest))
            correct = found is not None and found.verdict.green
            outcome = replace(outcome, correction=found if correct else self._as_before(claim, own))
        causes = self.causes.get(claim.id, ())
        if not causes and not outcome.verdict.green:
            causes = own or self._to_blame(claim)
        if causes and not own:
            self._correct_as_in_base(claim)
        corrected = tuple(
            (place.display, self.texts.sources[place.display.id])
            for place in claim.establishes()
            if self.texts.sources.get(place.display.id) != before.get(place.display.id)
        )
        return Decided(outcome, corrected, causes)

    def _correct_as_in_base(self, claim: Claim) -> None:
        """Take over a correction of the base, which the claims that follow rest on."""
        assert self.base is not None
        known = self.base.outcomes[claim.id].correction
        if known is None or not known.verdict.green:
            return
        try:
            for place in claim.establishes():
                tex = spliced(self.texts, self.base.texts, place)
                self.texts = self.texts.with_source(place.display, tex)
        except NotationError:
            return

    def _own(self, claim: Claim) -> tuple[Printed, ...]:
        """The changed places among those that the claim establishes."""
        return tuple(printed for printed in claim.establishes() if printed in self.changed)

    def _correct(self, claim: Claim, kept: Evidence) -> Correction | None:
        """The nearest true statement, unless a changed definition is what makes it false."""
        if self.changed and not self._own(claim):
            self.causes[claim.id] = self._to_blame(claim)
            if self.causes[claim.id]:
                return None
        try:
            with time_limit(self.memory.patience):
                return super()._correct(claim, kept)
        except Exception:
            return None

    def _as_before(self, claim: Claim, own: Sequence[Printed]) -> Correction | None:
        """What the derivation has at changed places, if that is true under these texts."""
        assert self.base is not None
        texts = self.texts
        try:
            for printed in own:
                texts = texts.with_source(printed.display, spliced(texts, self.base.texts, printed))
            bench = Bench(self.arithmetics[0], texts, False, {}, self.stages, refute=False)
            finding = self._decide(claim, bench)
            formulas = tuple(texts.formula(printed) for printed in own)
        except NotationError:
            return None
        if not finding.verdict.green:
            return None
        self.texts = texts
        return Correction(formulas, AS_BEFORE, finding.verdict, finding.conditions)

    def _to_blame(self, claim: Claim) -> tuple[Printed, ...]:
        """The changed places without whose changes the claim would come out as in the base."""
        own = set(claim.establishes())
        suspects = [p for p in self.memory.places(claim) if p in self.changed and p not in own]
        if not suspects or self.base is None:
            return ()
        changed = {printed.display for printed in self.changed}
        texts = self.base.texts
        for display in changed:
            texts = texts.with_source(display, self.texts.sources[display.id])
        if self._as_in_base(claim, texts):
            return ()
        displays = list(dict.fromkeys(printed.display for printed in suspects))
        guilty = [d for d in displays if self._as_in_base(claim, self._mended(texts, [d]))]
        if not guilty and self._as_in_base(claim, self._mended(texts, displays)):
            guilty = displays
        return tuple(sorted((p for p in suspects if p.display in guilty), key=lambda p: p.place))

    def _mended(self, texts: Texts, displays: Iterable[Display]) -> Texts:
        """Texts with some displays as they are, corrected, in the base."""
        assert self.base is not None
        for display in displays:
            texts = texts.with_source(display, self.base.corrected(display))
        return texts

    def _decide(self, claim: Claim, bench: Bench) -> Finding:
        """The finding; what an author types must not end the audit of everything else."""
        try:
            return super()._decide(claim, bench)
        except Exception as error:
            message = f"it cannot be decided as it is typed ({type(error).__name__}: {error})"
            return Finding(Verdict.ERROR, message=message)

    def _as_in_base(self, claim: Claim, texts: Texts) -> bool:
        """Whether the claim, corrected where the base corrects it, has the verdict of the base."""
        assert self.base is not None
        expected = self.base.outcomes[claim.id]
        corrected = expected.correction is not None and expected.correction.verdict.green
        green = corrected or expected.verdict.green
        bench = Bench(self.arithmetics[0], texts, False, {}, self.stages, refute=not green)
        finding = self._decide(claim, bench)
        if green:
            return finding.verdict.green
        return (finding.verdict, finding.message) == (expected.verdict, expected.message)


def base_of(memory: Memory) -> Base:
    """The derivation as it stands, decided once."""
    if memory.base is None:
        session = AuditSession(memory)
        own = session.texts
        outcomes = {outcome.claim: outcome for outcome in session.run().outcomes}
        memory.base = Base(own, session.texts, outcomes)
    return memory.base
