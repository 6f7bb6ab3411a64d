"""Words with mathematics between dollars, as runs of text and formulas."""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from itertools import chain

from kowalevski_cas.notation.cursor import Piece
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import Formula
from kowalevski_cas.notation.layout import printed
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.parser import Parser
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.notation.vocabulary import Vocabulary

_SHOWN = {"plusminus": "letter"}
_INDEX = re.compile(r"_(?:\w|\{[^{}]{2,}\})")

Prose = tuple[str | Formula, ...]


class _InWords(Parser):
    """Reads what is only shown, and claims nothing."""

    def __init__(self, tex: str, tokens: list[Token], vocabulary: Vocabulary) -> None:
        """Both signs are one that is shown."""
        shown = [Token(_SHOWN.get(t.kind, t.kind), t.text, t.start, t.end) for t in tokens]
        super().__init__(tex, shown, vocabulary)

    def alike(self, pieces: list[Piece], message: str) -> None:
        """Words write vectors as they like."""


def read_prose(text: str, vocabulary: Vocabulary) -> Prose:
    """The runs of a text; what cannot be read stays as it is typed.

    >>> read_prose("for $x$ only", Vocabulary(frozenset({"x"})))
    ('for ', Name(name='x'), ' only')
    """
    parts = text.split("$")
    if len(parts) % 2 == 0:  # a dollar too many: none of them means mathematics
        return (text,)
    runs = (_formulas(part, vocabulary) if k % 2 else (part,) for k, part in enumerate(parts))
    return tuple(run for run in chain.from_iterable(runs) if run)


def _formulas(tex: str, vocabulary: Vocabulary) -> Prose:
    """The formulas between two dollars, with commas between them."""
    for loosened in (False, True):
        with suppress(NotationError):
            words = _loosened(tex, vocabulary) if loosened else vocabulary
            parsers = (_InWords(tex, tokens, words) for tokens in printed(scan(tex), tex))
            if runs := [run for one in parsers for run in (", ", one.statement()[0])]:
                return tuple(runs[1:])
    return (f"${tex}$",)


def _loosened(tex: str, vocabulary: Vocabulary) -> Vocabulary:
    """The vocabulary in which all letters are names: words speak of what no formula declares."""
    names = set()
    for token in scan(tex):
        if token.kind in ("letter", "plusminus"):
            index = _INDEX.match(tex, token.end)
            names |= {token.text, token.text + index[0]} if index else {token.text}
    scalars = vocabulary.scalars | (names - vocabulary.ranks.keys())
    return replace(vocabulary, scalars=scalars, functions=vocabulary.functions - names)


def print_prose(
    prose: Prose, words: Callable[[str], str], formula: Callable[[Formula], str]
) -> str:
    """The runs of a text, each printed in its own way, side by side."""
    return "".join(words(run) if isinstance(run, str) else formula(run) for run in prose)
