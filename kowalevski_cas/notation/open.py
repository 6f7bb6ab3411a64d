"""Formulas in which any letter is a name: what a system is made of is not declared beforehand."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation.cursor import BOLD, Cursor
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import Name
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.macros import GREEK
from kowalevski_cas.notation.parser import Parser
from kowalevski_cas.notation.tokens import Token
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
        known = vocabulary.moving - vocabulary.vectors
        moving = vocabulary.moving if known else vocabulary.moving | scalars
        super().__init__(tex, tokens, replace(vocabulary, scalars=scalars, moving=moving))

    lone_d = True

    def declared(self, letter: str, index: str, token: Token) -> Name:
        """The node of a name; a d that belongs to no derivative is one."""
        if letter.startswith(BOLD) and not {letter, letter + index} & {*self.vocabulary.ranks}:
            name = letter + index
            raise self.error(f"give its components: print {name}=(x,y,z) beside it", token)
        return Name("d" + index) if letter == "d" else super().declared(letter, index, token)


def independent(tex: str) -> list[str]:
    r"""The variables by which a display derives, as t in :math:`\frac{dx}{dt}` and in dx/dt.

    >>> independent(r"\frac{d^2x}{d\tau^2}=-x, dy/d\tau=\frac{\partial H}{\partial x}")
    ['\\tau']
    """
    tokens = scan(tex)
    parser = Parser(tex, tokens, Vocabulary()) if tokens else None
    found: dict[str, None] = {}
    for k, token in enumerate(tokens):
        below = k + 1
        if token.kind == "frac" and parser is not None:
            if tokens[k + 1 + (tokens[k + 1].kind == "{")].text != "d":
                continue
            below = parser.behind_group(k + 1) + 1
        elif token.kind != "slash":
            continue
        d, letter = [*tokens[below : below + 2], token, token][:2]
        if d.text == "d" and letter.kind == "letter":
            found[letter.text] = None
    return [*found]


def bold_names(tex: str) -> list[str]:
    r"""The names in bold type in a display.

    >>> bold_names(r"\dot{\bf r}={\bf r}\times\boldsymbol\omega_1")
    ['\\mathbf{r}', '\\boldsymbol{\\omega}_1']
    """
    cursor, found = Cursor(tex, scan(tex), Vocabulary()), dict[str, None]()
    while cursor.at < len(cursor.tokens):
        token = cursor.take()
        if token.kind == "letter" and token.text.startswith(BOLD):
            here = cursor.tokens[cursor.at].kind == "_"
            found[token.text + (cursor.index() if here else "")] = None
    return [*found]


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
        plain = token.text in GREEK or token.text.isalpha() or "{" in token.text
        if token.kind == "letter" and plain and not token.text.startswith(BOLD):
            yield token.text
            cursor.at += cursor.tokens[cursor.at].kind == "}"  # an accent covers no index
            if cursor.tokens[cursor.at].kind == "_":
                with suppress(NotationError):
                    yield token.text + cursor.index()
