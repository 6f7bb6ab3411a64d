"""Names that words give to the value of a function, as “denote by E the value of H on a motion”."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from kowalevski_cas.notation import Name, to_latex
from kowalevski_cas.reading.known import CONVENTION, Known, StatementRole
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

_BY = re.compile(r"(?:\b(?:denote|write)s?\s+by|\bчерез)[\s~]*$", re.IGNORECASE)
_VALUE = re.compile(
    r"\s*(?:the\s|обозначим\s)?\s*(?:values?|значение)(?:\s+of)?[\s~]*$", re.IGNORECASE
)
_ENDS = re.compile(
    r"[\s~]*(?:(?:along|on)\s+(?:a|an|the|each|every)\s+(?:solution|motion|trajectory|orbit)"
    r"|(?:на|вдоль)\s+(?:решени|движени|траектори)\w+)?[\s~]*(?:[.;]|$)",
    re.IGNORECASE,
)
"""What stands behind a function of which the value is meant along any motion, and nowhere else."""


def named_values(paper: SourcePaper) -> Iterator[SourceStatement]:
    """What words say of names that they give to the value of a function, as equations."""
    for one, other in pairwise(paper.items):
        if not (isinstance(one.formula, Name) and isinstance(other.formula, Name)):
            continue
        beside = one.sentence == other.sentence and _BY.search(one.lead)
        if beside and _VALUE.fullmatch(other.lead) and _ENDS.match(other.tail):
            tex = f"{to_latex(one.formula)}={to_latex(other.formula)}"
            id = f"{other.printed.display.id}-in-words"
            yield unprinted(paper, id, tex, other, f"{other.printed.place} says it")


def values_in_words(known: Known) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """Those of a part for which nothing else says what they are."""
    places = {one.typed.start for one in known.items}
    for item in named_values(known.paper):
        name, of = item.bare
        said = known.is_defined(name) or known.moves(name) or not known.varies(of)
        if item.typed.start in places and not said:
            why = f"words call it the value of {plain(of)}"
            yield item, StatementRole(CONVENTION, why, "", (name,))
