"""Tokens of letters, with the accents over them and the stars raised on them."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.tokens import Token

_STAR = r"(?: \^ (?:star|{ star }))?"
_INDEX = "(?: _ (?:[a-z]+|{ [^}]+ }))?"
_ONE_LETTER = re.compile(
    rf"(?:accent (?:{{ )*)*letter(?: }})*(?:{_STAR}{_INDEX}|{_INDEX}{_STAR})(?: prime)*"
)
"""The kinds of the tokens over which an accent can stand, for it stands over their letter."""


def set_over(accents: Sequence[str], letter: str) -> str:
    r"""A letter under accents, the outermost first.

    >>> set_over([r"\hat", r"\tilde"], "x")
    '\\hat{\\tilde{x}}'
    """
    for accent in reversed(accents):
        letter = f"{accent}{{{letter}}}"
    return letter


def set_accents(accents: Sequence[str], tokens: Sequence[Token], tex: str, start: int) -> None:
    r"""Set the accents of a group over its only letter, as in ``\hat{x_1}``; else an error.

    The word const under an arrow says that a vector is constant.
    """
    kinds = [token.kind for token in tokens]
    if kinds == ["const"] and [*accents] == [r"\vec"]:
        return
    if not _ONE_LETTER.fullmatch(" ".join(kinds)):
        raise NotationError(f"{accents[-1]} stands over one letter", tex, start)
    letter = tokens[kinds.index("letter")]
    letter.text = set_over(accents, letter.text)


def with_stars(tokens: list[Token]) -> list[Token]:
    """The tokens, with each star that is raised on a letter, or behind its index, in the letter."""
    if all(token.kind != "star" for token in tokens):
        return tokens
    found: list[Token] = []
    for token in tokens:
        found.append(token)
        kinds = [behind.kind for behind in found[-4:]]
        size = 4 if kinds == ["^", "{", "star", "}"] else 2 if kinds[-2:] == ["^", "star"] else 0
        if size and (letter := _letter_before(found, len(found) - size)) is not None:
            letter.text += f"^{found[-1 - (size == 4)].text}"
            del found[-size:]
            found[-1].end = token.end
    return found


def _letter_before(tokens: list[Token], end: int) -> Token | None:
    """The letter that ends there, perhaps in the braces of its accents or before its index."""
    at = end - 1
    begin = _opening_brace(tokens, at)
    if begin > 0 and tokens[begin - 1].kind == "_":
        at = begin - 2
    last = at
    while at > 0 and tokens[at].kind == "}":
        at -= 1
    letter = tokens[at] if at >= 0 else None
    if letter is None or letter.kind != "letter" or symbol(letter.text).star:
        return None
    for closing in range(at + 1, last + 1):  # each brace has an accent before it, and no other
        opening = _opening_brace(tokens, closing)
        between = {token.kind for token in tokens[opening:at]}
        if tokens[opening - 1].kind != "accent" or not between <= {"{", "accent"}:
            return None
    return letter


def _opening_brace(tokens: list[Token], at: int) -> int:
    """The index of the brace that is closed at an index; that index, if none is."""
    depth = 0
    for k in range(at, -1, -1):
        depth += {"}": 1, "{": -1}.get(tokens[k].kind, 0)
        if depth == 0:
            return k
    return at
