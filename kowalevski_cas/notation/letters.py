"""Tokens of letters, with the accents over them and the stars raised on them."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.symbol import is_frame, symbol
from kowalevski_cas.notation.tokens import Token

_STAR = r"(?: \^ (?:star|sign|{ (?:star|sign) }))?"
_INDEX = "(?: _ (?:[a-z]+|{ [^}]+ }))?"
_MARKS = frozenset({"star", "sign"})
"""The kinds of tokens that are no power where they are raised alone."""
_ONE_LETTER = re.compile(
    rf"(?:accent (?:{{ )*)*letter(?: }})*(?:{_STAR}{_INDEX}|{_INDEX}{_STAR})(?: prime)*"
)
"""The kinds of the tokens over which an accent can stand, for it stands over their letter."""


def _kinds(tokens: Sequence[Token]) -> list[str]:
    """The kinds of tokens, where the name of a frame that is raised is as a star."""
    found = [token.kind for token in tokens]
    for at, token in enumerate(tokens):
        if found[at] == "letter" and is_frame(token.text):
            if found[max(at - 1, 0)] == "^" or found[max(at - 2, 0) : at] == ["^", "{"]:
                found[at] = "star"
    return found


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
    kinds = _kinds(tokens)
    if kinds == ["const"] and [*accents] == [r"\vec"]:
        return
    if not _ONE_LETTER.fullmatch(" ".join(kinds)):
        raise NotationError(f"{accents[-1]} stands over one letter", tex, start)
    letter = tokens[kinds.index("letter")]
    letter.text = set_over(accents, letter.text)


def with_stars(tokens: list[Token]) -> list[Token]:
    r"""The tokens, with each star, plus or minus that is raised on a letter in the letter.

    It may stand behind the index. A sign right before a number, as in x^-1, may be meant to raise
    that too, and so may one on e. So is the name of a frame, as in
    :math:`\mathbf q^{\mathcal R}`.
    """
    if _MARKS.isdisjoint(_kinds(tokens)):
        return tokens
    found: list[Token] = []
    for token, behind in zip(tokens, [*tokens[1:], None], strict=True):
        found.append(token)
        size = _size_of_mark(_kinds(found[-4:]), behind)
        letter = _letter_before(found, len(found) - size) if size else None
        if letter is not None and (letter.text != "e" or found[-size + size // 2].kind == "star"):
            mark = found[-1 - (size == 4)]
            letter.text += f"^{{{mark.text}}}" if mark.kind == "letter" else f"^{mark.text}"
            del found[-size:]
            found[-1].end = token.end
    return found


def _size_of_mark(kinds: Sequence[str], behind: Token | None) -> int:
    """How many of the last tokens raise a mark, in braces or without; 0 if they do not."""
    if kinds[:2] == ["^", "{"] and kinds[2:3] and kinds[2] in _MARKS and kinds[3:] == ["}"]:
        return 4
    if kinds[-2:-1] != ["^"] or kinds[-1] not in _MARKS:
        return 0
    return 0 if kinds[-1] == "sign" and behind is not None and behind.kind == "number" else 2


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
    if letter is None or letter.kind != "letter" or symbol(letter.text).raised:
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
