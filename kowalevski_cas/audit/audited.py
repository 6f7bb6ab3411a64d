"""A formula of a source and what an audit says about it."""

from __future__ import annotations

from dataclasses import dataclass, field

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.source.text import Region
from kowalevski_cas.verify.outcome import Condition, Correction, Counterexample, Verdict

GIVEN = "given"
SUSPECT = "suspect"
MISSING = "missing"
UNREADABLE = "unreadable"
NEW = "new"
OPEN = "open"
"""Of a claim that is not judged, or a formula that is not read, in a source read by itself."""

WRONG = frozenset({str(Verdict.REFUTED), str(Verdict.ERROR), SUSPECT, MISSING, UNREADABLE})
"""Verdicts of formulas that an author has to look at."""


@dataclass
class Audited:
    """A formula of the source, or one that is missing from it.

    ``verdict`` is the worst of the verdicts on the claims that are about the
    formula; without claims it is ``given``, or ``suspect`` if its change makes
    claims false. ``causes`` are the places to blame for a claim that is not true.
    """

    id: str
    label: str
    region: Region
    tex: str
    role: str
    verdict: str
    claims: tuple[str, ...] = ()
    conditions: tuple[Condition, ...] = ()
    counterexample: Counterexample | None = None
    correction: Correction | None = None
    alternatives: tuple[Correction, ...] = ()
    causes: tuple[str, ...] = ()
    breaks: tuple[str, ...] = ()
    """The claims that are not true because of this formula."""
    moved: bool = False
    message: str = ""
    reason: str = ""
    """Why it has its role, where a rule of reading gave it."""
    on: tuple[str, ...] = ()
    """The formulas that are supposed for its verdict."""
    place: Printed | None = field(default=None, repr=False)
    formula: Formula | None = field(default=None, repr=False)
    """What is read there."""

    @property
    def name(self) -> str:
        """Its place in the derivation, or its id if it has none."""
        return self.id if self.place is None else self.place.place

    @property
    def line(self) -> int:
        """The line in its file at which it begins; 0 if it is not in the source."""
        return self.region.line

    @property
    def wrong(self) -> bool:
        """Whether the author has to look at it."""
        return self.verdict in WRONG
