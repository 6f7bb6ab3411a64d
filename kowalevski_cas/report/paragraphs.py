"""Words and formulas, one after the other, as paragraphs and displays."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from kowalevski_cas.report.document import Block, Code, Inline, Paragraph, Text

FIRST: Final = 0xF0000
"""The letter that stands for the first formula; no font and no author has it."""

_FORMULA: Final = re.compile(r"([\U000F0000-\U000FFFFD])")
_PARAGRAPH: Final = re.compile(r"\n[ \t\r]*\n\s*")


@dataclass(frozen=True)
class FormulaBlocks:
    """What stands for a formula: within a line a text, and blocks, which follow the paragraph."""

    text: Text
    blocks: tuple[Block, ...] = ()
    inline: bool = False


class Paragraphs:
    """What was read so far: the ``blocks`` that ended, the ``line``, and what follows ``after`` it.

    Args:
        placed: what stands for each formula.
    """

    def __init__(self, placed: Sequence[FormulaBlocks]) -> None:
        self.placed = placed
        self.blocks: list[Block] = []
        self.line: list[Inline] = []
        self.after: list[Block] = []
        self.place = ""

    def end(self) -> None:
        """The paragraph ends, and what its formulas bring with them follows."""
        if says(self.line):
            self.blocks.append(Paragraph(tuple(self.line), anchor=self.place))
            self.place = ""
        self.blocks += self.after
        self.line, self.after = [], []

    def words(self, text: str) -> None:
        """Words with formulas, and the breaks between paragraphs."""
        for k, paragraph in enumerate(_PARAGRAPH.split(text)):
            if k:
                self.end()
            for part in _FORMULA.split(paragraph):
                if _FORMULA.fullmatch(part):
                    self.formula(self.placed[ord(part) - FIRST])
                elif part:
                    self.line.append(re.sub(r"\s+", " ", part))

    def stays_in_line(self, tex: str) -> bool:
        """Whether a piece of TeX neither ends a paragraph nor displays a formula."""
        placed = [self.placed[ord(letter) - FIRST] for letter in _FORMULA.findall(tex)]
        return not _PARAGRAPH.search(tex) and all(one.inline for one in placed)

    def formula(self, placed: FormulaBlocks) -> None:
        """A formula, within the line or in blocks of its own."""
        if placed.inline:
            self.line += placed.text
            self.after += placed.blocks
        else:
            self.end()
            self.blocks += placed.blocks

    def source(self, tex: str) -> None:
        """A piece of TeX as it is typed, with the formulas in it as formulas."""
        for part in _FORMULA.split(tex):
            if _FORMULA.fullmatch(part):
                self.formula(self.placed[ord(part) - FIRST])
            elif part.strip():
                self.line.append(Code(part.strip()))


def says(text: Sequence[Inline]) -> bool:
    """Whether there is more in a text than spaces."""
    return any(not isinstance(inline, str) or inline.strip() for inline in text)
