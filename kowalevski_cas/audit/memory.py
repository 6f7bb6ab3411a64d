"""What the audits of one derivation share, so that what does not change is decided once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field

from kowalevski_cas.audit.roles import places_of
from kowalevski_cas.claims import Claim
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.proof.evidence import Evidence
from kowalevski_cas.stage import Stage
from kowalevski_cas.verify.outcome import Outcome

Key = tuple[object, ...]


@dataclass
class Memory:
    """What runs of one derivation share: stages, and outcomes by the texts they rest on."""

    derivation: Derivation
    arithmetics: Sequence[str] = ("flint",)
    evidence: dict[str, Evidence] = field(default_factory=dict)
    timeout: float | None = None
    patience: float = 2.0
    """Seconds that a correction is sought for."""
    stages: dict[object, Stage] = field(default_factory=dict)
    outcomes: dict[Key, Decided] = field(default_factory=dict)
    base: Base | None = None
    """What :func:`~kowalevski_cas.audit.session.base_of` decides, once."""
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


@dataclass(frozen=True)
class Base:
    """The texts of a derivation, those with all corrections, and the outcomes in between."""

    own: Texts
    texts: Texts
    outcomes: Mapping[str, Outcome]

    def corrected(self, display: Display) -> str:
        """The corrected source of a display."""
        return self.texts.sources.get(display.id, display.tex)


@dataclass(frozen=True)
class Decided:
    """An outcome, the corrections that became part of the texts, and the causes."""

    outcome: Outcome
    corrected: tuple[tuple[Display, str], ...]
    causes: tuple[Printed, ...]
