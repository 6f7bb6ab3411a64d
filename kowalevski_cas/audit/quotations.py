"""The author's sentences: what claims rest on that no formula prints, sought in the source.

A sentence is found if the source has it word for word, from one stop to the next. Spaces, fonts
and line breaks do not matter; nor does an inline formula that the derivation has a place for,
which is compared there.
"""

from __future__ import annotations

from collections.abc import Sequence
from difflib import SequenceMatcher
from functools import cached_property

from kowalevski_cas.audit.places import Correspondence
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.source.displays import TypedFormula, find_formulas
from kowalevski_cas.source.expanded import Expanded
from kowalevski_cas.source.sentences import STOP, Word, sentence_words
from kowalevski_cas.source.text import Region, Source
from kowalevski_cas.source.tokens import words

ALIKE = 0.4
"""How much alike a sentence must be to be shown as what the source says instead."""
LONGEST = 160
"""Characters of a sentence that are shown."""


class Quotations:
    """The sentences of a source, as a derivation quotes them."""

    def __init__(
        self,
        source: Source,
        expanded: Expanded,
        typed: Sequence[TypedFormula],
        places: Sequence[Correspondence],
        derivation: Derivation,
    ) -> None:
        self.source, self.expanded, self.derivation = source, expanded, derivation
        self.names = {words(d.tex): d.id for d in derivation.displays() if d.inline}
        ids = {id(place.typed): place.display.id for place in places}
        self.words = sentence_words(
            expanded.text, expanded.body, typed, lambda f: ids.get(id(f)) or self.called(f)
        )
        self.texts = [word.text for word in self.words]

    def called(self, formula: TypedFormula) -> str:
        """An inline formula by its id, or by what it prints."""
        printed = words(formula.tex)
        return self.names.get(printed) or f"${' '.join(printed)}$"

    @cached_property
    def found(self) -> dict[Claim, Word | None]:
        """The first words of the sentences that claims quote, if the source has them."""
        quoted = (claim for claim in self.derivation.claims if claim.sentence)
        return {claim: self.place(claim.sentence) for claim in quoted}

    def intervals(self) -> dict[str, tuple[int, int]]:
        """The intervals of the text at which sentences stand that claims quote, by their ids."""
        firsts = {id(word): place for place, word in enumerate(self.words)}
        found = {}
        for claim, word in self.found.items():
            if word is not None:
                first = firsts[id(word)]
                last = self.words[first + len(self.split(claim.sentence)) - 1]
                found[claim.id] = word.start, last.end
        return found

    def regions(self) -> dict[str, Region]:
        """Where the sentences stand that are found, by the ids of claims."""
        return {
            id: self.source.region(*self.expanded.origin(*interval))
            for id, interval in self.intervals().items()
        }

    def differing(self) -> dict[str, str]:
        """What is to be said of claims of which the source has not the sentence."""
        lost = [claim for claim, word in self.found.items() if word is None]
        return {claim.id: self.instead(claim.sentence) for claim in lost}

    def place(self, sentence: str) -> Word | None:
        """The first word of a sentence where it stands between two stops."""
        wanted = [STOP, *self.split(sentence), STOP]
        padded = [STOP, *self.texts, STOP]
        for k in range(len(padded) - len(wanted) + 1):
            if padded[k + 1] == wanted[1] and padded[k : k + len(wanted)] == wanted:
                return self.words[k]
        return None

    def split(self, sentence: str) -> list[str]:
        """The words of a sentence of the derivation."""
        found = sentence_words(sentence, 0, [*find_formulas(sentence)], self.called)
        texts = [word.text for word in found]
        return texts[:-1] if texts[-1:] == [STOP] else texts

    def instead(self, sentence: str) -> str:
        """What the source says in the place of a sentence."""
        wanted, best = self.split(sentence), (ALIKE, -1, -1)
        stops = [-1, *(k for k, text in enumerate(self.texts) if text == STOP), len(self.texts)]
        size = max(1, wanted.count(STOP) + 1)
        for first, last in zip(stops, stops[size:], strict=False):
            matcher = SequenceMatcher(None, self.texts[first + 1 : last], wanted, autojunk=False)
            if matcher.real_quick_ratio() > best[0] and matcher.quick_ratio() > best[0]:
                best = max(best, (matcher.ratio(), first + 1, last))
        if best[1] < 0:
            return f"the words differ: the source does not say “{_short(sentence)}”"
        first_word, last_word = self.words[best[1]], self.words[best[2] - 1]
        said = _short(self.expanded.text[first_word.start : last_word.end])
        line = self.line(first_word)
        return f"the words differ: line {line} says “{said}”, and not “{_short(sentence)}”"

    def line(self, word: Word) -> int:
        """The line of the file in which a word stands."""
        return self.source.line(self.expanded.origin(word.start, word.end)[0])


def _short(text: str) -> str:
    text = " ".join(text.split())
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"
