"""The formulas of a source with its macros written out, each with what makes it unclear."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

from kowalevski_cas.source.displays import Typed, find_formulas
from kowalevski_cas.source.macros import Expanded, expand
from kowalevski_cas.source.text import Source, SourceError

MOST = 20_000
"""Formulas in one source."""


def typed_formulas(source: Source) -> tuple[Expanded, list[Typed]]:
    """A source with its macros written out, and the formulas in it."""
    expanded = expand(source)
    found = list(islice(find_formulas(expanded.text, source.body), MOST + 1))
    if len(found) > MOST:
        raise SourceError(f"{source.path} has more than {MOST:,} formulas")
    for place, formula in enumerate(found):
        origin = expanded.origin(formula.start, formula.start + 1)[0]
        if why := expanded.definitions.why(formula.tex, formula.kind, origin):
            found[place] = replace(formula, trouble=formula.trouble or why)
    return expanded, found
