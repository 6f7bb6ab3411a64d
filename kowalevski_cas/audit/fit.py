"""Which derivation a source is a version of."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.audit.audit import typed_formulas
from kowalevski_cas.audit.places import find_places
from kowalevski_cas.audit.source import Source
from kowalevski_cas.audit.tokens import likeness
from kowalevski_cas.paper.derivation import Derivation

FITS = 0.2
"""The share of a derivation's displays that must be found in a source."""


def fit(source: Source, derivation: Derivation) -> float:
    """How much of a derivation stands in a source, from 0 to 1."""
    places = find_places(derivation, typed_formulas(source)[1])
    alike = (likeness(p.typed.tex, p.display.tex) for p in places if p.typed is not None)
    return sum(alike) / max(1, len(places))


def best(source: Source, derivations: Sequence[Derivation]) -> Derivation | None:
    """The derivation that fits a source best, if one does."""
    rated = [(fit(source, derivation), derivation) for derivation in derivations]
    value, derivation = max(rated, key=lambda pair: pair[0], default=(0.0, None))
    return derivation if value >= FITS else None
