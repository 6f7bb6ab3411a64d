"""A run over an author's texts: what does not change is decided once, and causes are named.

The derivation's own texts, with their corrections, are the base. Where a claim
fails on the author's texts because of a definition that the author has changed,
the definition is the cause, and the claim is not corrected to fit it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from kowalevski_cas.audit.roles import places_of
from kowalevski_cas.claims import Claim
from kowalevski_cas.derivation import Derivation
from kowalevski_cas.notation import Formula, NotationError
from kowalevski_cas.proof.evidence import Evidence
from kowalevski_cas.proof.outcome import Correction, Outcome
from kowalevski_cas.proof.verify import Session
from kowalevski_cas.stage import Stage
from kowalevski_cas.texts import Display, Printed, Texts

Key = tuple[object, ...]


@dataclass(slots=True)
class Memory:
    """What runs of one derivation share: stages, and outcomes by the texts they rest on."""

    arithmetics: Sequence[str] = ("flint",)
    evidence: dict[str, Evidence] = field(default_factory=dict)
    timeout: float | None = None
    stages: dict[object, Stage] = field(default_factory=dict)
    outcomes: dict[Key, Decided] = field(default_factory=dict)
    bases: dict[Derivation, Base] = field(default_factory=dict)

    def base(self, derivation: Derivation) -> Base:
        """The derivation as it stands, decided once."""
        if derivation not in self.bases:
            session = AuditSession(derivation, self)
            outcomes = session.run().outcomes
            self.bases[derivation] = Base(
                session.texts, {outcome.claim: outcome for outcome in outcomes}
            )
        return self.bases[derivation]


@dataclass(frozen=True, slots=True)
class Base:
    """The texts of a derivation with all corrections, and the outcomes on the way to them."""

    texts: Texts
    outcomes: Mapping[str, Outcome]

    def tex(self, display: Display) -> str:
        """The corrected source of a display."""
        return self.texts.sources.get(display.id, display.tex)


@dataclass(frozen=True, slots=True)
class Decided:
    """An outcome, the correction that became part of the texts, and the causes."""

    outcome: Outcome
    corrected: tuple[tuple[Display, str], ...]
    causes: tuple[Printed, ...]


class AuditSession(Session):
    """A run over the displays in ``sources``, which differ from those of the derivation."""

    def __init__(
        self,
        derivation: Derivation,
        memory: Memory,
        base: Base | None = None,
        sources: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(
            derivation, memory.arithmetics, False, dict(memory.evidence), memory.timeout, sources
        )
        self.memory = memory
        self.stages = memory.stages
        self.base = base
        self.displays = {display.id: display for display in derivation.displays()}
        self.changed = _changed(self.texts, base, self.displays, sources or {})
        self.causes: dict[str, tuple[Printed, ...]] = {}

    def decide(self, claim: Claim) -> Outcome:
        """The outcome for a claim, from memory if the texts it rests on were met before."""
        places = dict.fromkeys(places_of(claim))
        here = self.changed.intersection(places)
        key = (claim, self.texts.changes(places), frozenset(here))
        known = self.memory.outcomes.get(key)
        if known is None:
            known = self._decided(claim)
            self.memory.outcomes[key] = known
        for display, tex in known.corrected:
            if self.texts.sources.get(display.id) != tex:
                self.texts = self.texts.with_source(display, tex)
        self.causes[claim.id] = known.causes
        return known.outcome

    def _decided(self, claim: Claim) -> Decided:
        before = self.texts
        outcome = super().decide(claim)
        after = self.texts.sources
        corrected = tuple(
            (self.displays[id], tex) for id, tex in after.items() if before.sources.get(id) != tex
        )
        causes = self.causes.get(claim.id)
        if causes is None:
            own = () if outcome.verdict.green else self._own(claim)
            causes = own or (() if outcome.verdict.green else self._to_blame(claim))
        return Decided(outcome, corrected, causes)

    def _own(self, claim: Claim) -> tuple[Printed, ...]:
        return tuple(printed for printed in claim.establishes() if printed in self.changed)

    def _correct(self, claim: Claim, kept: Evidence) -> Correction | None:
        """The nearest true statement, unless a changed definition is what makes it false."""
        if self.changed and not self._own(claim):
            causes = self._to_blame(claim)
            if causes:
                self.causes[claim.id] = causes
                return None
        return super()._correct(claim, kept)

    def _to_blame(self, claim: Claim) -> tuple[Printed, ...]:
        """The changed places without whose changes the claim would come out as in the base."""
        if self.base is None:
            return ()
        own = set(claim.establishes())
        suspects = [p for p in dict.fromkeys(places_of(claim)) if p in self.changed - own]
        if not suspects:
            return ()
        texts = self._with_base(self.texts, (p.display for p in own - self.changed))
        if self._holds(claim, texts):
            return ()
        displays = list(dict.fromkeys(printed.display for printed in suspects))
        guilty = [d for d in displays if self._holds(claim, self._with_base(texts, (d,)))]
        if not guilty and self._holds(claim, self._with_base(texts, displays)):
            guilty = displays
        return tuple(printed for printed in suspects if printed.display in guilty)

    def _with_base(self, texts: Texts, displays: Iterable[Display]) -> Texts:
        """Texts with some displays as they are in the base."""
        assert self.base is not None
        for display in displays:
            tex = self.base.tex(display)
            if texts.sources.get(display.id, display.tex) != tex:
                texts = texts.with_source(display, tex)
        return texts

    def _holds(self, claim: Claim, texts: Texts) -> bool:
        """Whether the claim is true on these texts, as it is in the base."""
        from kowalevski_cas.claims.bench import Bench

        bench = Bench(self.arithmetics[0], texts, False, {}, self.stages, refute=False)
        return self._decide(claim, bench).verdict.green


def _changed(
    texts: Texts, base: Base | None, displays: Mapping[str, Display], sources: Mapping[str, str]
) -> frozenset[Printed]:
    """The statements in the sources that are not those of the derivation."""
    changed: set[Printed] = set()
    if base is None:
        return frozenset()
    own = Texts(texts.vocabulary, read=OWN_READ.setdefault(texts.vocabulary, {}))
    for id in sources:
        display = displays[id]
        new, old = statements(texts, display), statements(own, display)
        for number in range(1, max(len(new), len(old)) + 1):
            if new[number - 1 : number] != old[number - 1 : number]:
                changed.add(display[number])
    return frozenset(changed)


OWN_READ: dict[object, dict[str, object]] = {}
