"""The tokens of LaTeX source: what prints, and how far a group reaches."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.notation.errors import NotationError

DEEPEST = 100
BEGINNING = frozenset({"open", "{", "begin"})
ENDING = frozenset({"close", "}", "end"})

TOKEN = re.compile(
    r"""(?P<blank>[\s~]+|%[^\n]*|\\[,;:!\ ])
      | (?P<letter>[A-Za-z])
      | (?P<number>[0-9]+(?:\.[0-9]+)?)
      | (?P<row>\\\\\s*\*?(?:\s*\[\s*[-+]?[\d.]+\s*[a-z]{2}\s*\])?)
      | (?P<macro>\\(?:(?:operatorname|hspace|vspace|tag)\*|not=|[A-Za-z]+|.|$))
      | (?P<dots>\.\.\.)
      | (?P<mark>:=|=:|.)""",
    re.VERBOSE | re.DOTALL,
)
BRACE = re.compile(r"\\.|%[^\n]*|[{}]", re.DOTALL)
_SPACE = re.compile(r"(?:\s|%[^\n]*(?:\n|$))*")


class Token:
    """A thing that prints, or a break, with its interval in the source."""

    __slots__ = ("end", "kind", "start", "text")

    def __init__(self, kind: str, text: str, start: int, end: int) -> None:
        self.kind = kind
        self.text = text
        self.start = start
        self.end = end


UNFINISHED = frozenset("sign plusminus relation times slash open { comma cell row".split())
"""The kinds of tokens behind which a factor is missing."""


def bars_around(tokens: Sequence[Token]) -> list[int]:
    """The number of bars that are open at each token: behind a factor one closes, if it can."""
    found, opened, missing = list[int](), 0, False
    for token in tokens:
        opens = token.kind == "bar" and (missing or not opened)
        opened += opens - (token.kind == "bar" and not opens)
        found.append(opened)
        missing = opens or token.kind in UNFINISHED
    return found


def after_group(tex: str, at: int) -> int:
    """The position behind the group, or the single token, that begins here."""
    space = _SPACE.match(tex, at)
    assert space is not None
    at = space.end()
    if tex[at : at + 1] != "{":
        token = TOKEN.match(tex, at)
        return token.end() if token else at
    depth = 0
    for brace in BRACE.finditer(tex, at):
        depth += {"{": 1, "}": -1}.get(brace[0], 0)
        if depth == 0:
            return brace.end()
    raise NotationError("this brace is never closed", tex, at)
