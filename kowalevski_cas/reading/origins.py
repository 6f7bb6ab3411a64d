"""What sentences claim of the origin: that it is a point of rest."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.paper.claims import RestPoints
from kowalevski_cas.reading.in_words import InWords, is_unsure, sentences_of
from kowalevski_cas.reading.linear_parts import equations_of
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.rung import places

_OF_OTHERS = (
    r"(?!\s+(?:of|for|in)\s+(?!(?:the|this|our|these)\s+(?:system|equations|flow|field|law)\b(?!\s+§)"
    r"|\(?\\(?:eq)?ref\b))"
)
"""What no words begin with behind a point that is said to be that of another law."""
_IS_REST = re.compile(
    r"\b(?:the\s+)?origin\s+is\s+(?:(?:also|always|then|again|thus|clearly|obviously)\s+)*"
    r"(?:an?\s+(?:equilibrium|(?:rest|fixed|stationary|singular|critical)\s+point"
    r"|(?:state|point|position)\s+of\s+(?:rest|equilibrium)|steady\s+state)|at\s+rest)\b"
    rf"{_OF_OTHERS}"
    r"|\bначало\s+координат\s*(?:[-—–~]+|является|есть)\s*"
    r"(?:положение\w*\s+равновеси\w+|(?:особ|неподвижн)\w+\s+точк\w+)",
    re.IGNORECASE,
)


def claims_of_origins(parts: Parts) -> Iterator[InWords]:
    """That nothing moves at the origin, by the only law before these words."""
    for start, words in sentences_of(parts):
        found = _IS_REST.search(words)
        if found is None or is_unsure(words):
            continue
        at = start + found.start()
        known = parts.known[parts.part_at(at)]
        laws = [law for law in known.laws if law.first.typed.start < at]
        if len(laws) != 1 or laws[0].images or laws[0].base:
            continue
        rows, before = laws[0].rows, [one for one in known.items if one.typed.start < at]
        point = equations_of(dict.fromkeys(laws[0].variables, "0"), before[-1], laws[0], known)
        span = (at, start + found.end())
        values: dict[str, object] = {"relations": places(point), "printed": rows[0].printed}
        says = "nothing moves at the origin"
        yield InWords(span, RestPoints, (*rows, *point), values, "origin", says, before[-1])
