"""Formulas in which any letter is a name: what a system is made of is not declared beforehand."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation.cursor import Cursor
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import Name
from kowalevski_cas.notation.lexer import Token
from kowalevski_cas.notation.macros import GREEK
from kowalevski_cas.notation.parser import Parser
from kowalevski_cas.notation.vocabulary import Vocabulary


class OpenParser(Parser):
    r"""Takes every letter for a scalar; bold type has to be declared, and so have macros.

    Each may be printed as a function of the time, if the vocabulary does not say which move.

    >>> from kowalevski_cas.notation.reader import read
    >>> read(r"\sigma x", Vocabulary(), OpenParser).factors
    (Name(name='\\sigma'), Name(name='x'))
    """

    def __init__(self, tex: str, tokens: list[Token], vocabulary: Vocabulary) -> None:
        names = {*_names(Cursor(tex, tokens, vocabulary))} - {"d", *vocabulary.ranks}
        names -= {"e"} if _is_exponential(tokens) else set()
        scalars = vocabulary.scalars | names - vocabulary.functions
        moving = vocabulary.moving or scalars
        super().__init__(tex, tokens, replace(vocabulary, scalars=scalars, moving=moving))

    def declared(self, letter: str, index: str, token: Token) -> Name:
        """The node of a name; a d that belongs to no derivative is one."""
        return Name("d" + index) if letter == "d" else super().declared(letter, index, token)


def _is_exponential(tokens: list[Token]) -> bool:
    """Whether the letter e is raised wherever it stands, and never to a number."""
    behind = [
        [t.kind for t in tokens[k + 1 : k + 4]] for k, t in enumerate(tokens) if t.text == "e"
    ]
    return all(
        kinds[:1] == ["^"] and "number" not in (kinds[1:2] if kinds[1:2] != ["{"] else kinds[2:])
        for kinds in behind
    )


def _names(cursor: Cursor) -> Iterator[str]:
    """The letters of a statement with their indices."""
    while cursor.at < len(cursor.tokens):
        token = cursor.take()
        plain = token.text in GREEK or token.text.isalpha() or token.text.startswith(r"\mathrm{")
        if token.kind == "letter" and plain:
            yield token.text
            cursor.at += cursor.tokens[cursor.at].kind == "}"  # an accent covers no index
            if cursor.tokens[cursor.at].kind == "_":
                with suppress(NotationError):
                    yield token.text + cursor.index()
