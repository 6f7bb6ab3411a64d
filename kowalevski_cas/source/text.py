"""A TeX file as text: what prints of it, and where.

What does not print (comments, verbatim text, what follows the end of the document)
is blanked out, so that every offset stays that of the file.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property

from kowalevski_cas import UserError

LONGEST_VERB = 1000
"""Characters in one line of verbatim text."""

_VERBATIM = "verbatim|Verbatim|lstlisting|minted|comment|filecontents"
_SILENT = re.compile(
    r"\\(?:\\|%)"  # escaped: it prints
    r"|(?P<line>^[ \t]*%[^\n]*\n?)"
    r"|(?P<comment>%[^\n]*)"
    rf"|\\begin\s*\{{(?P<name>(?:{_VERBATIM})\*?)\}}"
    r"|\\verb\*?(?P<mark>[^\w\s*])"
    r"|(?P<off>\\iffalse)(?![A-Za-z])"
    r"|(?P<end>\\end\s*\{document\})",
    re.MULTILINE,
)
_BEGINNING = re.compile(r"\\begin\s*\{document\}")
_PRINTING = re.compile(r"[^\r\n]")


class SourceError(UserError, ValueError):
    """A file that cannot be read as TeX; the message names the file and the reason."""


@dataclass(frozen=True)
class Source:
    """The text of a TeX file, and the same text with all that does not print blanked.

    ``styles`` are the files of macros that it uses, ``beside`` is that of comments on it.
    """

    path: str
    text: str
    encoding: str = "utf-8"
    styles: tuple[Source, ...] = ()
    beside: Source | None = None

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
        return _blanked(self.text)

    @cached_property
    def body(self) -> int:
        """The offset at which the document begins; 0 for a fragment."""
        found = _BEGINNING.search(self.visible)
        return found.end() if found else 0

    @cached_property
    def _lines(self) -> list[int]:
        return [0, *(match.end() for match in re.finditer("\n", self.text))]

    def line(self, offset: int) -> int:
        """The number of the line at an offset, counted from 1."""
        return bisect_right(self._lines, offset)

    def column(self, offset: int) -> int:
        """The column at an offset, counted from 1."""
        return offset - self._lines[self.line(offset) - 1] + 1


def _blanked(text: str) -> tuple[str, list[int]]:
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
        piece = text[start:end]
        if last in ("line", "comment"):
            comments.append(text.index("%", start))
        # The end of a line that is a comment makes no paragraph: it does not print either.
        blank = " " * len(piece) if last == "line" else _PRINTING.sub(" ", piece)
        pieces += [text[at:start], blank if last else piece]
        at = end
    return "".join([*pieces, text[at:]]), comments


_CONDITIONAL = re.compile(r"\\(if[a-zA-Z]*|fi)(?![A-Za-z])|\\(?:newif|\\)")


def _after_fi(text: str, at: int) -> int:
    r"""The offset behind the ``\fi`` of a conditional that is never taken."""
    depth = 1
    for match in _CONDITIONAL.finditer(text, at):
        if match[1] and match[1] not in ("iff",):
            depth += -1 if match[1] == "fi" else 1
        if depth == 0:
            return match.end()
    return len(text)
