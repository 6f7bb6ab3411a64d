"""Words with mathematics between dollars, as runs of text and formulas."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from itertools import chain

from kowalevski_cas.notation.cursor import Cursor, Piece
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import Formula
from kowalevski_cas.notation.layout import printed_statements
from kowalevski_cas.notation.parser import Parser
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.notation.vocabulary import Vocabulary

_SHOWN = {"plusminus": "letter"}

Prose = tuple[str | Formula, ...]


class _InWords(Parser):
    """Reads what is only shown, and claims nothing."""

    def __init__(self, tex: str, tokens: list[Token], vocabulary: Vocabulary) -> None:
        shown = [Token(_SHOWN.get(t.kind, t.kind), t.text, t.start, t.end) for t in tokens]
        super().__init__(tex, shown, vocabulary)

    def refuse_mixed_ranks(self, pieces: list[Piece], message: str) -> None:
        """Words write vectors as they like."""


class _Loosened(_InWords):
    """Takes all letters for names: words speak of what no formula declares."""

    def __init__(self, tex: str, tokens: list[Token], vocabulary: Vocabulary) -> None:
        super().__init__(tex, tokens, vocabulary)
        found = Cursor(tex, self.tokens[:-1], vocabulary).letters()
        names = {letter + more for letter, index in found for more in ("", index)}
        scalars = vocabulary.scalars | (names - vocabulary.ranks.keys())
        functions = vocabulary.functions - names
        self.vocabulary = replace(vocabulary, scalars=scalars, functions=functions)
        self.names = self.vocabulary.names


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
    for parser in (_InWords, _Loosened):
        with suppress(NotationError):
            each = (parser(tex, tokens, vocabulary) for tokens in printed_statements(tex))
            if runs := [run for formula in each for run in (", ", formula.statement()[0])]:
                return tuple(runs[1:])
    return (f"${tex}$",)


def print_prose(
    prose: Prose, words: Callable[[str], str], formula: Callable[[Formula], str]
) -> str:
    """The runs of a text, each printed in its own way, side by side."""
    return "".join(words(run) if isinstance(run, str) else formula(run) for run in prose)
