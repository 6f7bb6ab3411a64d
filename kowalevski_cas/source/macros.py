"""The author's own macros, written out within limits.

What is written out remembers from where in the file it came.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass, field

from kowalevski_cas.source.definitions import MACRO, Definitions, Macro, definitions, group_at, skip
from kowalevski_cas.source.text import Source, SourceError
from kowalevski_cas.source.tokens import set_apart

DEEPEST = 30
"""Macros within macros."""
MOST = 20_000
"""Macros written out in one file."""
LONGEST = 8_000_000
"""Characters that all macros of a file may write out."""

_TOKEN = re.compile(r"\\(?:[A-Za-z]+|.)|.", re.DOTALL)
_SLOT = re.compile(r"#([1-9])")


@dataclass
class Expanded:
    """A text with macros written out, and where each part of it stands in the file."""

    text: str
    notes: list[tuple[int, str]]
    """Offsets in the file, and what is to be said about the place."""
    definitions: Definitions
    _starts: list[int] = field(default_factory=list)
    _pieces: list[tuple[int, int, bool]] = field(default_factory=list)

    def origin(self, start: int, end: int) -> tuple[int, int]:
        """The interval of the file that printed an interval of the text."""
        first = self._at(start)
        last = self._at(max(start, end - 1))
        return first[0], last[1]

    def _at(self, offset: int) -> tuple[int, int]:
        index = bisect_right(self._starts, offset) - 1
        start, end, literal = self._pieces[index]
        if literal:
            place = start + offset - self._starts[index]
            return place, place + 1
        return start, end


def expand(source: Source) -> Expanded:
    """The visible text of a source with the author's macros written out."""
    found = definitions(source.visible, (style.visible for style in source.styles))
    writer = _Writer(found, source)
    writer.run()
    notes = found.notes + writer.notes
    return Expanded("".join(writer.out), notes, found, writer.starts, writer.pieces)


class _Writer:
    """The state of writing out: what is written, and from where it came."""

    def __init__(self, found: Definitions, source: Source) -> None:
        self.text = found.text
        self.unclear = found.unclear
        self.coming = found.macros[::-1]
        self.macros: dict[str, Macro] = {}
        self.source = source
        self.out: list[str] = []
        self.starts: list[int] = []
        self.pieces: list[tuple[int, int, bool]] = []
        self.notes: list[tuple[int, str]] = []
        self.size = 0
        self.produced = 0
        self.count = 0

    def run(self) -> None:
        at = 0
        for match in MACRO.finditer(self.text):
            self.until(match.start())
            macro = self.macros.get(match[0])
            if macro is None or match.start() < at:
                continue
            self.add(self.text[at : match.start()], at, match.start(), True)
            try:
                body, at = self.call(self.text, macro, match.end(), 1)
            except RecursionError as error:
                self.notes.append((match.start(), str(error)))
                self.add(match[0], match.start(), match.end(), True)
                at = match.end()
                continue
            before = self.out[-1] if self.out else ""
            self.add(set_apart(before, body, self.text[at : at + 1]), match.start(), at, False)
        self.add(self.text[at:], at, len(self.text), True)

    def until(self, offset: int) -> None:
        """Learn the macros that hold at an offset, but for unclear ones."""
        while self.coming and self.coming[-1][0] <= offset:
            _, macro = self.coming.pop()
            if macro.name not in self.unclear:
                self.macros[macro.name] = macro

    def add(self, text: str, start: int, end: int, literal: bool) -> None:
        if text:
            self.starts.append(self.size)
            self.pieces.append((start, end, literal))
            self.out.append(text)
            self.size += len(text)

    def call(self, text: str, macro: Macro, at: int, depth: int) -> tuple[str, int]:
        """What a macro stands for here, and the offset behind its arguments."""
        self.count += 1
        if depth > DEEPEST:
            raise RecursionError(f"the macro {macro.name} expands into itself; it is left alone")
        if self.count > MOST:
            raise SourceError(f"{self.source.path}: more than {MOST:,} macros to write out")
        arguments, required = [], macro.arguments
        if macro.default is not None and required:
            required -= 1
            opening = skip(text, at)
            closing = text.find("]", opening) if text[opening : opening + 1] == "[" else -1
            arguments.append(text[opening + 1 : closing] if closing >= 0 else macro.default)
            at = closing + 1 if closing >= 0 else at
        for _ in range(required):
            at = skip(text, at)
            group = group_at(text, at)
            if group is None and (token := _TOKEN.match(text, at)) is not None:
                group = token[0], token.end()
            argument, at = group or ("", at)
            arguments.append(argument)
        body = _SLOT.sub(
            lambda slot: arguments[int(slot[1]) - 1] if int(slot[1]) <= len(arguments) else "",
            macro.body,
        )
        return self.written(body, depth), at

    def written(self, body: str, depth: int) -> str:
        """A body with the macros in it written out."""
        pieces, at = [], 0
        for match in MACRO.finditer(body):
            macro = self.macros.get(match[0])
            if macro is None or match.start() < at:
                continue
            pieces.append(body[at : match.start()])
            inner, at = self.call(body, macro, match.end(), depth + 1)
            pieces.append(set_apart("".join(pieces[-2:]), inner, body[at : at + 1]))
        pieces.append(body[at:])
        result = "".join(pieces)
        self.produced += len(result)
        if self.produced > LONGEST:
            raise SourceError(f"{self.source.path}: its macros write out too much text")
        return result
