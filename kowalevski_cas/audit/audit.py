"""An audit: the formulas of a source, each with its role and what the run says about it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from time import perf_counter

from kowalevski_cas.audit.displays import Typed, find_formulas
from kowalevski_cas.audit.limits import excess
from kowalevski_cas.audit.macros import Expanded, expand
from kowalevski_cas.audit.places import Place, find_places
from kowalevski_cas.audit.roles import Role, Roles, undefined
from kowalevski_cas.audit.session import AuditSession, Memory, formulas
from kowalevski_cas.audit.source import Source
from kowalevski_cas.audit.tokens import words
from kowalevski_cas.notation import NotationError, split_display
from kowalevski_cas.proof.outcome import Condition, Correction, Counterexample, Outcome, Verdict
from kowalevski_cas.texts import Display, Printed, Texts

GIVEN = "given"
SUSPECT = "suspect"
MISSING = "missing"
UNREADABLE = "unreadable"
NEW = "new"

_WORST = (
    Verdict.ERROR, Verdict.REFUTED, Verdict.TIMEOUT, Verdict.UNDECIDED, Verdict.PROBABLE,
    Verdict.ENCLOSED, Verdict.CONDITIONAL, Verdict.PROVED,
)  # fmt: skip
WRONG = frozenset({str(Verdict.REFUTED), str(Verdict.ERROR), SUSPECT, MISSING, UNREADABLE})
"""Verdicts of formulas that an author has to look at."""


@dataclass(slots=True)
class Audited:
    """A formula of the source, or one that is missing from it.

    ``verdict`` is the worst of the verdicts on the claims that are about the
    formula; without claims it is ``given``, or ``suspect`` if its change makes
    claims false. ``causes`` are the places to blame for a claim that is not true.
    """

    id: str
    label: str
    line: int
    column: int
    tex: str
    role: str
    verdict: str
    claims: tuple[str, ...] = ()
    conditions: tuple[Condition, ...] = ()
    counterexample: Counterexample | None = None
    correction: Correction | None = None
    causes: tuple[str, ...] = ()
    breaks: tuple[str, ...] = ()
    """The claims that are not true because of this formula."""
    moved: bool = False
    message: str = ""
    place: Printed | None = field(default=None, repr=False)

    @property
    def wrong(self) -> bool:
        """Whether the author has to look at it."""
        return self.verdict in WRONG


@dataclass(slots=True)
class Audit:
    """All formulas of a source that a derivation knows, in the order of the derivation."""

    source: Source
    expanded: Expanded
    places: list[Place]
    formulas: list[Audited]
    outcomes: dict[str, Outcome]
    session: AuditSession
    notes: list[tuple[int, str]]
    """Lines, and what is to be said about them."""
    seconds: float = 0.0

    @property
    def counts(self) -> dict[str, int]:
        """How many formulas there are of each verdict."""
        return dict(sorted(Counter(formula.verdict for formula in self.formulas).items()))

    @property
    def statements(self) -> list[Outcome]:
        """What is said about statements in words, which no formula prints."""
        about = {claim for formula in self.formulas for claim in formula.claims}
        return [outcome for claim, outcome in self.outcomes.items() if claim not in about]


def typed_formulas(source: Source) -> tuple[Expanded, list[Typed]]:
    """A source with its macros written out, and the formulas in it."""
    expanded = expand(source)
    return expanded, list(find_formulas(expanded.text, source.body))


def audit(source: Source, memory: Memory) -> Audit:
    """Decide every claim of a derivation on the formulas of a source."""
    start = perf_counter()
    expanded, typed = typed_formulas(source)
    places = find_places(memory.derivation, typed)
    sources = {
        place.display: place.typed.tex
        for place in places
        if place.typed is not None and words(place.typed.tex) != words(place.display.tex)
    }
    refused = {display: reason for display, tex in sources.items() if (reason := _excess(display, tex, memory))}
    for display in refused:
        del sources[display]
    session = AuditSession(memory, memory.base, sources)
    given = session.texts
    outcomes = {outcome.claim: outcome for outcome in session.run().outcomes}
    notes = [(source.line(offset), words) for offset, words in expanded.notes]
    result = Audit(source, expanded, places, [], outcomes, session, notes)
    roles = Roles(memory.derivation)
    describe = _Describer(result, roles, given, refused)
    for place in places:
        result.formulas += describe.formulas(place)
    result.formulas += describe.new(typed)
    result.seconds = perf_counter() - start
    return result


class _Describer:
    """Says what a run found about each place."""

    def __init__(
        self, audit: Audit, roles: Roles, texts: Texts, refused: dict[Display, str]
    ) -> None:
        self.audit = audit
        self.roles = roles
        self.texts = texts
        self.refused = refused
        self.broken: dict[str, list[str]] = {}
        for claim, causes in audit.session.causes.items():
            for printed in causes:
                self.broken.setdefault(printed.place, []).append(claim)

    def formulas(self, place: Place) -> Iterator[Audited]:
        """The statements of one display."""
        display, typed = place.display, place.typed
        if typed is None:
            yield Audited(
                display.id, _label(display), 0, 0, display.tex.strip(), self._role(display), MISSING,
                claims=tuple(self._claims(display)),
                message="the derivation has this formula and the source has not",
            )  # fmt: skip
            return
        try:
            if display in self.refused:
                raise NotationError(self.refused[display], typed.tex, 0)
            intervals = split_display(typed.tex)
            expected = len(split_display(display.tex))
            self.texts.statement(display[1])
        except NotationError as error:
            message = typed.trouble or str(error)
            yield self._audited(display.id, typed, (0, len(typed.tex)), display, UNREADABLE, message)
            return
        for number, interval in enumerate(intervals, 1):
            printed = display[number]
            id = printed.place if len(intervals) > 1 or expected > 1 else display.id
            audited = self._audited(id, typed, interval, display, GIVEN, typed.trouble)
            audited.moved = place.moved
            self._judge(audited, printed)
            yield audited
        for number in range(len(intervals) + 1, expected + 1):
            audited = self._audited(
                display[number].place, typed, (0, len(typed.tex)), display, MISSING,
                f"{expected} statements are expected here, {len(intervals)} are found",
            )  # fmt: skip
            yield audited

    def new(self, typed: Sequence[Typed]) -> Iterator[Audited]:
        """Displays of the source for which the derivation has no place."""
        known = {id(place.typed) for place in self.audit.places}
        for formula in typed:
            if not formula.inline and id(formula) not in known:
                label = formula.labels[0] if formula.labels else ""
                name = label or f"line {self._position(formula, 0, len(formula.tex))[0]}"
                found = self._audited(
                    name, formula, (0, len(formula.tex)), None, NEW, "the derivation has no place for it"
                )  # fmt: skip
                found.label = label
                yield found

    def _audited(
        self,
        id: str,
        typed: Typed,
        interval: tuple[int, int],
        display: Display | None,
        verdict: str,
        message: str,
    ) -> Audited:
        line, column = self._position(typed, *interval)
        start, end = self.audit.expanded.origin(*(typed.start + offset for offset in interval))
        tex = self.audit.source.text[start:end].strip()
        role = self._role(display) if display else "none"
        label = typed.labels[0] if typed.labels else ""
        return Audited(id, label, line, column, tex, role, verdict, message=message)

    def _position(self, typed: Typed, start: int, end: int) -> tuple[int, int]:
        while start < end and typed.tex[start].isspace():
            start += 1
        at = self.audit.expanded.origin(typed.start + start, typed.start + start + 1)[0]
        return self.audit.source.line(at), self.audit.source.column(at)

    def _role(self, display: Display) -> str:
        return self.roles.at(display[1].place).name

    def _claims(self, display: Display) -> Iterator[str]:
        for place, role in self.roles.places.items():
            if place.rpartition(".")[0] == display.id:
                yield from role.claims

    def _judge(self, audited: Audited, printed: Printed) -> None:
        """The verdict on a statement, with its evidence."""
        role = self.roles.at(printed.place)
        audited.place = printed
        audited.role = role.name
        audited.claims = tuple(role.claims)
        outcomes = [self.audit.outcomes[claim] for claim in role.claims]
        if outcomes:
            worst = min(outcomes, key=lambda outcome: _WORST.index(outcome.verdict))
            audited.verdict = str(worst.verdict)
            audited.conditions = worst.conditions
            audited.counterexample = worst.counterexample
            audited.correction = worst.correction
            audited.message = worst.message or audited.message
            causes = self.audit.session.causes.get(worst.claim, ())
            audited.causes = tuple(cause.place for cause in causes)
        self._blame(audited, printed, role)

    def _blame(self, audited: Audited, printed: Printed, role: Role) -> None:
        """What a changed statement makes false, and what it no longer defines."""
        audited.breaks = tuple(self.broken.get(printed.place, ()))
        if printed not in self.audit.session.changed:
            return
        lost = undefined(role, self.texts.formula(printed))
        if lost:
            audited.message = f"it does not define {', '.join(lost)}"
        if lost or audited.breaks:
            if audited.verdict not in WRONG:
                audited.verdict = SUSPECT


def _excess(display: Display, tex: str, memory: Memory) -> str:
    """Why a display is not evaluated; empty if it is."""
    read = formulas(memory.base.own.with_source(display, tex), display)
    return next((reason for formula in read if (reason := excess(formula))), "")


def _label(display: Display) -> str:
    return "" if display.inline else display.id


