"""What sentences claim of functions and sets that are printed elsewhere, and cited or named there.

A claim in words names what it is about right before its verb, or right behind what it says;
what stands further off is no part of it. Under a condition in its sentence it is not judged.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence, Set
from typing import NamedTuple

from kowalevski_cas.notation import Name
from kowalevski_cas.paper.claims import (
    Casimir,
    Claim,
    Equilibria,
    EverywhereIndependent,
    Independence,
    InvariantRelations,
    Involution,
)
from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.paper.names import BRACKET
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import CLAIM, SETS, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.numerals import CARDINALS
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.rest_points import FAMILY
from kowalevski_cas.reading.statements import SourceStatement

_REFERENCE = r"\(?\\(?:eq)?ref\s*\{[^{}]*\}\)?"
_LIST = (
    rf"(?:§|{_REFERENCE}|[\s,;~]|\b(?:and|as\s+well\s+as|и|the|two|three|four|all|both|these|first"
    r"|integrals?|functions?|expressions?|quantities|equations?|relations?"
    r"|функции|интегралы|соотношения|уравнения)\b)*"
)
_VERB = r"(?:are|is|be|суть|являются|находятся|define|defines|-{2,3}|—)\s+(?:\w+\s+){0,2}?"
_SAID = {
    "independence": r"independent|независимы\w*",
    "involution": r"in\s+involution|commut\w+|в\s+инволюции",
    "casimir": r"casimir\w*|функции\s+Казимира",
    "invariant": r"invariant|инвариантн\w+",
}
_BEFORE = {
    name: (
        re.compile(
            said, re.IGNORECASE
        ),  # by itself first: few sentences say it, and lists are slow
        re.compile(rf"(?P<list>{_LIST}){_VERB}(?:{said})", re.IGNORECASE),
    )
    for name, said in _SAID.items()
}
_CASIMIRS = re.compile(
    r"(?<!\bno\s)(?:casimir\w*(?:\s+(?:functions?|invariants?|elements?))?|функци\w+\s+Казимира)"
    rf"(?:\s+of\s+(?:the|this)\s+\w+)?[\s~]*(?:is|are|есть|суть|[-—–]+)?[\s:~]*(?P<list>§{_LIST})",
    re.IGNORECASE,
)
"""Casimir functions that stand behind their name."""
_EVERYWHERE = re.compile(
    r"every(?:where)?\b|\b(?:each|any|all)\s+points?\b|\bnowhere\b|всюду|(?:кажд|люб)\w+\s+точк",
    re.IGNORECASE,
)
_SAVE = re.compile(
    r"\b(?:other\s+than|except|outside|besides|but|save|else|кроме)\b", re.IGNORECASE
)
_ORIGIN = re.compile(r"\b(?:origin|начал\w+\s+координат)", re.IGNORECASE)
_CONDITION = re.compile(
    r"\b(?:if|when|whenever|provided|unless|suppos\w+|assum\w+|let|если|когда|пусть|предполо\w+)\b",
    re.IGNORECASE,
)
_WHERE = re.compile(r"\b(?:domain|region|octant|half|set|surface|level|manifold)\b", re.IGNORECASE)
_SOMEWHERE = re.compile(
    r"\b(?:independent|независимы\w*)\b[\s,]*(?:(?:also|even|only|already|just|still|тоже|лишь|только)[\s,]+)*"
    r"(?:at|on|in|for|where|wherever|along|near|inside|over|with|even|also|в|на|при|для|там|вне|вблизи)\b"
    r"(?!\s+(?:(?:each|every|any|all|general|the\s+(?:sense|whole\s+(?:of\s+the\s+)?phase\s+space))\b|кажд|люб|вс[её]|общем))",
    re.IGNORECASE,
)
"""Words for a place where functions are independent, or are not."""
_NUMBER = re.compile(rf"\b(?:{'|'.join(CARDINALS)})\b", re.IGNORECASE)
_PART_OF = re.compile(r"(?:\b(?:of|with|between|and|or)|[§,])\s*$", re.IGNORECASE)
"""How words end behind which a list is not all that is spoken of."""
_GOES_ON = re.compile(r"\s*(?:,|and\b|и\b|as\s+well\b)", re.IGNORECASE)
_COUNT = re.compile(
    rf"\b(?:exactly|only|has|have|are)\s+(?P<number>{'|'.join(CARDINALS)})\s+(?:(?!{FAMILY})\w+\s+){{0,2}}?"
    r"(?:equilibri|states?\s+of\s+rest|fixed\s+points|(?:singular|stationary)\s+points)",
    re.IGNORECASE,
)


class InWords(NamedTuple):
    """A claim in words: where it stands in the text, of which kind, and what it is about."""

    span: tuple[int, int]
    kind: type[Claim]
    about: tuple[SourceStatement, ...]
    values: dict[str, object]
    """The attributes of the claim."""
    name: str
    """How the words are called in which it is made."""
    says: str
    at: SourceStatement | None = None
    """The statement beside the words, if they are about what is printed further off."""
    law: Law | None = None
    """The law by which it is claimed, if that is not the one of its names."""
    doubt: Doubt = Doubt.UNLESS_MENDED
    """How it may have been meant otherwise."""


def claims_in_words(parts: Parts) -> Iterator[InWords]:
    """The claims that the sentences of a paper make of what is cited or named there."""
    for start, words in sentences_of(parts):
        if not is_unsure(words):
            yield from _of_sentence(start, words, parts)


def sentences_of(parts: Parts) -> Iterator[tuple[int, str]]:
    """The sentences that may claim something, with where they begin."""
    prose = parts.paper.prose
    skipped = parts.said.skipped(prose)
    for start, end in zip(prose.stops, [*prose.stops[1:], len(prose.text)], strict=True):
        words = prose.text[start:end]
        aside = any(part.title == "thebibliography" for part in prose.path(start))
        if not (aside or (start, end) in skipped or words.rstrip().endswith("?")):
            yield start, words


def is_unsure(words: str) -> bool:
    """Whether a sentence denies, quotes, approximates or supposes something."""
    unsure = any(cue(name, words) for name in ("denied", "quoted", "approximate"))
    return unsure or _CONDITION.search(words) is not None


def _of_sentence(start: int, words: str, parts: Parts) -> Iterator[InWords]:
    for name, (said, pattern) in _BEFORE.items():
        found = pattern.search(words) if said.search(words) else None
        if found and not (
            _PART_OF.search(words, 0, found.start("list")) or _GOES_ON.match(found["list"])
        ):
            first = start + found.start("list") + len(found["list"]) - len(found["list"].lstrip())
            span = (first, start + len(words.rstrip()))
            inside = (start + found.start("list"), start + found.end("list"))
            yield from _made(name, span, inside, parts)
    if found := _CASIMIRS.search(words):
        inside = (start + found.start("list"), start + found.end("list"))
        yield from _made("casimir", (start + found.start(), inside[1]), inside, parts)
    if found := _COUNT.search(words):
        if claimed := _counted(found, start, parts):
            yield claimed


def _made(
    name: str, span: tuple[int, int], inside: tuple[int, int], parts: Parts
) -> Iterator[InWords]:
    """The claims of a sentence about what a part of it lists."""
    text = parts.paper.prose.text
    items = [one for one in parts.paper.items if inside[0] <= one.typed.start < inside[1]]
    cited = [
        one
        for found in re.finditer(r"ref\s*\{([^{}]*)\}", text[slice(*inside)])
        for label in found[1].split(",")
        for one in parts.paper.labels.get(label.strip(), ())
    ]
    every = [*items, *cited]
    if not every:
        return
    known = parts.of(every[-1])
    if name == "invariant":
        yield from filter(None, [_invariant(span, cited, known)])
        return
    given = [o for head, own in known.definitions.items() if head.startswith(BRACKET) for o in own]
    brackets = (*(one for one in given if one.typed.start < inside[1]),) or (*given,)
    if name in ("casimir", "involution") and _are_anew(span, brackets, parts):
        return
    moved = {name for one in brackets for name in one.members[0].names()}
    listed = [*functions_of(every, known, moved)]
    functions = tuple(dict.fromkeys(listed))
    places = tuple(one.printed for one in functions)
    if len(listed) < len(every) or len(functions) < (1 if name == "casimir" else 2):
        return  # of fewer functions less would be claimed
    if (told := _NUMBER.search(text, *inside)) and told[0].lower() != CARDINALS[len(functions) - 1]:
        return
    if name == "independence":
        yield from filter(None, [_independent(span, functions, text[slice(*span)])])
        return
    if brackets and name == "involution":
        says = "the brackets of these functions with each other vanish"
        about = (*functions, *brackets)
        yield InWords(span, Involution, about, {"functions": places}, name, says)
    elif brackets:
        says = "the bracket of this function with every function vanishes"
        for one in functions:
            values: dict[str, object] = {"printed": one.printed}
            yield InWords(span, Casimir, (one, *brackets), values, name, says)


def _are_anew(span: tuple[int, int], given: Sequence[SourceStatement], parts: Parts) -> bool:
    """Whether the section of some words prints brackets otherwise than they are given."""
    section = parts.paper.prose.path(span[0])[-1]
    first = {one.members[0] for one in given}
    return any(
        role.name == CLAIM and item.section is section and {*item.members[:1]} & first
        for item, role in parts.roles.items()
    )


def functions_of(
    items: Sequence[SourceStatement], known: Known, moved: Set[str] = frozenset()
) -> Iterator[SourceStatement]:
    """What defines or prints the functions that some statements name, of what moves.

    So do the names that are ``moved`` by brackets, if by no law.

    Brackets with what is made of names that nothing explains vanish, which says nothing.
    """
    for item in items:
        if isinstance(item.formula, Name):
            by = known.definition(item.formula.name, item)
            if by is not None and by.members and by.members[0] == item.formula:
                if known.varying(by.names - item.names) or moved & by.names:
                    yield by
        elif (
            item.formula is not None
            and not item.derives
            and (known.varying(item.names) or moved & item.names)
        ):
            role = known.roles.get(item)
            if not item.members or (role is not None and _names_first(item, role)):
                yield item


def _names_first(item: SourceStatement, role: StatementRole) -> bool:
    """Whether the first member of an equation is the function, or the square, that it names."""
    return role.kind == "square" or (bool(role.names) and item.bare[:1] == role.names[:1])


def _independent(
    span: tuple[int, int], functions: tuple[SourceStatement, ...], words: str
) -> InWords | None:
    """That functions are independent: almost everywhere, or at every point if the words say so."""
    places = tuple(one.printed for one in functions)
    if _WHERE.search(words) or _SOMEWHERE.search(words):
        return None
    if not _EVERYWHERE.search(words):
        values: dict[str, object] = {"levels": (), "equations": (), "functions": places}
        says = "these functions are independent"
        return InWords(span, Independence, functions, values, "independence", says)
    save = _SAVE.search(words)
    origin = save is not None and _ORIGIN.search(words, save.end()) is not None
    if save is not None and not origin:
        return None
    values = {"functions": places, "origin": origin}
    says = f"these functions are independent at every point{' but the origin' if origin else ''}"
    return InWords(span, EverywhereIndependent, functions, values, "independence", says)


def _invariant(
    span: tuple[int, int], cited: Sequence[SourceStatement], known: Known
) -> InWords | None:
    """That no motion leaves the set of cited equations, of which that is not claimed there."""
    roles = [known.roles.get(one) for one in cited]
    if not cited or any(role is None or role.kind in SETS for role in roles):
        return None
    if any(not one.members or one.derives or not known.varying(one.names) for one in cited):
        return None
    if any(role is not None and role.name == CLAIM and role.names for role in roles):
        return None
    places = tuple(one.printed for one in cited)
    says = "no motion leaves the set of these equations"
    return InWords(span, InvariantRelations, tuple(cited), {"relations": places}, "invariant", says)


def _counted(found: re.Match[str], start: int, parts: Parts) -> InWords | None:
    """How many equilibria the only law of a part of the paper has."""
    at = start + found.start()
    known = parts.known[parts.part_at(at)]
    if len([law for law in known.laws if not law.change]) != 1:
        return None
    number = CARDINALS.index(found["number"].lower()) + 1
    values: dict[str, object] = {"fixed": (), "levels": (), "count": number}
    before = [one for one in known.items if one.typed.start < at]
    rows = known.laws[0].rows
    about = (*rows, *(one for one in before[-1:] if not known.varying(one.names)))
    says = f"there are exactly {found['number'].lower()} states of rest"
    span = (at, start + found.end())
    here = (one for one in known.items if one.section is known.paper.prose.path(at)[-1])
    beside = next((one for one in here if one.typed.start > at), (*rows, *before)[-1])
    return InWords(span, Equilibria, about, values, "number", says, beside)
