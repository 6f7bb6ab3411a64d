"""The audit of a source that is its own derivation.

What fails is refuted only where the reading is sure; else it is undecided, since it may have been
read otherwise than it was meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from time import perf_counter
from typing import NamedTuple

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import OPEN, UNREADABLE, Audited
from kowalevski_cas.audit.author import AuthorSession
from kowalevski_cas.audit.describe import Describer
from kowalevski_cas.audit.places import Correspondence
from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.limits import time_limit
from kowalevski_cas.notation import Edit, Name, Negative, Number, Power, Relation, edits
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.reading import (
    ASSUMPTION,
    CLAIM,
    CONVENTION,
    DEFINITION,
    LAW,
    JudgedStatement,
    Reading,
)
from kowalevski_cas.reading.uncovered import Uncovered, sentences
from kowalevski_cas.verify.blame import Blame
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.run import FALSE_AS_READ, Progress, Work, run_together

PATIENCE = 15.0
"""Seconds for what claims share, and for each that is corrected by itself."""
NOT_JUDGED = "no goal states it yet"


class ReadingSession(AuditSession):
    """A run over a reading.

    What another formula explains has this formula for its cause, and is decided once more with it
    as it should read.
    """

    patience = PATIENCE

    def __init__(
        self,
        reading: Reading,
        arithmetics: Sequence[str] = ("flint",),
        explain: bool = False,
        timeout: float | None = None,
        heard: Progress = lambda *_: None,
    ) -> None:
        super().__init__(reading.derivation, arithmetics, explain, timeout=timeout)
        self.heard = heard
        self.reading = reading
        every = (*reading.formulas, *reading.statements)
        self.claiming = {f.claim.id: f for f in every if f.claim is not None}

    @cached_property
    def outcomes(self) -> dict[str, Outcome]:
        """What is said about each claim; processes share the work."""
        (run,) = run_together([self], progress=self.heard)
        found = {one.claim: self._blaming(one) for one in run.outcomes}
        self._mend(found)
        return {
            id: one._replace(verdict=Verdict.UNDECIDED) if one.verdict is Verdict.ERROR else one
            for id, one in found.items()
        }

    def _blaming(self, outcome: Outcome) -> Outcome:
        """An outcome; what mends another formula makes that the cause, and corrects none of it."""
        one = outcome.correction
        if one is None or not one.blamed or one.printed is None or one.edit is None:
            return outcome
        self.causes[outcome.claim] = (one.printed,)
        self.misprints[one.printed] = one.edit
        return outcome._replace(correction=None, alternatives=())

    # -- the imaginary unit ------------------------------------------------------------

    def with_corrections(self, outcomes: Sequence[Outcome], work: Work) -> list[Outcome]:
        """The outcomes with corrections; what a wrong unit spoils is decided once more, later."""
        claims = {claim.id: claim for claim in self.derivation.claims}
        for place, edit in self._units():
            failing = [
                claims[one.claim]
                for one in outcomes
                if one.verdict is Verdict.REFUTED and place in claims[one.claim].reads()
            ]
            texts = self.texts.with_edit(place, edit)

            def holds(number: int, failing: list[Claim] = failing, texts: Texts = texts) -> bool:
                with suppress(TimeoutError), time_limit(self.patience):
                    return self._true(failing[number], texts)
                return False

            if sum(work(holds, range(len(failing)))) > 1:
                self.misprints[place] = edit
        return super().with_corrections(outcomes, work)

    def _units(self) -> Iterator[tuple[Printed, Edit]]:
        """The printed squares of the imaginary unit that are not -1, each with what makes it so."""
        for item in self.reading.parts.known[0].units:
            place = item.printed
            right = Relation((Power(Name("i"), Number(2)), Negative(Number(1))), ("=",))
            if self.texts.formula(place) != right:
                statement = self.texts.statement(place)
                every = edits(statement, self.texts.vocabulary)
                yield from ((place, edit) for edit in every if edit.formula == right)
                return

    def blame(self, outcomes: Mapping[str, Outcome]) -> Blame:
        """The search for what makes claims fail that stand on no misprint that is known."""
        verdicts = {id: outcome.verdict for id, outcome in outcomes.items()}
        waiting = {c.id for c in self.derivation.claims if c.reads() & self.misprints.keys()}
        explained = [id for id, one in outcomes.items() if one.correction or id in waiting]
        return Blame(self, verdicts, explained)

    # -- what is mended elsewhere --------------------------------------------------------

    def _mend(self, found: dict[str, Outcome]) -> None:
        """Decide once more, with what is blamed as it should read, what that has not mended."""
        mended = {place: edit.formula for place, edit in self.misprints.items()}
        rest = [
            claim.id
            for claim in self.derivation.claims
            if self._waits(found[claim.id]) and claim.reads() & mended.keys()
        ]
        if not rest:
            return
        again = ReadingSession(self.reading, self.arithmetics, timeout=self.timeout)
        again.texts = self.texts.reading(mended)
        again.elaborations = self.elaborations.apart(again.texts)
        (run,) = run_together([again], rest, self.heard)
        for outcome in run.outcomes:
            own = outcome.correction is not None and not outcome.correction.blamed
            late = found[outcome.claim].verdict is Verdict.TIMEOUT
            if own or (outcome.verdict.green and not late):
                self.causes[outcome.claim] = (*mended,)
                corrections = () if outcome.correction is None else (outcome.correction,)
                failed = found[outcome.claim]._replace(verdict=Verdict.REFUTED, message="")
                found[outcome.claim] = failed.corrected_by(corrections)

    def _waits(self, outcome: Outcome) -> bool:
        """Whether a claim is false as it was read, or not decided, and nothing explains it."""
        open_ones = (Verdict.REFUTED, Verdict.TIMEOUT)
        failed = outcome.verdict in open_ones or outcome.message == FALSE_AS_READ
        return failed and outcome.correction is None and outcome.claim not in self.causes


def audit_reading(session: ReadingSession) -> Audit:
    """All formulas of a source that is its own derivation, with what a run says of each."""
    start, reading = perf_counter(), session.reading
    paper = reading.paper
    places = [Correspondence(display, typed) for display, typed in paper.displays]
    author = AuthorSession(session, {}, {}, {})
    describe = Describer(paper.source, paper.expanded, author, {})
    found = [formula for place in places for formula in describe.formulas(place)]
    by_place = {formula.item.printed: formula for formula in reading.formulas}
    for audited in found:
        _as_read(audited, by_place.get(audited.place) if audited.place else None)
    said = (*paper.source.refused, *paper.expanded.notes)
    notes = [(paper.source.line(offset), reason) for offset, reason in said]
    return Audit(
        paper.source, paper.expanded, places, found, author, notes, {},
        perf_counter() - start, reading, uncovered(reading),
    )  # fmt: skip


def uncovered(reading: Reading) -> list[Uncovered]:
    """The sentences that claim something, and by which no claim is made that is judged."""
    paper, said = reading.paper, reading.parts.said
    judged = [f for f in (*reading.formulas, *reading.statements) if f.claim is not None]
    kinds = {(f.item.sentence, f.role.kind) for f in judged}
    stated = sentences(paper.prose, paper.source, paper.expanded, said.skipped(paper.prose))
    return [one for span, kind, one in stated if (span, kind) not in kinds]


def _as_read(audited: Audited, formula: JudgedStatement | None) -> None:
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


def assumptions_of(audit: Audit) -> Iterator[Assumed]:
    """What an audit takes for granted: assumptions, conventions, and names taken for constants."""
    reading = audit.reading
    assert reading is not None
    claiming = [formula for formula in reading.formulas if formula.claim is not None]
    for formula in reading.formulas:
        if formula.role.name == ASSUMPTION:
            claims = (f.claim.id for f in claiming if f.claim and formula.item in f.on)
            tex = formula.item.printed.tex
            yield Assumed("assumption", f"${tex}$", formula.item.printed, tuple(claims))
    for formula in reading.formulas:
        if formula.role.name == CONVENTION:
            place = formula.item.printed
            claims = (f.claim.id for f in claiming if f.claim and place in f.claim.reads())
            yield Assumed("convention", f"${place.tex}$", place, tuple(claims))
    names = dict.fromkeys(name for formula in claiming for name in formula.constants)
    for name in names:
        claims = (f.claim.id for f in claiming if f.claim and name in f.constants)
        yield Assumed("constant", f"${name}$ is defined nowhere", None, tuple(claims))


def unchecked(audit: Audit) -> list[Audited]:
    """The definitions on which no verdict rests: nothing would show a misprint in them."""
    reading = audit.reading
    assert reading is not None
    claims = [formula.claim for formula in reading.formulas if formula.claim is not None]
    read = frozenset().union(*(claim.reads() for claim in claims))
    defining = {f.item.printed for f in reading.formulas if f.role.name == DEFINITION}
    return [one for one in audit.formulas if one.place in defining and one.place not in read]


def is_read(audit: Audit) -> bool:
    """Whether there are equations of motion and at least one claim."""
    return {LAW, CLAIM} <= {formula.role for formula in audit.formulas}
