"""What sentences claim of maps: that one is symplectic, preserves a measure, or is integrable."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.claims import IntegrableMap, MeasureOfMap, PoissonMap
from kowalevski_cas.paper.names import BRACKET
from kowalevski_cas.reading.in_words import InWords, functions_of, is_unsure, sentences_of
from kowalevski_cas.reading.known import CLAIM, Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

_MAP = r"\b(?:map(?:ping)?|отображение)\b(?:[\s~]*\(?(?:§|\\(?:eq)?ref\s*\{[^{}]*\})\)?)?[\s,~]*"
_IS = r"(?:is|are|является|[-—–]+)\s+(?:an?\s+|also\s+|thus\s+)*"
_SAYS = {
    "symplectic": re.compile(
        rf"{_MAP}(?:{_IS}(?:symplectic|canonical|симплектическ\w+|каноническ\w+)"
        r"|preserves\s+(?:the|this|its)\s+(?:(?:canonical|symplectic|Poisson)\s+)*"
        r"(?:brackets?|form|structure)\b)",
        re.IGNORECASE,
    ),
    "measure": re.compile(
        rf"{_MAP}preserves\s+(?:the|an?)\s+(?:invariant\s+)?measure\s+(?:with\s+(?:the\s+)?density\s+)?§",
        re.IGNORECASE,
    ),
    "area": re.compile(
        rf"{_MAP}(?:{_IS}(?:area|volume|measure)[\s~-]+preserving"
        r"|preserves\s+(?:the\s+)?(?:areas?|volumes?)\b|сохраняет\s+площад\w+)",
        re.IGNORECASE,
    ),
    "integrable": re.compile(
        rf"{_MAP}{_IS}(?:completely\s+|Liouville\s+)?(?:integrable|интегрируем\w+)", re.IGNORECASE
    ),
}
_THIN = re.compile(r"\\(?:[,;:! ]|wedge(?![A-Za-z])|q?quad(?![A-Za-z]))|~")


def claims_of_maps(parts: Parts) -> Iterator[InWords]:
    """The claims that the sentences of a paper make of its maps."""
    for start, words in sentences_of(parts):
        if is_unsure(words):
            continue
        for name, pattern in _SAYS.items():
            if found := pattern.search(words):
                span = (start + found.start(), start + len(words.rstrip()))
                yield from _claimed(name, span, start + found.end(), parts)


def _claimed(name: str, span: tuple[int, int], end: int, parts: Parts) -> Iterator[InWords]:
    """What a sentence claims of the map that it cites, or of the last one before it."""
    known = parts.known[parts.part_at(span[0])]
    maps = [law for law in known.laws if law.images and law.first.typed.start <= span[1]]
    inside = [one for one in known.items if span[0] <= one.typed.start < span[1]]
    if not maps:
        return
    law = maps[-1]
    rows: tuple[SourceStatement, ...] = (*law.items, *law.solved)
    values: dict[str, object] = {"images": law.images}
    at = _last_before(span, known)
    if name == "symplectic":
        if brackets := _brackets(known):
            says = "the map preserves the bracket"
            yield InWords(span, PoissonMap, (*rows, *brackets), values, name, says, at)
    elif name == "integrable":
        yield from _integrable(span, [one for one in inside if one.typed.start >= end], law, known)
    else:
        density = _density(name, inside, end, law, known)
        if density is not None:
            says = f"the map preserves the measure with the density ${density.printed.tex}$"
            about = (*rows, density)
            own = {**values, "printed": density.printed}
            yield InWords(span, MeasureOfMap, about, own, name, says, at)


def _last_before(span: tuple[int, int], known: Known) -> SourceStatement | None:
    """The last statement before the end of some words, of which what it supposes holds there."""
    before = [
        one
        for one in known.items
        if one.typed.start < span[1]
        and (one.sentence[1] >= span[1] or known.roles[one].kind != "of the sentence")
    ]
    return before[-1] if before else None


def _brackets(known: Known) -> list[SourceStatement]:
    """What defines the brackets of variables."""
    found = (own for head, own in known.definitions.items() if head.startswith(BRACKET))
    return [one for own in found for one in own]


def _integrable(
    span: tuple[int, int], listed: list[SourceStatement], law: Law, known: Known
) -> Iterator[InWords]:
    """That a map is integrable, by the invariants in its sentence, or by all before it."""
    before = [
        one
        for one, role in known.roles.items()
        if (role.name, role.kind) == (CLAIM, "integral") and one.typed.start < span[0]
    ]
    functions = tuple(dict.fromkeys(functions_of(listed or before, known)))
    brackets = _brackets(known)
    if not brackets or 2 * len(functions) != len(law.variables):
        return
    about = (*functions, *law.items, *law.solved, *brackets)
    places = tuple(one.printed for one in functions)
    says = "the map is integrable in the sense of Liouville"
    values: dict[str, object] = {"images": law.images, "invariants": places}
    yield InWords(span, IntegrableMap, about, values, "integrable", says)


def _density(
    name: str, inside: list[SourceStatement], end: int, law: Law, known: Known
) -> SourceStatement | None:
    """The density of a measure that is printed right before the end of words; 1 for an area."""
    tex = "1"
    if name == "measure":
        printed = [one for one in inside if one.typed.start < end]
        if not printed:
            return None
        last = printed[-1]
        tex = without_differentials(last.typed.tex, law.variables)
        if tex == last.typed.tex:
            return last if last.formula is not None and not last.members else None
    try:
        return unprinted(known.paper, f"density-{law.first.order}-{end}", tex, law.first)
    except NotationError:
        return None


def without_differentials(tex: str, names: tuple[str, ...]) -> str:
    r"""A measure without the differentials of all variables; as it is, if one is missing.

    >>> without_differentials(r"\frac{dx\wedge dy}{xy}", ("x", "y"))
    '\\frac{1}{xy}'
    """
    found = _THIN.sub(" ", tex)
    for name in names:
        found, count = re.subn(rf"(?<![A-Za-z])d\s*{re.escape(name)}(?![A-Za-z_])", "", found)
        if count != 1:
            return tex
    found = re.sub(r"\\frac\s*\{\s*\}", r"\\frac{1}", found)
    return found.strip() or "1"
