"""Formulas as sequences of tokens: what is equal but for spaces, and how far apart two are."""

from __future__ import annotations

import re
from collections.abc import Iterator
from difflib import SequenceMatcher
from functools import lru_cache

from kowalevski_cas.notation import NotationError
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.tokens import Token

BREAKS = frozenset({"row", "cell", "gap", "comma", "stop"})
"""What may stand at either end of a formula and says nothing about it."""

_ROUGHLY = re.compile(r"\\(?:[A-Za-z]+|.)|\d+|\S", re.DOTALL)
_COMMAND = re.compile(r"\\[A-Za-z]+$")
_LONGEST = 400
"""Tokens that are compared one by one."""


@lru_cache(maxsize=4096)
def tokens_of(tex: str) -> tuple[Token, ...]:
    """The tokens of a formula without the breaks around it; none if it cannot be scanned."""
    try:
        tokens = scan(tex)
    except NotationError:
        return ()
    while tokens and tokens[-1].kind in BREAKS:
        tokens.pop()
    while tokens and tokens[0].kind in BREAKS:
        tokens.pop(0)
    return tuple(tokens)


@lru_cache(maxsize=4096)
def words(tex: str) -> tuple[str, ...]:
    """What the tokens of a formula print, whatever it is."""
    tokens = tokens_of(tex)
    if not tokens:
        return tuple(match[0] for match in _ROUGHLY.finditer(tex[:5000]))
    return tuple(token.text if token.kind != "row" else "\\\\" for token in tokens)


@lru_cache(maxsize=16384)
def likeness(one: str, other: str) -> float:
    """From 1 for the same tokens down to 0 for nothing in common."""
    first, second = words(one)[:_LONGEST], words(other)[:_LONGEST]
    matcher = SequenceMatcher(None, first, second, autojunk=False)
    return matcher.ratio() if matcher.quick_ratio() > 0.5 else 0.0


def changes(old: str, new: str) -> Iterator[tuple[int, int, str]]:
    """Intervals of ``old`` and what to type there so that it has the tokens of ``new``."""
    before, after = tokens_of(old), tokens_of(new)
    matcher = SequenceMatcher(
        None, [token.text for token in before], [token.text for token in after], autojunk=False
    )
    for kind, i, j, k, m in matcher.get_opcodes():
        if kind == "equal":
            continue
        typed = new[after[k].start : after[m - 1].end] if k < m else ""
        if i < j:
            yield before[i].start, before[j - 1].end, typed
        else:
            place = before[i - 1].end if i else before[0].start if before else 0
            yield place, place, set_apart(old[:place], typed, old[place : place + 1])


def set_apart(before: str, typed: str, after: str) -> str:
    """What is typed, with spaces where it would run into what stands around it."""
    left = " " if _COMMAND.search(before) and typed[:1].isalpha() else ""
    right = " " if _COMMAND.search(typed) and after[:1].isalpha() else ""
    return left + typed + right
