"""Of which of several systems words speak: of the first one, of the latter, or of both."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import zip_longest

from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.numerals import ORDINALS
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.text import Prose, references

_NOUN = (
    r"(?:systems?|problems?|models?|flows?|(?:vector\s+)?fields?|ones?"
    r"|of\s+(?:them|these|those|the\s+two)|(?:систем|задач|модел|пол)\w*|из\s+них)"
)
_ALSO = (("former", "original", "initial", "исходн"), ("latter",))
"""What else words call the first, and the second."""
_ORDINALS = [words + also for words, also in zip_longest(ORDINALS, _ALSO, fillvalue=())]
_WORD = "|".join(word for words in _ORDINALS for word in words)
_WHICH = re.compile(
    rf"\b(?:of|for|in|by|to|has|have|under|along|on|для|в|у|вдоль)\s+(?:the\s+)?(?P<which>{_WORD})\w*(?P<noun>\s+(?:of\s+(?:the|these|our)\s+)?{_NOUN}\b)?"
    rf"|\b(?P<named>{_WORD})\w*\s+{_NOUN}\b",
    re.IGNORECASE,
)
_ALL = re.compile(
    rf"\b(?:both|either|each|all|every|neither)\s+(?:(?:of\s+)?(?:the|these|our|them)\s*)?(?:(?:two|three|four)\s+)?(?:{_NOUN}\b|[,.;:]|$|have|has|we)"
    rf"|\b(?:the|these)\s+(?:two|three|four)\s+{_NOUN}\b"
    r"|\b(?:об(?:е|их|еих)|кажд\w+\s+из|все\w*)\s+(?:\w+\s+)?(?:систем|задач|модел|этих|них)\w*",
    re.IGNORECASE,
)


_FOLLOWING = re.compile(r"\bfollow|\bholds?\b|\btrue\b|\bверно\b|\bследующ", re.IGNORECASE)
"""Words that announce what is said in the next sentence."""

_CASE = re.compile(
    rf"\b(?:in|for)\s+(?:the\s+)?(?:{_WORD})\w*\s+cases?\b|\b(?:в|для)\s+(?:{_WORD})\w*\s+случа\w+",
    re.IGNORECASE,
)
"""Words for a case, which may be that of one of the systems."""


def part_in_words(item: SourceStatement, own: Sequence[Sequence[Law]], prose: Prose) -> int | None:
    """The part of the system that words beside a statement name by its number."""
    if len(own) < 2 or any(item in law.printed for laws in own for law in laws):
        return None
    number = _number(item)
    if number is None:
        return None
    called = [k for k, laws in enumerate(own) if laws and number in _numbers(_setting(laws, prose))]
    if len(called) == 1:
        return called[0]
    return number if not called and number < len(own) == 2 else None


_OTHER_CLAUSE = re.compile(
    r"[,;:.]|\b(?:whereas|while|but|а|но)\b|\b(?:and|и)\s+(?:for|in|by|under|on|для|в|по)\b",
    re.IGNORECASE,
)


def nearest_labels(item: SourceStatement) -> tuple[str, ...]:
    """The labels that words cite right behind a statement, or before it, or in its sentence."""
    behind, before = _OTHER_CLAUSE.split(item.tail, maxsplit=1)[0], item.lead
    return references(behind) or references(before) or item.refs


def of_several(item: SourceStatement, known: Known) -> str:
    """The words by which a claim is one of several systems, of which one only is looked at."""
    moving = {name for law in known.laws for name in law.variables}
    if not moving & known.elsewhere:
        return ""
    if found := _ALL.search(item.words) or _CASE.search(item.words):
        return found[0].strip(" ,.;:")
    printed = {one for law in known.laws for one in law.printed}
    announced = references(item.earlier[0]) if _FOLLOWING.search(" ".join(item.earlier[:1])) else ()
    labels = nearest_labels(item) or announced
    cited = [one for label in labels for one in known.paper.labels.get(label, ())]
    of_others = any(moving & one.rates.keys() and one not in printed for one in cited)
    return " and ".join(labels) if of_others and printed & {*cited} else ""


def _number(item: SourceStatement) -> int | None:
    """The number of the system of which the words right behind a statement speak, or before it."""
    spoken = _has_noun(item.words)
    behind, before = _END.split(item.tail, maxsplit=1)[0], _BREAK.split(item.lead)[-1]
    for words in (behind, before, item.words):
        if found := _numbers(words, nouns=spoken):
            return found.pop() if len(found) == 1 else None
    return None


_END, _BREAK = re.compile(r"[,;:]"), re.compile(r"[;:]")
"""Where a clause ends behind a statement, and where it begins before it."""


def _has_noun(words: str) -> bool:
    return any(
        match["noun"] or match["named"] or _ENDS.match(words, match.end())
        for match in _WHICH.finditer(words)
    )


_ENDS = re.compile(r"[\s~]*(?:[,§]|$)")
"""What stands behind an ordinal that is a noun itself: “in the first, § is constant”."""


def _numbers(words: str, *, nouns: bool = False) -> set[int]:
    """The numbers of systems in words: without a noun in the sentence one is of something else."""
    found = [*_WHICH.finditer(words)]
    nouns = nouns or _has_noun(words)
    told = ((match["which"] or match["named"]).lower() for match in found)
    return {
        number
        for word in told
        for number, ordinals in enumerate(_ORDINALS)
        if word in ordinals and (nouns or word in ("former", "latter"))
    }


def _setting(laws: Sequence[Law], prose: Prose) -> str:
    """The sentence that sets a system up, up to its equations."""
    row = laws[0].first
    return prose.between(row.sentence[0], row.typed.start)
