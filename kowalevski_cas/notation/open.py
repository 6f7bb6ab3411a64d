"""Formulas in which any letter is a name: what a system is made of is not declared beforehand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from kowalevski_cas.notation.cursor import Cursor, is_known, is_word
from kowalevski_cas.notation.formula import Name
from kowalevski_cas.notation.layout import statements
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.parser import Parser
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.notation.vocabulary import Vocabulary


class OpenParser(Parser):
    r"""Takes every letter for a scalar; bold type has to be declared, and so have macros and words.

    Each may be printed as a function of the time, if the vocabulary does not say which move.

    >>> from kowalevski_cas.notation.reader import read
    >>> read(r"\sigma x", Vocabulary(), OpenParser).factors
    (Name(name='\\sigma'), Name(name='x'))
    """

    def __init__(self, tex: str, tokens: list[Token], vocabulary: Vocabulary) -> None:
        found = [
            (letter, index)
            for letter, index in Cursor(tex, tokens, vocabulary).letters()
            if is_known(letter) and not symbol(letter).is_bold and not is_word(letter)
        ]
        names = {letter + more for letter, index in found for more in ("", index)}
        names -= {"d", *vocabulary.ranks}
        names -= {"e"} if is_exponential(tokens) else set()
        scalars = vocabulary.scalars | names - vocabulary.functions
        known = vocabulary.moving - vocabulary.vectors
        moving = vocabulary.moving if known else vocabulary.moving | scalars
        self.says_what_moves = bool(known) and not vocabulary.scalars <= known | vocabulary.times
        if scalars != vocabulary.scalars or moving != vocabulary.moving:
            vocabulary = replace(vocabulary, scalars=scalars, moving=moving)
        super().__init__(tex, tokens, vocabulary)

    lone_d = True

    def name_node(self, letter: str, index: str, token: Token) -> Name:
        """The node of a name; a d that belongs to no derivative is one."""
        if symbol(letter).is_bold and not {letter, letter + index} & {*self.vocabulary.ranks}:
            name = letter + index
            raise self.error(f"give its components: print {name}=(x,y,z) beside it", token)
        return Name("d" + index) if letter == "d" else super().name_node(letter, index, token)


def independent(tex: str) -> list[str]:
    r"""The variables by which a display derives, as t in :math:`\frac{dx}{dt}` and in dx/dt.

    >>> independent(r"\frac{d^2x}{d\tau^2}=-x, dy/d\tau=\frac{\partial H}{\partial x}")
    ['\\tau']
    """
    tokens = scan(tex)
    cursor = Cursor(tex, tokens, Vocabulary())
    found: dict[str, None] = {}
    for k, token in enumerate(tokens):
        below = k + 1
        if token.kind == "frac":
            if tokens[k + 1 + (tokens[k + 1].kind == "{")].text != "d":
                continue
            below = cursor.behind_group(k + 1) + 1
        elif token.kind != "slash":
            continue
        d, letter = [*tokens[below : below + 2], token, token][:2]
        if d.text == "d" and letter.kind == "letter":
            found[letter.text] = None
    return [*found]


def words_that_move(tex: str) -> list[str]:
    r"""The words that are differentiated: they are names.

    >>> words_that_move(r"\dot{\mathrm{Ca}}=\mathrm{Na},\ dx_{\rm ab}/dt=0")
    ['\\mathrm{Ca}']
    """
    tokens = [token for token in scan(tex) if token.kind != "{"]
    return [
        word.text
        for before, word in pairwise(tokens)
        if is_word(word.text) and (before.kind == "accent" or before.text == "d")
    ]


def bold_names(tex: str) -> list[str]:
    r"""The names in bold type in a display, for all values of indices with ranges.

    >>> bold_names(r"\dot{\bf r}_i={\bf r}_i\times\boldsymbol\omega, i=1,2")
    ['\\mathbf{r}_1', '\\boldsymbol{\\omega}', '\\mathbf{r}_2']
    """
    letters = (
        pair
        for statement in statements(tex)
        for pair in Cursor(tex, statement.tokens, Vocabulary()).letters()
    )
    return [*dict.fromkeys(letter + index for letter, index in letters if symbol(letter).is_bold)]


def matrices_by_use(tex: str) -> set[str]:
    r"""The bold capitals that are matrices: inverted, or right before a bold letter.

    >>> sorted(matrices_by_use(r"\mathbf M=\mathbf J\dot{\bf w}+\mathbf A^{-1}(\mathbf M-\bf n)"))
    ['\\mathbf{A}', '\\mathbf{J}']
    """
    tokens = scan(tex)
    found: set[str] = set()
    for k, token in enumerate(tokens):
        parts = symbol(token.text) if token.kind == "letter" else None
        if parts is None or not parts.is_bold or not parts.letter.isupper():
            continue
        behind = [
            following
            for following in tokens[k + 1 : k + 6]
            if following.kind not in ("accent", "{")
        ]
        inverse = [following.text for following in behind[:3]] == ["^", "-", "1"]
        if inverse or (behind and behind[0].kind == "letter" and symbol(behind[0].text).is_bold):
            found.add(token.text)
    return found


def is_exponential(tokens: Sequence[Token]) -> bool:
    """Whether the letter e is raised wherever it stands, and never to a number alone."""
    behind = (
        [t.kind for t in tokens[k + 1 : k + 5]] for k, t in enumerate(tokens) if t.text == "e"
    )
    return all(
        kinds[:1] == ["^"] and kinds[1:2] != ["number"] and kinds[1:] != ["{", "number", "}"]
        for kinds in behind
    )
