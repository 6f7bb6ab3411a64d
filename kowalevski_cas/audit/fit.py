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


def best(source: Source, derivations: Sequence[Derivation]) -> Derivation | None:
    """The derivation that fits a source best, if one does."""
    _, formulas = typed_formulas(source)

    def share(derivation: Derivation) -> float:
        places = find_places(derivation, formulas)
        alike = (likeness(p.typed.tex, p.display.tex) for p in places if p.typed is not None)
        return sum(alike) / max(1, len(places))

    found = max(derivations, key=share, default=None)
    return found if found is not None and share(found) >= FITS else None
