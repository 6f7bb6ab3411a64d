"""What is said for another number of what a letter counts than the paper is read for."""

from __future__ import annotations

import re

from kowalevski_cas.notation import Number
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.lifted import goes_on, is_lifted, may_lift
from kowalevski_cas.reading.phrases import reach_of_constants
from kowalevski_cas.reading.statements import SourceStatement

_ANY = re.compile(
    r"\b(?:for|of|with|при|для)\s+(?:all|any|every|(?:an\s+)?arbitrary|general|любо\w*|всех|произвольн\w*)\b"
    r"|\b(?:in\s+general|generally|in\s+the\s+general\s+case|в\s+общем\s+случае)\b",
    re.IGNORECASE,
)
"""Words for what is said of any number."""


def other_number(item: SourceStatement, known: Known) -> str:
    """For which number a statement is said, if this is another one than the paper is read for.

    It is that of its sentence, of its paragraph, or what is supposed in its section, up to words
    that speak of any number.
    """
    said = ""
    for one in known.special_numbers:
        if _reaches(one, item, known):
            name, number = one.bare[0], known.paper.numbers[one.bare[0]]
            other = Number(number) not in one.members
            shown = one.typed.tex.strip(" .,")
            said = f"said for {shown}, not for {name}={number}" if other else ""
    return said


def _reaches(one: SourceStatement, item: SourceStatement, known: Known) -> bool:
    """Whether a statement is about the number that another one gives to what a letter counts."""
    if one.sentence == item.sentence or one.order > item.order:
        return one.sentence == item.sentence
    prose = known.paper.prose
    if _ANY.search(prose.between(one.sentence[1], item.typed.start)):
        return False
    lasts = not reach_of_constants(one) and known.is_within(one, item)
    lasts = lasts and goes_on(one, item, False, prose)
    lifting = filter(may_lift, known.items)
    beside = one.paragraph == item.paragraph and one.section in item.sections
    return beside or (lasts and not is_lifted(one, item, lifting, known.assumptions, prose))
