"""The audit of a source that is its own derivation.

What fails is refuted only where the reading is sure; else it is undecided, since it may have been
read otherwise than it was meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from time import perf_counter
from typing import NamedTuple

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import OPEN, UNREADABLE, Audited
from kowalevski_cas.audit.author import AuthorSession
from kowalevski_cas.audit.describe import Describer
from kowalevski_cas.audit.places import Place
from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.reading import ASSUMPTION, CLAIM, LAW, Formula, Reading
from kowalevski_cas.reading.obey import SAID
from kowalevski_cas.reading.uncovered import Uncovered, sentences
from kowalevski_cas.verify.outcome import Outcome, Verdict

FALSE_AS_READ = "false as it was read"
NOT_JUDGED = "no goal states it yet"


class ReadingSession(AuditSession):
    """A run over a reading.

    A claim is refuted if it has a repair or an ancestor is to blame, or if it is a printed rate or
    integral of a closed, printed law; whatever else fails is undecided.
    """

    def __init__(
        self,
        reading: Reading,
        arithmetics: Sequence[str] = ("flint",),
        explain: bool = False,
        timeout: float | None = None,
    ) -> None:
        super().__init__(reading.derivation, arithmetics, explain, timeout=timeout)
        self.reading = reading
        every = (*reading.formulas, *reading.statements)
        self.claiming = {f.claim.id: f for f in every if f.claim is not None}

    @cached_property
    def outcomes(self) -> dict[str, Outcome]:
        """What is said about each claim."""
        return {id: self.as_read(outcome) for id, outcome in super().outcomes.items()}

    def as_read(self, outcome: Outcome) -> Outcome:
        """An outcome, undecided if what is refuted may have been meant otherwise."""
        if outcome.verdict is not Verdict.REFUTED:
            return outcome
        formula = self.claiming[outcome.claim]
        if outcome.correction is not None or outcome.claim in self.causes or is_certain(formula):
            return outcome
        return outcome._replace(verdict=Verdict.UNDECIDED, message=FALSE_AS_READ)


def is_certain(formula: Formula) -> bool:
    """Whether a claim is a printed rate or integral of a law, or what a comment states in full.

    Nothing is taken for granted then.
    """
    rate = formula.role.kind in ("integral", SAID) or formula.item.derives
    return rate and not formula.constants


def audit_reading(session: ReadingSession) -> Audit:
    """All formulas of a source that is its own derivation, with what a run says of each."""
    start, reading = perf_counter(), session.reading
    paper = reading.paper
    places = [Place(display, typed) for display, typed in paper.displays]
    author = AuthorSession(session, {}, {}, {})
    describe = Describer(paper.source, paper.expanded, author, {})
    found = [formula for place in places for formula in describe.formulas(place)]
    by_place = {formula.item.printed: formula for formula in reading.formulas}
    for audited in found:
        _as_read(audited, by_place.get(audited.place) if audited.place else None)
    notes = [(paper.source.line(offset), reason) for offset, reason in paper.expanded.notes]
    return Audit(
        paper.source, paper.expanded, places, found, author, notes, {},
        perf_counter() - start, reading, uncovered(reading),
    )  # fmt: skip


def uncovered(reading: Reading) -> list[Uncovered]:
    """The sentences that claim something, and by which no claim is made that is judged."""
    paper, said = reading.paper, reading.known.said
    judged = [f for f in (*reading.formulas, *reading.statements) if f.claim is not None]
    kinds = {(f.item.sentence, f.role.kind) for f in judged}
    stated = sentences(paper.prose, paper.source, paper.expanded, said.skipped(paper.prose))
    return [one for span, kind, one in stated if (span, kind) not in kinds]


def _as_read(audited: Audited, formula: Formula | None) -> None:
    """Give a formula the role that it was read in."""
    if formula is None:
        audited.role, audited.reason = "unread", audited.message
        audited.verdict = OPEN if audited.verdict == UNREADABLE else audited.verdict
        return
    audited.role, audited.reason = formula.role.name, formula.role.reason
    audited.on = tuple(item.printed.place for item in formula.on)
    if formula.role.name == CLAIM and formula.claim is None and not audited.claims:
        audited.verdict = OPEN
        audited.message = formula.message or NOT_JUDGED


class Assumed(NamedTuple):
    """Something that is taken for granted, and the claims that rest on it."""

    kind: str
    words: str
    place: Printed | None
    claims: tuple[str, ...]


def assumed(audit: Audit) -> Iterator[Assumed]:
    """What an audit takes for granted: assumptions, conventions, and names taken for constants."""
    reading = audit.reading
    assert reading is not None
    claiming = [formula for formula in reading.formulas if formula.claim is not None]
    for formula in reading.formulas:
        if formula.role.name == ASSUMPTION:
            claims = (f.claim.id for f in claiming if f.claim and formula.item in f.on)
            tex = formula.item.printed.tex
            yield Assumed("assumption", f"${tex}$", formula.item.printed, tuple(claims))
    names = dict.fromkeys(name for formula in claiming for name in formula.constants)
    for name in names:
        claims = (f.claim.id for f in claiming if f.claim and name in f.constants)
        yield Assumed("constant", f"${name}$ is defined nowhere", None, tuple(claims))


def is_read(audit: Audit) -> bool:
    """Whether there are equations of motion and at least one claim."""
    return {LAW, CLAIM} <= {formula.role for formula in audit.formulas}
