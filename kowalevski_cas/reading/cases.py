"""Cases of which a paper speaks again: “in the case of Clebsch”, “in the second case”.

What was supposed where the case was introduced is in force where words name it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby

from kowalevski_cas.notation import Relation
from kowalevski_cas.reading.numerals import ORDINALS
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.text import Prose

_OF = re.compile(
    r"\b(?:[Ii]n|[Uu]nder|[Ff]or)\s+the\s+(?:cases?|conditions?)\s+of\s+(?P<of>[A-Z]\w{3,})"
    r"|\b(?:[Ii]n|[Uu]nder)\s+(?:the\s+)?(?P<his>[A-Z]\w{3,})(?:['’]s)?\s+(?:case|conditions?)\b"
    r"|\b(?:[Вв]\s+случае|[Пп]ри\s+услови\w+)\s+(?P<genitive>[А-ЯЁ]\w{3,})"
)
_IS_CASE = re.compile(r"\bcase|\bcondition|случа|услови", re.IGNORECASE)
_CASES = re.compile(r"\bcases\b|\bслуча(?:и|ях|ев|ями)\b", re.IGNORECASE)
_PROOF = re.compile(r"\\begin\s*\{(?:proof|dok|pf)[^{}]*\}|\bProof\b|Доказательство")
_STEM = 5
"""The letters of a name that stay where it is declined."""
_ENTRY = re.compile(r"\bcases?\s+\((?P<label>\w{1,4})\)|\bслуча\w+\s+\((?P<label_>\w{1,4})\)")
_LABEL = re.compile(r"\\item\s*\[\W*(\w+)\W*\]")
_ORDINAL = "|".join(word for words in ORDINALS for word in words)
_NUMBER = re.compile(
    rf"\b[Ii]n\s+the\s+(?P<number>{_ORDINAL})\s+(?P<what>case|one)\b"
    rf"|\b[Вв]о?\s+(?P<number_>{_ORDINAL})\w+\s+случае"
)


def named_case(
    item: SourceStatement, assumptions: Iterable[SourceStatement], prose: Prose
) -> list[SourceStatement]:
    """The assumptions of the case that the words before a statement name; none if they do not."""
    body = [one for one in assumptions if all(s.title != "abstract" for s in one.sections)]
    before = [one for one in body if one.order < item.order and one.members]
    if name := _case_of(item, prose):
        return [*_of_name(name, before)]
    if found := _ENTRY.search(item.before):
        return [*_of_entry(found["label"] or found["label_"], before, prose)]
    if found := _NUMBER.search(item.before):
        spoken = found["what"] != "one" or any(map(_NUMBER.search, item.earlier[:1]))
        if item.theorem is not None and spoken:
            return _of_number(found["number"] or found["number_"], item, before)
    return []


def is_told_apart(one: SourceStatement, sentence: Iterable[SourceStatement]) -> bool:
    """Whether a sentence tells a case from another one: “for a > 0 …, while for a < 0 …”.

    The same members have another sign between them there; the cases are over with the sentence.
    """
    if not isinstance(one.formula, Relation):
        return False
    others = (other.formula for other in sentence if other is not one)
    return any(
        isinstance(other, Relation)
        and other.members == one.formula.members
        and other.signs != one.formula.signs
        for other in others
    )


def proves(
    one: SourceStatement, item: SourceStatement, items: Iterable[SourceStatement], prose: Prose
) -> bool:
    """Whether a statement stands in the proof of a theorem that says something of one case only."""
    if one.theorem is None or one.theorem != item.theorem:
        return False
    proof = _PROOF.search(prose.text, one.typed.end, item.typed.start)
    stated = (o for o in items if o.theorem == one.theorem and o.members)
    return proof is not None and all(
        o.sentence == one.sentence for o in stated if o.typed.start < proof.start()
    )


def _case_of(item: SourceStatement, prose: Prose) -> str:
    """The name of the case of a statement; of the only one of its theorem, in the proof of this."""
    if found := _OF.search(item.before):
        return str(next(filter(None, found.groups())))
    start = item.theorem[0] if item.theorem is not None else item.typed.start
    words = prose.text[start : item.typed.start]
    names = {next(filter(None, one.groups())) for one in _OF.finditer(words)}
    return names.pop() if len(names) == 1 and _PROOF.search(words) else ""


def _of_name(name: str, before: Sequence[SourceStatement]) -> Iterator[SourceStatement]:
    """The assumptions of the sentence that calls a case by a name; not of one with several."""
    for one in before:
        several = _CASES.search(one.words)
        if name[:_STEM] in one.words and _IS_CASE.search(one.words) and not several:
            yield one


def _of_entry(
    label: str, before: Sequence[SourceStatement], prose: Prose
) -> Iterator[SourceStatement]:
    """The assumptions of the item of a list with a label, the last one that has it."""
    entries = [one.entry for one in before if one.entry is not None]
    own = [entry for entry in entries if _label(entry, prose) == label]
    yield from (one for one in before if own and one.entry == own[-1])


def _label(entry: tuple[int, int], prose: Prose) -> str:
    printed = _LABEL.match(prose.text, entry[0])
    return printed[1] if printed else ""


def _of_number(
    number: str, item: SourceStatement, before: Sequence[SourceStatement]
) -> list[SourceStatement]:
    """The assumptions of a sentence of its theorem, by the order of such sentences."""
    own = (one for one in before if one.theorem == item.theorem)
    groups = [[*group] for _, group in groupby(own, key=lambda one: one.sentence)]
    place = next(k for k, words in enumerate(ORDINALS) if number in words)
    return groups[place] if place < len(groups) else []
