"""An audit: the formulas of a source, each with its role and what the run says about it."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from itertools import islice
from time import perf_counter

from kowalevski_cas.audit.audited import Audited
from kowalevski_cas.audit.describe import Describer
from kowalevski_cas.audit.displays import Typed, find_formulas
from kowalevski_cas.audit.limits import excess
from kowalevski_cas.audit.macros import Expanded, expand
from kowalevski_cas.audit.places import Place, find_places
from kowalevski_cas.audit.session import AuditSession, AuthorSession, formulas
from kowalevski_cas.audit.source import Source, SourceError
from kowalevski_cas.audit.tokens import words
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.verify.outcome import Outcome

MOST = 20_000
"""Formulas in one source."""


@dataclass
class Audit:
    """All formulas of a source that a derivation knows, in the order of the derivation."""

    source: Source
    expanded: Expanded
    places: list[Place]
    formulas: list[Audited]
    session: AuthorSession
    notes: list[tuple[int, str]]
    """Lines, and what is to be said about them."""
    seconds: float = 0.0

    @property
    def outcomes(self) -> dict[str, Outcome]:
        """What is said about each claim."""
        return self.session.outcomes

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
    found = list(islice(find_formulas(expanded.text, source.body), MOST + 1))
    if len(found) > MOST:
        raise SourceError(f"{source.path} has more than {MOST:,} formulas")
    return expanded, found


def audit(source: Source, base: AuditSession) -> Audit:
    """Decide every claim on the formulas of a source; ``base`` is the run of the derivation."""
    start = perf_counter()
    expanded, typed = typed_formulas(source)
    places = find_places(base.derivation, typed)
    sources: dict[Display, str] = {}
    refused: dict[Display, str] = {}
    for place in places:
        if place.typed is not None and words(place.typed.tex) != words(place.display.tex):
            reason = _excess(place.display, place.typed.tex, base)
            (refused if reason else sources)[place.display] = reason or place.typed.tex
    session = AuthorSession(base, sources)
    notes = [(source.line(offset), reason) for offset, reason in expanded.notes]
    describe = Describer(source, expanded, session, refused)
    found = [formula for place in places for formula in describe.formulas(place)]
    found += describe.new(typed, places)
    return Audit(source, expanded, places, found, session, notes, perf_counter() - start)


def _excess(display: Display, tex: str, base: AuditSession) -> str:
    """Why a display is not evaluated; empty if it is."""
    read = formulas(base.texts.with_source(display, tex), display)
    return next((reason for formula in read if (reason := excess(formula))), "")
