"""The formulas of a source with its macros written out, each with what makes it unclear."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import islice

from kowalevski_cas.source.between_words import between_words
from kowalevski_cas.source.comments import comments_on, find_comments
from kowalevski_cas.source.displays import TypedFormula, find_formulas
from kowalevski_cas.source.expanded import Expanded
from kowalevski_cas.source.macros import expand
from kowalevski_cas.source.text import Source, SourceError

MOST = 20_000
"""Formulas in one source."""

_BIBLIOGRAPHY = re.compile(
    r"\\begin\{thebibliography\}.*?(?:\\end\{thebibliography\}|\Z)", re.DOTALL
)


def typed_formulas(source: Source) -> tuple[Expanded, list[TypedFormula]]:
    """A source with its macros written out, and the formulas in it with the comments on them."""
    expanded = expand(source)
    formulas = find_formulas(expanded.text, expanded.body)
    found = list(islice(_of_the_paper(formulas, source, expanded), MOST + 1))
    if len(found) > MOST:
        raise SourceError(f"{source.path} has more than {MOST:,} formulas")
    found = [piece for formula in found for piece in between_words(formula)]
    intervals = [_interval(expanded, formula) for formula in found]
    said = comments_on(source, find_comments(source), intervals)
    for number, formula in enumerate(found):
        why = expanded.why(formula.start, formula.end)
        comments = tuple(said.get(number, ()))
        found[number] = replace(formula, trouble=formula.trouble or why, comments=comments)
    return expanded, found


def _of_the_paper(
    formulas: Iterable[TypedFormula], source: Source, expanded: Expanded
) -> Iterator[TypedFormula]:
    """The formulas that are the paper's own: not those of its styles, nor of what it cites."""
    cited = [match.span() for match in _BIBLIOGRAPHY.finditer(expanded.text)]
    for formula in formulas:
        place = expanded.origin(formula.start, formula.start + 1)[0]
        if not source.part(place).style and not any(a < formula.start < b for a, b in cited):
            yield formula


def _interval(expanded: Expanded, formula: TypedFormula) -> tuple[int, int]:
    """The interval in the file of a formula, from what it prints first."""
    start = formula.start + len(formula.tex) - len(formula.tex.lstrip())
    return expanded.origin(start, max(start + 1, formula.end))
