"""Forces and constraints that words tell, and no Lagrangian: it alone is no law of motion then."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from kowalevski_cas.reading.cues import cue, force_told
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import is_printed

_ASIDE = re.compile("abstract|thebibliography|keywords")


def refuse_unsaid_forces(law: Law, item: SourceStatement, known: Known) -> None:
    """Judge nothing by the equations that a Hamiltonian or a Lagrangian implies if more acts.

    Words before the statement tell so, in a section around it or around what implies the law; a
    sentence that says there is no such force is none of them.

    Raises:
        ValueError: more acts, as these words say.
    """
    if any(map(is_printed, law.rows)):
        return
    timed = any("t" in known.below(name) for name in law.mentions)
    own = known.paper.prose.sentence(law.first.typed.start)
    orders = {name: order for row in law.rows for name, order in row.rates.items()}
    rolls = sum(orders.values()) > 2
    for start, words in _sentences_around(law, item, known):
        if timed and own[0] <= start < own[1]:
            continue  # what acts is in the function of which it speaks
        if told := (rolls and cue("rolling", words)) or force_told(words):
            line = known.paper.source.line(known.paper.expanded.origin(start, start + 1)[0])
            raise ValueError(
                f"“{told}” (line {line}) says that more acts than is implied here; print the "
                "equations of motion, or skip that sentence by a comment"
            )


def _sentences_around(law: Law, item: SourceStatement, known: Known) -> Iterator[tuple[int, str]]:
    """The sentences to that of a statement, with their places, in its sections or the law's."""
    prose = known.paper.prose
    around = {*item.sections, *law.first.sections}
    skipped = {*known.said.skipped(prose)}
    for start, end in pairwise(prose.stops):
        if start >= item.sentence[1]:
            return
        path = prose.path(start)
        aside = any(_ASIDE.fullmatch(section.title) for section in path)
        if not aside and path[-1] in around and (start, end) not in skipped:
            text = prose.text[start:end]
            yield end - len(text.lstrip()), prose.between(start, end)
