"""An audit: the formulas of a source, each with its role and what the run says about it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from time import perf_counter

from kowalevski_cas.audit.audited import SUSPECT, Audited
from kowalevski_cas.audit.author import AuthorSession, formulas
from kowalevski_cas.audit.causes import AuditBase
from kowalevski_cas.audit.describe import Describer
from kowalevski_cas.audit.limits import excess
from kowalevski_cas.audit.places import Correspondence, find_places
from kowalevski_cas.audit.quotations import Quotations
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.reading import Reading
from kowalevski_cas.reading.text import Prose
from kowalevski_cas.reading.uncovered import Uncovered, sentences
from kowalevski_cas.reading.uncovered import formulas as uncovered_formulas
from kowalevski_cas.source.expanded import Expanded
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.text import Region, Source
from kowalevski_cas.source.tokens import likeness, words
from kowalevski_cas.verify.outcome import Outcome, Run, Verdict, in_latex

FITS = 0.2
"""The share of a derivation's displays that must be found in a source."""

ABSENT = "the derivation has this formula and the source has not"


@dataclass
class Audit:
    """All formulas of a source that a derivation knows, in the order of the derivation."""

    source: Source
    expanded: Expanded
    places: list[Correspondence]
    formulas: list[Audited]
    session: AuthorSession
    notes: list[tuple[int, str]]
    """Lines, and what is to be said about them."""
    sentences: dict[str, Region]
    """Where the sentences stand that claims quote, by the ids of the claims."""
    seconds: float = 0.0
    reading: Reading | None = None
    """The reading, if the source is its own derivation."""
    uncovered: list[Uncovered] = field(default_factory=list)
    """What the text claims and no verdict covers."""

    @property
    def outcomes(self) -> dict[str, Outcome]:
        """What is said about each claim."""
        return self.session.outcomes

    @property
    def run(self) -> Run:
        """What is said about each claim, as a run of the derivation."""
        derivation = self.session.interpretation.derivation
        return Run(
            derivation=derivation.name,
            title=derivation.title,
            author=derivation.author,
            source=derivation.source,
            sections=tuple((section.number, section.title) for section in derivation.sections),
            outcomes=tuple(self.outcomes.values()),
            arithmetics=self.session.decider.arithmetics.names,
            versions={},
            vocabulary=self.session.interpretation.texts.vocabulary,
            edition=derivation.edition,
            main=derivation.main,
            expected=derivation.expected,
        )

    @property
    def certificates(self) -> list[str]:
        """The texts that the checker has accepted."""
        return [
            text for outcome in self.outcomes.values() for text in outcome.certificates.values()
        ]

    @property
    def counts(self) -> dict[str, int]:
        """How many formulas there are of each verdict."""
        return dict(sorted(Counter(formula.verdict for formula in self.formulas).items()))

    @property
    def statements(self) -> list[Outcome]:
        """What is said about claims that are more than a formula, which has not their verdict."""
        shown = {formula.id for formula in self.formulas if formula.id in formula.claims}
        return [outcome for claim, outcome in self.outcomes.items() if claim not in shown]

    @property
    def false(self) -> list[Outcome]:
        """Statements in words that are refuted, where no formula is wrong by them."""
        seen = {claim for formula in self.formulas if formula.wrong for claim in formula.claims}
        refuted = (
            statement for statement in self.statements if statement.verdict is Verdict.REFUTED
        )
        return [outcome for outcome in refuted if outcome.claim not in seen]

    def explanation(self, formula: Audited) -> str:
        """What is wrong with a formula, in one sentence, with mathematics between dollars."""
        parts = self.said(formula)
        if formula.correction is not None:
            parts.append(f"correct: ${in_latex(formula.correction.formulas)}$")
        return "; ".join(parts)

    def said(self, formula: Audited) -> list[str]:
        """The same in parts, without the correction."""
        parts = formula.message.splitlines()[:1]
        if formula.breaks and not formula.claims:
            parts.append(
                f"because of it these do not hold: {', '.join(self._claimed(formula.breaks))}"
            )
        if causes := [self.location(cause) for cause in formula.causes if cause != formula.name]:
            parts.append(f"because of {', '.join(causes)}")
        changed = formula.place in self.session.changed
        if formula.verdict == SUSPECT and formula.correction is None and changed:
            parts.append("it is not what the derivation has here")
        return parts

    def called(self, formula: Audited) -> str:
        """A formula by its id; of a source that is its own derivation, by its label or its line."""
        if self.reading is None:
            return formula.id
        return f"({formula.label})" if formula.label else f"line {formula.line}"

    def location(self, place: str) -> str:
        """A place with its line in the source."""
        found = next((formula for formula in self.formulas if formula.name == place), None)
        if found is None:
            return place
        called = self.called(found)
        return called if called.startswith("line ") else f"{called} (line {found.line})"

    def _claimed(self, claims: Sequence[str]) -> Iterable[str]:
        """What the formulas are called that are claimed, each once."""
        found = {claim: formula for formula in self.formulas for claim in formula.claims}
        return dict.fromkeys(self.called(found[id]) if id in found else id for id in claims)

    @property
    def wrong(self) -> int:
        """How many formulas, and statements in words, an author has to look at."""
        return sum(formula.wrong for formula in self.formulas) + len(self.false)


def derivation_of(source: Source, derivations: Sequence[Derivation]) -> Derivation | None:
    """The derivation of which a source is a version, if there is one."""
    _, formulas = typed_formulas(source)

    def share(derivation: Derivation) -> float:
        places = find_places(derivation, formulas)
        alike = (likeness(p.typed.tex, p.display.tex) for p in places if p.typed is not None)
        return sum(alike) / max(1, len(places))

    found = max(derivations, key=share, default=None)
    return found if found is not None and share(found) >= FITS else None


def audit(source: Source, base: AuditBase) -> Audit:
    """Decide every claim on the formulas of a source; ``base`` is the run of the derivation."""
    start = perf_counter()
    derivation = base.decider.interpretation.derivation
    expanded, typed = typed_formulas(source)
    places = find_places(derivation, typed)
    sources: dict[Display, str] = {}
    refused: dict[Display, str] = {}
    for place in places:
        if place.typed is None:
            refused[place.display] = ABSENT
        elif place.typed.trouble:
            refused[place.display] = place.typed.trouble
        elif words(place.typed.tex) != words(place.display.tex):
            reason = _excess(place.display, place.typed.tex, base)
            (refused if reason else sources)[place.display] = reason or place.typed.tex
    quotations = Quotations(source, expanded, typed, places, derivation)
    session = AuthorSession(base, sources, refused, quotations.differing())
    notes = [(source.line(offset), reason) for offset, reason in (*source.refused, *expanded.notes)]
    describe = Describer(source, expanded, session, refused)
    found = [formula for place in places for formula in describe.formulas(place)]
    found += describe.new(typed, places)
    prose = Prose(expanded.text, expanded.body, typed)
    stated = sentences(prose, source, expanded, [*quotations.intervals().values()])
    known = [place.typed for place in places if place.typed is not None]
    uncovered = [passage for *_, passage in stated]
    uncovered += uncovered_formulas(typed, known, source, expanded)
    return Audit(
        source, expanded, places, found, session, notes, quotations.regions(),
        perf_counter() - start, uncovered=sorted(uncovered),
    )  # fmt: skip


def _excess(display: Display, tex: str, base: AuditBase) -> str:
    """Why a display is not evaluated; empty if it is."""
    read = formulas(base.decider.interpretation.texts.with_source(display, tex), display)
    return next((reason for formula in read if (reason := excess(formula))), "")
