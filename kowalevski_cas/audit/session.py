"""A run over an author's texts: what does not change is decided once, and causes are named.

The derivation's own texts, with their corrections, are the base. Where a claim
fails on the author's texts because of a definition that the author has changed,
the definition is the cause, and the claim is not corrected to fit it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field

from kowalevski_cas.audit.reach import Reach
from kowalevski_cas.audit.roles import places_of
from kowalevski_cas.claims import Claim, Finding
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.derivation import Derivation
from kowalevski_cas.notation import Formula, NotationError
from kowalevski_cas.proof.dependencies import Dependencies
from kowalevski_cas.proof.evidence import Evidence
from kowalevski_cas.proof.limits import time_limit
from kowalevski_cas.proof.outcome import Correction, Outcome, Verdict
from kowalevski_cas.proof.verify import Session
from kowalevski_cas.stage import Stage
from kowalevski_cas.texts import Display, Printed, Texts

Key = tuple[object, ...]


@dataclass(slots=True)
class Memory:
    """What runs of one derivation share: stages, and outcomes by the texts they rest on."""

    derivation: Derivation
    arithmetics: Sequence[str] = ("flint",)
    evidence: dict[str, Evidence] = field(default_factory=dict)
    timeout: float | None = None
    patience: float = 5.0
    """Seconds that a correction is sought for."""
    stages: dict[object, Stage] = field(default_factory=dict)
    outcomes: dict[Key, Decided] = field(default_factory=dict)
    kept: Base | None = None
    rests: dict[Claim, frozenset[Printed]] = field(default_factory=dict)

    def places(self, claim: Claim) -> frozenset[Printed]:
        """Every place on which the verdict of a claim can depend."""
        if claim not in self.rests:
            self.rests[claim] = frozenset(places_of(claim))
        return self.rests[claim]

    @contextmanager
    def kept_small(self) -> Iterator[None]:
        """Forget, at the end, what a run under other texts has added."""
        sizes = [(table, len(table)) for table in (self.outcomes, self.stages)]
        try:
            yield
        finally:
            for table, size in sizes:
                while len(table) > size:
                    table.popitem()

    @property
    def base(self) -> Base:
        """The derivation as it stands, decided once."""
        if self.kept is None:
            session = AuditSession(self)
            own = session.texts
            outcomes = {outcome.claim: outcome for outcome in session.run().outcomes}
            self.kept = Base(own, session.texts, outcomes)
        return self.kept


@dataclass(frozen=True, slots=True)
class Base:
    """The texts of a derivation, those with all corrections, and the outcomes in between."""

    own: Texts
    texts: Texts
    outcomes: Mapping[str, Outcome]

    def corrected(self, display: Display) -> str:
        """The corrected source of a display."""
        return self.texts.sources.get(display.id, display.tex)


@dataclass(frozen=True, slots=True)
class Decided:
    """An outcome, the corrections that became part of the texts, and the causes."""

    outcome: Outcome
    corrected: tuple[tuple[Display, str], ...]
    causes: tuple[Printed, ...]


class AuditSession(Session):
    """A run over the displays in ``sources``, which differ from those of the derivation."""

    def __init__(
        self, memory: Memory, base: Base | None = None, sources: Mapping[Display, str] | None = None
    ) -> None:
        derivation = memory.derivation
        super().__init__(
            derivation, memory.arithmetics, False, _evidence(memory, sources or {}), memory.timeout
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
            self.changed = _changed(self.texts, base.own, sources or {})

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
        corrected = tuple(
            (place.display, self.texts.sources[place.display.id])
            for place in claim.establishes()
            if self.texts.sources.get(place.display.id) != before.get(place.display.id)
        )
        causes = self.causes.get(claim.id, ())
        if not causes and not outcome.verdict.green:
            causes = self._own(claim) or self._to_blame(claim)
        return Decided(outcome, corrected, causes)

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
        verdict = self._decide(claim, bench).verdict
        return verdict.green if green else verdict is expected.verdict


def _evidence(memory: Memory, sources: Iterable[Display]) -> dict[str, Evidence]:
    """The evidence that was kept, without corrections of displays that are typed otherwise."""
    typed = {display.id for display in sources}
    kept = dict(memory.evidence)
    for claim, entry in memory.evidence.items():
        if entry.correction is not None and entry.correction.place.rpartition(".")[0] in typed:
            kept[claim] = Evidence(entry.digest, entry.found)
    return kept


def _changed(texts: Texts, own: Texts, sources: Iterable[Display]) -> frozenset[Printed]:
    """The statements of the sources that are not those of the derivation."""
    changed: set[Printed] = set()
    for display in sources:
        new, old = formulas(texts, display), formulas(own, display)
        for number in range(1, max(len(new), len(old)) + 1):
            if new[number - 1 : number] != old[number - 1 : number]:
                changed.add(display[number])
    return frozenset(changed)


def formulas(texts: Texts, display: Display) -> tuple[Formula, ...]:
    """The statements of a display as they are read; none if it cannot be read."""
    found: list[Formula] = []
    try:
        while True:
            found.append(texts.statement(display[len(found) + 1]).formula)
    except NotationError:
        return tuple(found)
