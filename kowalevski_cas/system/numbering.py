"""The ids of what a section shows and claims."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Container
from dataclasses import dataclass, field

from kowalevski_cas.paper.derivation import Section
from kowalevski_cas.paper.texts import Display

LONGEST = 24
"""The signs of a formula by which a claim is called."""


@dataclass(frozen=True)
class Numbering:
    """The ids that are known in a section; each begins with a prefix."""

    section: Section
    prefix: str = ""
    shown: set[str] = field(default_factory=set)
    """The ids of displays."""
    numbers: Counter[tuple[str, int]] = field(default_factory=Counter)
    """How often an id was known, among displays or also among claims."""

    def display(self, id: str, tex: str, source: str = "") -> Display:
        """A new display of the section; with a ``source`` it need not stand in a paper."""
        id = self._new(id, self.shown)
        section = self.section
        display = section.lemma(id, tex, source) if source else section.display(id, tex)
        self.shown.add(id)
        return display

    def id(self, kind: str, tex: str) -> str:
        """A new id, after the label or the letters of a formula."""
        label = re.search(r"\\label\{([^}]*)\}", tex)
        tex = label[1] if label else tex
        letters = re.sub(r"[^A-Za-z0-9]+", "-", re.sub(r"=\s*0\b", "", tex))[:LONGEST].strip("-")
        id = self.prefix + "-".join(filter(None, (kind, letters)))
        return self._new(id, self.shown, self.section.lines)

    def _new(self, id: str, *known: Container[str]) -> str:
        """An id, with a number if it is known; all smaller numbers are."""
        new = id
        while any(new in ids for ids in known):
            self.numbers[id, len(known)] += 1
            new = f"{id}.{self.numbers[id, len(known)] + 1}"
        return new
