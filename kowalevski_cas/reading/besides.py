"""Where words state nothing by themselves: they lead up to what is read, or suppose something."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator, Sequence

from kowalevski_cas.notation import Relation, Vector
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import CLAIM, CONVENTION, DEFINITION, LAW, LEVEL, OTHER
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.phrases import joined_tail, words_behind
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.text import MARK
from kowalevski_cas.reading.uncovered import SAYS_NOTHING

_ENDS = re.compile(
    rf"[;()]|(?<!{MARK}),|,(?!\s*{MARK})|\b(?:and|but|so|because|although|though|while|whereas|since|hence|thus|therefore"
    r"|if|when|where|unless|whether|если|когда|где|и|а|но|так\s+как|поэтому|хотя)\b",
    re.IGNORECASE,
)
"""Where a part of a sentence ends that says something by itself."""

_SUPPOSES = re.compile(
    r"(?:\\\w+\s*(?:\{[^{}]*\}\s*)*|\W)*(?:(?:and|but|that|then|so|now|next|и|а)\b\W*)*(?:if|when(?:ever)?|where|here|let|suppose|assume|consider|denot\w*|put|set|show"
    r"|prove|find|parametri[sz]e|introduce|write|compute|determine|express|multiply|use|provided|unless|whether|as\s+long\s+as|in\s+the\s+(?:\w+\s+)?case|we|one|us|to"
    r"|если|когда|где|здесь|пусть|положим|рассмотрим|найти|доказать)\b",
    re.IGNORECASE,
)
"""How such a part begins if it supposes, explains, or asks for, something."""

_READ = (LAW, DEFINITION, LEVEL, CLAIM, CONVENTION)
"""The roles of what words lead up to."""


def leads(parts: Parts) -> Iterator[tuple[int, int]]:
    """The intervals of the text in which what words say is no statement of its own.

    So is what stands before the first equations, and before a formula that is read, in its part of
    the sentence, and what supposes something.
    """
    prose = parts.paper.prose
    roles = {item.typed.start: role.name for item, role in parts.roles.items()}
    places = sorted(start for start, name in roles.items() if name in _READ)
    yield prose.start, _beginning(parts)
    for start, end in zip(prose.stops, [*prose.stops[1:], len(prose.text)], strict=True):
        for begin, stop in _parts_of(prose.text[start:end]):
            if _SUPPOSES.match(prose.text, start + begin, start + stop):
                yield start + begin, start + stop
            elif (last := _last(places, start + begin, start + stop)) is not None:
                yield start + begin, last


_GIVES = re.compile(
    r"(?:(?<!that\s)\b(?:is|are|equals?|becomes?|reaches|amounts\s+to)"
    r"|\b(?:has|have)\s+(?:the|an?|its|as)(?:\s+\w+){1,3}|---?|[—–]|\bравн\w+)[\s~]*$",
    re.IGNORECASE,
)
"""How words end behind which stands what something is."""


_SAID_OF_IT = re.compile(
    rf"[\s~]*(?:is|are|remains?|stays?|takes?|has|have)\s+(?!{SAYS_NOTHING})"
    r"|[\s~]*(?:vanish|keep|never|satisf|obey|grow|decreas|increas|exceed|tend|chang|oscillat|commut|generat)\w*",
    re.IGNORECASE,
)
"""How words begin behind an expression that say something of it."""


def expressions(parts: Parts) -> Iterator[SourceStatement]:
    """The expressions in the text of which words say something, or that they give something.

    Nothing is judged of them, and they stand behind the first equations; or no more is judged than
    that an integral is one, as the words before it call it.
    """
    first = _beginning(parts)
    for item, role in parts.roles.items():
        if not item.typed.inline or item.typed.start <= first:
            continue
        if role.name == CLAIM and role.kind == "integral":
            called = not words_behind(item, "integral") and cue("integral", item.lead)
            if called and _SAID_OF_IT.match(item.tail):
                yield item
            continue
        if role.name != OTHER or role.kind or isinstance(item.formula, Relation):
            continue
        if isinstance(item.formula, Vector) and cue("equilibrium", item.words):
            yield item
            continue
        *_, (begin, end) = _parts_of(item.before)
        if not _SUPPOSES.match(item.before, begin, end):
            if _GIVES.search(item.lead) or _SAID_OF_IT.match(joined_tail(item)):
                yield item


def _beginning(parts: Parts) -> int:
    """Where the first equations of motion stand, or what else is given first."""
    for names in ((LAW,), _READ):
        if places := [one.typed.start for one, role in parts.roles.items() if role.name in names]:
            return min(places)
    return len(parts.paper.prose.text)


def _parts_of(words: str) -> Iterator[tuple[int, int]]:
    """The intervals of the parts of a sentence, each with what joins it to the one before."""
    begin = 0
    for found in _ENDS.finditer(words):
        yield begin, found.start()
        begin = found.start()
    yield begin, len(words)


def _last(places: Sequence[int], start: int, end: int) -> int | None:
    """The last of some places, in their order, that is in an interval."""
    before = bisect_left(places, end)
    return places[before - 1] if before and places[before - 1] >= start else None


__all__ = ["expressions", "leads"]
