"""Comments that say how a source is meant: lines with ``%kc:``, and those of a file beside it.

A comment is about the formula in which it stands; at the end of a line, about the last formula of
this line; else about the next one. In the file beside the source, ``PAPER.kc``, the same comments
stand after a label of the source, or after some words of it in quotes:

    eq20 %kc: on eq19
    "is purely imaginary" %kc: claim reality
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass

from kowalevski_cas.source.text import Source, SourceError

MARK = "%kc:"

_BESIDE = re.compile(r"(?P<place>[^%]*)(?P<mark>%kc:)?(?P<words>.*)")
_QUOTED = re.compile(r'"(.*)"')


@dataclass(frozen=True)
class Comment:
    """What an author says to this program, where it is written, and of what."""

    words: str
    path: str
    line: int
    offset: int
    """The place in the text of the source that it is about."""
    trailing: bool = False
    """Whether the line has something before it."""


def find_comments(source: Source) -> list[Comment]:
    """The comments of a source and of the file beside it, by the places that they are about.

    Raises:
        SourceError: what a comment of the file beside the source is about does not stand in it.
    """
    found = [*_inside(source), *(() if source.beside is None else _beside(source, source.beside))]
    return sorted(found, key=lambda comment: comment.offset)


def _inside(source: Source) -> list[Comment]:
    found = []
    for start in source.comments:
        if source.text.startswith(MARK, start):
            words = source.text[start + len(MARK) :].partition("\n")[0].strip()
            before = source.text[source.text.rfind("\n", 0, start) + 1 : start]
            found.append(
                Comment(words, source.path, source.line(start), start, bool(before.strip()))
            )
    return found


def _beside(source: Source, file: Source) -> list[Comment]:
    """The comments of a file beside the source; a place holds until the next one."""
    found, place = [], -1
    for line, text in enumerate(file.text.split("\n"), 1):
        match = _BESIDE.fullmatch(text.strip())
        assert match is not None
        where = f"{file.path}:{line}"
        if printed := match["place"].strip():
            place = _place(source, printed, where)
        if match["mark"]:
            if place < 0:
                raise SourceError(f"{where}: say first of what: a label, or words in quotes")
            found.append(Comment(match["words"].strip(), file.path, line, place))
    return found


def _place(source: Source, printed: str, where: str) -> int:
    """The only place of a label, or of words in quotes, in a source."""
    quoted = _QUOTED.fullmatch(printed)
    words = map(re.escape, quoted[1].split()) if quoted else ()
    label = rf"\\label\s*\{{\s*{re.escape(printed)}\s*\}}"
    pattern = r"[\s~]+".join(words) if quoted else label
    places = [match.start() for match in re.finditer(pattern, source.visible) if match[0]]
    if len(places) == 1:
        return places[0]
    what = f"the words {printed}" if quoted else f"the label {printed}"
    if not places:
        raise SourceError(f"{where}: {source.path} has not {what}")
    lines = ", ".join(str(source.line(place)) for place in places)
    raise SourceError(f"{where}: {source.path} has {what} several times, in the lines {lines}")


def comments_on(
    source: Source, comments: Sequence[Comment], intervals: Sequence[tuple[int, int]]
) -> dict[int, list[Comment]]:
    """The comments on formulas, by their numbers; the formulas are given by their intervals."""
    starts = [start for start, _ in intervals]
    found: dict[int, list[Comment]] = {}
    for comment in comments:
        behind = bisect_left(starts, comment.offset + 1)
        last = behind - 1
        line = source.text.rfind("\n", 0, comment.offset) + 1
        reach = line if comment.trailing else comment.offset + 1
        number = last if last >= 0 and intervals[last][1] >= reach else behind
        if number < len(intervals):
            found.setdefault(number, []).append(comment)
    return found
