"""A TeX file as text: read within limits, nothing executed, nothing else opened.

What does not print (comments, verbatim text, what follows the end of the document)
is blanked out, so that every offset stays that of the file.
"""

from __future__ import annotations

import os
import re
import stat
from bisect import bisect_right
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from kowalevski_cas import UserError

LARGEST = 4_000_000
"""Bytes in a source; the longest papers have a tenth of this."""

LONGEST_VERB = 1000
"""Characters in one line of verbatim text."""

NOISE = 0.01
"""The share of control characters from which a file is not taken for text."""

_INPUTENC = re.compile(r"\\usepackage\s*\[\s*([\w-]+)\s*\]\s*\{inputenc\}")
_CODECS = {"utf8x": "utf-8", "ansinew": "cp1252", "applemac": "mac-roman"}
"""Encodings that Python calls otherwise than LaTeX."""
_VERBATIM = "verbatim|Verbatim|lstlisting|minted|comment|filecontents"
_SILENT = re.compile(
    r"\\(?:\\|%)"  # escaped: it prints
    r"|(?P<comment>%[^\n]*)"
    rf"|\\begin\s*\{{(?P<name>(?:{_VERBATIM})\*?)\}}"
    r"|\\verb\*?(?P<mark>[^\w\s*])"
    r"|(?P<off>\\iffalse)(?![A-Za-z])"
    r"|(?P<end>\\end\s*\{document\})"
)
_BEGINNING = re.compile(r"\\begin\s*\{document\}")
_PRINTING = re.compile(r"[^\r\n]")


class SourceError(UserError, ValueError):
    """A file that cannot be read as TeX; the message names the file and the reason."""


@dataclass(frozen=True)
class Source:
    """The text of a TeX file, and the same text with all that does not print blanked.

    ``styles`` are the files of macros that it uses.
    """

    path: str
    text: str
    encoding: str = "utf-8"
    styles: tuple[Source, ...] = ()

    @cached_property
    def visible(self) -> str:
        """The text with comments, verbatim passages and what follows the end as blanks."""
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


def read_source(path: Path, styles: Iterable[Path] = ()) -> Source:
    """The source in a file, with the style files whose macros it uses.

    Raises :class:`SourceError` for what is no file of text of a sensible size.
    """
    try:
        # Opening a pipe would wait for a writer; so the kind is asked for first.
        kind = path.stat()
        is_file = stat.S_ISREG(kind.st_mode)
        data = path.read_bytes() if is_file and kind.st_size <= LARGEST else b""
    except OSError as error:
        raise SourceError(f"{path} cannot be read: {error.strerror}") from None
    except ValueError as error:
        raise SourceError(f"{os.fspath(path)!r} cannot be read: {error}") from None
    if not is_file:
        raise SourceError(f"{path} is not a file")
    if kind.st_size > LARGEST:
        raise SourceError(
            f"{path} has {kind.st_size:,} bytes; a source of more than {LARGEST:,} is not read"
        )
    return replace(decode(str(path), data), styles=tuple(map(read_source, styles)))


def decode(path: str, data: bytes) -> Source:
    """The source in these bytes."""
    if not data.strip():
        raise SourceError(f"{path} is empty")
    control = sum(data.count(bytes([code])) for code in (*range(9), 11, *range(14, 32), 127))
    if control > NOISE * len(data):
        raise SourceError(f"{path} is not a text file: it is full of control characters")
    head = data[:20_000].decode("latin-1")
    declared = _INPUTENC.search(head)
    encodings = ["utf-8-sig" if data.startswith(b"\xef\xbb\xbf") else "utf-8"]
    if declared:
        encodings.append(_CODECS.get(declared[1], declared[1]))
    for encoding in (*encodings, "latin-1"):
        try:
            return Source(path, data.decode(encoding), encoding)
        except (UnicodeDecodeError, LookupError):
            continue
    raise SourceError(f"{path} is in no encoding that is known")


def _blanked(text: str) -> str:
    pieces: list[str] = []
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
        pieces += [text[at:start], _PRINTING.sub(" ", piece) if last else piece]
        at = end
    return "".join([*pieces, text[at:]])


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
