"""A text with macros written out: where each part of it comes from, and what cannot be told."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from dataclasses import dataclass, field

from kowalevski_cas.source.parameters import NO_VALUE
from kowalevski_cas.source.tex import TypedToken, is_word

MOST_NOTES = 20
"""Things that are not understood, after which no more are told."""


@dataclass
class Expanded:
    """A text with macros written out, and where each part of it stands in the file."""

    text: str
    body: int
    """The offset in the text at which the document begins."""
    notes: list[tuple[int, str]]
    """Offsets in the file, and what is to be said about the place."""
    unclear: list[tuple[int, int, str]] = field(default_factory=list)
    """Intervals of the text that cannot be told, and why."""
    _starts: list[int] = field(default_factory=list)
    _pieces: list[tuple[int, int, bool]] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Sort what is asked for by its place."""
        self.unclear.sort()
        self._ends: list[int] = []
        """The furthest end of an unclear interval up to each one."""
        for _, end, _ in self.unclear:
            self._ends.append(max(end, self._ends[-1]) if self._ends else end)

    def origin(self, start: int, end: int) -> tuple[int, int]:
        """The interval of the file that printed an interval of the text."""
        first = self._at(start)
        last = self._at(max(start, end - 1))
        return first[0], last[1]

    def _at(self, offset: int) -> tuple[int, int]:
        index = max(0, bisect_right(self._starts, offset) - 1)
        if index >= len(self._pieces):
            return offset, offset + 1
        start, end, literal = self._pieces[index]
        if literal:
            place = start + offset - self._starts[index]
            return place, place + 1
        return start, end

    def behind(self, offset: int) -> int:
        """The place in the text of the first sign that comes from behind an offset of the file."""
        for start, (begin, end, literal) in zip(self._starts, self._pieces, strict=True):
            if literal and begin <= offset < end:
                start, begin = start + offset - begin, offset
            if begin >= offset:
                rest = self.text[start:]
                return start + len(rest) - len(rest.lstrip())
        return len(self.text)

    def why(self, start: int, end: int) -> str:
        """Why an interval of the text cannot be told; empty if it can."""
        first = bisect_left(self._ends, start)
        for begin, stop, why in self.unclear[first:]:
            if begin > end:
                break
            if stop >= start:
                return why
        return ""


class ExpandedOutput:
    """The text as it is written, piece by piece."""

    def __init__(self) -> None:
        self.out: list[str] = []
        self.starts: list[int] = []
        self.pieces: list[tuple[int, int, bool]] = []
        self.size = 0
        self.unclear: list[tuple[int, int, str]] = []

    @property
    def last(self) -> str:
        """What was written last."""
        return self.out[-1] if self.out else ""

    def emit(self, token: TypedToken, why: str = "") -> None:
        """Write a token; ``why`` it cannot be told what it means, if so."""
        text, begin = token.text, self.size
        if text[:1].isalpha() and is_word(self.last):
            self.write(" ", token.start, token.start + 1 if token.literal else token.end)
        if text == NO_VALUE:
            why = "an argument is missing"
        self.write(text, token.start, token.end, token.literal)
        if why:
            self.lose(begin, why)

    def write(self, text: str, start: int, end: int, literal: bool = False) -> None:
        """Write some text that comes from an interval of the file."""
        self.starts.append(self.size)
        self.pieces.append((start, end, literal))
        self.out.append(text)
        self.size += len(text)

    def lose(self, begin: int, why: str) -> None:
        """What was written from a place on cannot be told."""
        self.unclear.append((begin, self.size, why))

    def back(self, count: int, size: int) -> None:
        """Take back all but so many pieces."""
        del self.out[count:], self.starts[count:], self.pieces[count:]
        self.size = size

    def expanded(self, body: int, notes: list[tuple[int, str]]) -> Expanded:
        """What is written; the document begins at ``body``."""
        if len(notes) > MOST_NOTES:
            rest = f"and {len(notes) - MOST_NOTES} notes like these"
            notes = [*notes[:MOST_NOTES], (notes[MOST_NOTES][0], rest)]
        return Expanded("".join(self.out), body, notes, self.unclear, self.starts, self.pieces)
