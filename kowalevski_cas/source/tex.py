r"""The tokens of TeX, and where in the file each of them comes from.

A run of ordinary characters is one token until somebody wants its first. Blanks behind a control
word are a token of their own, which TeX does not see; :func:`normal` leaves it out.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

PARAGRAPH = re.compile(r"\n[ \t\r]*\n")


class TypedToken(NamedTuple):
    """What is typed, and the interval of the file that it stands for."""

    text: str
    start: int = 0
    end: int = 0
    literal: bool = False
    """Whether it stands in the file as it is."""


def is_word(text: str) -> bool:
    r"""Whether it is a control word, as ``\alpha``, behind which blanks do not print."""
    return text[:1] == "\\" and (text[-1].isalpha() or text[-1] == "@")


def is_command(text: str) -> bool:
    r"""Whether it is a control word or a control sign, as ``\alpha`` and ``\,``."""
    return len(text) > 1 and text[0] == "\\"


@lru_cache(maxsize=64)
def pattern(active: str, at_is_letter: bool) -> re.Pattern[str]:
    """What matches the next token, where these characters are active."""
    chosen = re.escape(active)
    letters = "A-Za-z@" if at_is_letter else "A-Za-z"
    return re.compile(
        rf"\\(?:[{letters}]+|.)|\\|[ \t\r\n]+|[{{}}]|\$\$?|#+[1-9]?"
        + (rf"|[{chosen}]" if active else "")
        + rf"|[^\\{{}}$#\s{chosen}]+|\s",
        re.DOTALL,
    )


@lru_cache(maxsize=64)
def ordinary(active: str) -> re.Pattern[str]:
    """What matches text without any sign that TeX looks at, where these characters are active."""
    return re.compile(rf"[^\\{{}}$#{re.escape(active)}]+")


def normal(tokens: Iterable[TypedToken]) -> list[TypedToken]:
    """The tokens one character each, with single blanks, and none behind control words."""
    found: list[TypedToken] = []
    for token in tokens:
        if token.text.isspace():
            if not found or not (is_word(found[-1].text) or found[-1].text == " "):
                found.append(token._replace(text=" ", literal=False))
            if PARAGRAPH.search(token.text):
                found.append(token._replace(text=r"\par", literal=False))
        elif len(token.text) > 1 and token.text[0] not in "\\#$":
            found.extend(characters(token))
        else:
            found.append(token)
    return found


def characters(token: TypedToken) -> Iterator[TypedToken]:
    """The characters of a run, each where it stands."""
    for place, character in enumerate(token.text):
        if token.literal:
            yield TypedToken(character, token.start + place, token.start + place + 1, True)
        else:
            yield token._replace(text=character)


def source_of_tokens(tokens: Sequence[TypedToken]) -> str:
    """What one would type for some tokens."""
    pieces: list[str] = []
    for token in tokens:
        if pieces and is_word(pieces[-1]) and token.text[:1].isalpha():
            pieces.append(" ")
        pieces.append(token.text)
    return "".join(pieces)


def strip(tokens: Sequence[TypedToken]) -> list[TypedToken]:
    """The tokens without blanks around them, and without braces around all of them."""
    found = list(tokens)
    while found and found[0].text.isspace():
        found.pop(0)
    while found and found[-1].text.isspace():
        found.pop()
    return bare(found)


def bare(tokens: Sequence[TypedToken]) -> list[TypedToken]:
    """The tokens without a pair of braces around all of them."""
    if len(tokens) < 2 or tokens[0].text != "{" or tokens[-1].text != "}":
        return list(tokens)
    depth = 0
    for place, token in enumerate(tokens):
        depth += {"{": 1, "}": -1}.get(token.text, 0)
        if depth == 0 and place < len(tokens) - 1:
            return list(tokens)
    return list(tokens[1:-1])
