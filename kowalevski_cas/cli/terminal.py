"""What is printed: any letters, and no control characters but those of styles of our own.

Formulas, names and messages come from papers, and from other programs: none of them may steer a
terminal.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from typing import Any, TextIO

_FIRST = 0xFDD0
"""Styles are printed as codes that Unicode keeps for the inside of programs, and no text has."""

_STYLES = (0, 1, *range(31, 37))
"""The numbers by which a terminal knows plain letters, bold ones, and those in colours."""

_STYLE = re.compile(f"[{chr(_FIRST)}-{chr(_FIRST + len(_STYLES) - 1)}]")

_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
"""Characters by which a text could steer a terminal, or turn round what is read."""


def printable(text: str) -> str:
    """A text with a question mark for each control character."""
    return _CONTROL.sub("?", text)


def with_style(words: str, style: int) -> str:
    """Words in a style that terminals know by this number, if the output shows styles."""
    if not (isinstance(sys.stdout, Output) and sys.stdout.has_styles):
        return words
    return f"{chr(_FIRST + _STYLES.index(style))}{words}{chr(_FIRST)}"


def width(words: str) -> int:
    """The number of letters that are seen of words."""
    return len(_STYLE.sub("", words))


class Output:
    """A stream on which printable text is written; all else is done by the stream itself."""

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream
        self.has_styles = stream.isatty() and not os.environ.get("NO_COLOR")

    def write(self, text: str) -> int:
        """Write a text."""
        text = printable(text)
        if self.has_styles:
            text = _STYLE.sub(_escape, text)
        return self.stream.write(text)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


def _escape(mark: re.Match[str]) -> str:
    return f"\x1b[{_STYLES[ord(mark[0]) - _FIRST]}m"


@contextmanager
def output() -> Iterator[None]:
    """Let any text be printed; what is closed swallows it, and no file gets its number."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    streams = [Output(_open(stream)) for stream in (sys.stdout, sys.stderr)]
    with redirect_stdout(streams[0]), redirect_stderr(streams[1]):
        yield


def _open(stream: TextIO | None) -> TextIO:
    if stream is None:
        return open(os.devnull, "w", encoding="utf-8")
    if hasattr(stream, "reconfigure"):
        stream.reconfigure(encoding="utf-8", errors="backslashreplace")
    return stream
