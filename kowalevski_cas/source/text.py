"""The text of a paper's files, in the order in which TeX reads them: what prints of it, and where.

What does not print (comments, verbatim text, what follows the end of the document)
is blanked out, so that every offset stays that of the text.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

from kowalevski_cas import UserError

LONGEST_VERB = 1000
"""Characters in one line of verbatim text."""

_VERBATIM = "verbatim|Verbatim|alltt|lstlisting|minted|comment|filecontents"
_SILENT = re.compile(
    r"\\(?:\\|%)"  # escaped: it prints
    r"|(?P<line>^[ \t]*%[^\n]*\n?)"
    r"|(?P<comment>%[^\n]*)"
    rf"|\\begin\s*\{{(?P<name>(?:{_VERBATIM})\*?)\}}"
    r"|(?P<link>\\(?:url|path|nolinkurl|href)\s*\{[^{}\n]*\})"
    r"|\\(?:verb|lstinline)(?![A-Za-z])\*?(?P<mark>[^\w\s*])"
    r"|(?P<off>\\iffalse)(?![A-Za-z])"
    r"|(?P<end>\\end\s*\{document\})",
    re.MULTILINE,
)
_PRINTING = re.compile(r"[^\r\n]")


class SourceError(UserError, ValueError):
    """A file that cannot be read as TeX; the message names the file and the reason."""


class Region(NamedTuple):
    """A stretch of a file, in lines and columns counted from 1; the end is behind its last sign.

    Without columns it is the whole line; without a line, the file.
    """

    path: str
    line: int = 0
    column: int = 0
    end_line: int = 0
    end_column: int = 0


@dataclass(frozen=True)
class Part:
    """A stretch of the text, and where it stands in which file."""

    path: str
    start: int
    end: int
    first: int = 0
    """The offset in the file at which it begins."""
    style: bool = False
    """Whether it is of a file of macros, in which no formula is read."""


@dataclass(frozen=True)
class Source:
    """The text of a paper, and the same text with all that does not print blanked.

    ``parts`` say of which files the text is made; without them it is that of one file. ``beside``
    is the file of comments on it, ``refused`` what was not read: places, and the reasons.
    """

    path: str
    text: str
    encoding: str = "utf-8"
    parts: tuple[Part, ...] = ()
    beside: Source | None = None
    refused: tuple[tuple[int, str], ...] = ()

    def __post_init__(self) -> None:
        """A text without parts is that of one file."""
        if not self.parts:
            object.__setattr__(self, "parts", (Part(self.path, 0, len(self.text)),))

    @property
    def visible(self) -> str:
        """The text with comments, verbatim passages and what follows the end as blanks."""
        return self._blanked[0]

    @property
    def comments(self) -> list[int]:
        """The offsets of the signs of comments."""
        return self._blanked[1]

    @cached_property
    def _blanked(self) -> tuple[str, list[int]]:
        found = [(part.start, *blank_out(self.text[part.start : part.end])) for part in self.parts]
        comments = [start + at for start, _, places in found for at in places]
        return "".join(text for _, text, _ in found), comments

    @cached_property
    def _starts(self) -> list[int]:
        return [part.start for part in self.parts]

    @cached_property
    def _lines(self) -> dict[str, list[int]]:
        """Where in each file its lines begin."""
        return {
            path: [0, *(match.end() for match in re.finditer("\n", text))]
            for path, text in self.files.items()
        }

    def part(self, offset: int) -> Part:
        """The part of the text in which an offset stands."""
        return self.parts[max(0, bisect_right(self._starts, offset) - 1)]

    def line(self, offset: int) -> int:
        """The number of the line of its file in which an offset stands, counted from 1."""
        return self._position(self.part(offset), offset)[0]

    def column(self, offset: int) -> int:
        """The column at an offset, counted from 1."""
        return self._position(self.part(offset), offset)[1]

    def region(self, start: int, end: int) -> Region:
        """Where an interval stands, as far as it stands in one file."""
        part = self.part(start)
        inside = max(start, min(end, part.end))
        return Region(part.path, *self._position(part, start), *self._position(part, inside))

    def _position(self, part: Part, offset: int) -> tuple[int, int]:
        """The line and the column of an offset in a part, or at its end."""
        stretches = {p.first: p for p in self.parts if p.path == part.path and p.first < part.first}
        at = sum(p.end - p.start for p in stretches.values()) + offset - part.start
        starts = self._lines[part.path]
        line = bisect_right(starts, at)
        return line, at - starts[line - 1] + 1

    def place(self, offset: int) -> str:
        """The file and the line at an offset."""
        return f"{self.part(offset).path}:{self.line(offset)}"

    @cached_property
    def files(self) -> dict[str, str]:
        """The texts of the files that are read, by their paths."""
        stretches = {(p.path, p.first): self.text[p.start : p.end] for p in reversed(self.parts)}
        texts: dict[str, str] = {path: "" for path in dict.fromkeys(p.path for p in self.parts)}
        for (path, _), text in sorted(stretches.items()):
            texts[path] += text
        return texts

    def edited(self, replacements: Mapping[tuple[int, int], str]) -> Source:
        """The source with other text in some intervals."""
        text, parts = self.text, list(self.parts)
        for start, end in sorted(replacements, reverse=True):
            new = replacements[start, end]
            text = text[:start] + new + text[end:]
            grown = len(new) - (end - start)
            for number, part in enumerate(parts):
                holds = part.start <= start and end <= part.end
                moved = grown if start < part.start else 0
                longer = grown if holds or moved else 0
                parts[number] = replace(part, start=part.start + moved, end=part.end + longer)
        return replace(self, text=text, parts=tuple(parts))


def blank_out(text: str) -> tuple[str, list[int]]:
    """The text with blanks for what does not print, and the offsets of the signs of comments."""
    pieces: list[str] = []
    comments: list[int] = []
    at = 0
    while (match := _SILENT.search(text, at)) is not None:
        start, end = match.span()
        last = match.lastgroup
        if last == "end":
            end = len(text)
        elif last == "name":
            closing = text.find(rf"\end{{{match['name']}}}", end)
            end = len(text) if closing < 0 else closing + len(match["name"]) + 6
        elif last == "mark":
            closing = text.find(match["mark"], end, end + LONGEST_VERB)
            end = end if closing < 0 or "\n" in text[end:closing] else closing + 1
        elif last == "off":
            end = _after_fi(text, end)
            last = last if end > match.end() else None
        piece = text[start:end]
        if last in ("line", "comment"):
            comments.append(text.index("%", start))
        # The end of a line that is a comment makes no paragraph: it does not print either.
        blank = " " * len(piece) if last == "line" else _PRINTING.sub(" ", piece)
        pieces += [text[at:start], blank if last else piece]
        at = end
    return "".join([*pieces, text[at:]]), comments


_CONDITIONAL = re.compile(
    r"\\(?P<if>if(?!f(?![A-Za-z]))[a-zA-Z]*)|\\(?P<end>fi|else)(?![A-Za-z])"
    r"|\\(?:newif|.)|[{}]",
    re.DOTALL,
)


def _after_fi(text: str, at: int) -> int:
    r"""The offset behind what is never printed: the ``\fi`` or ``\else`` of this ``\iffalse``.

    In the body of a definition, where a brace closes before it, nothing is left out.
    """
    depth, braces = 1, 0
    for match in _CONDITIONAL.finditer(text, at):
        braces += {"{": 1, "}": -1}.get(match[0], 0)
        if braces < 0:
            return at
        if match["if"]:
            depth += 1
        elif match["end"] and (depth == 1 or match["end"] == "fi"):
            depth -= 1
            if depth == 0:
                return match.end()
    return len(text)
