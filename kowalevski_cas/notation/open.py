"""Formulas in which any letter is a name: what a system is made of is not declared beforehand."""

from __future__ import annotations

from kowalevski_cas.notation.formula import Name
from kowalevski_cas.notation.lexer import Token
from kowalevski_cas.notation.macros import GREEK
from kowalevski_cas.notation.parser import Parser


class OpenParser(Parser):
    r"""Takes every letter for a scalar; bold type has to be declared, and so have macros.

    >>> from kowalevski_cas.notation.reader import read
    >>> from kowalevski_cas.notation.vocabulary import Vocabulary
    >>> read(r"\sigma x", Vocabulary(), OpenParser).factors
    (Name(name='\\sigma'), Name(name='x'))
    """

    def declared(self, letter: str, index: str, token: Token) -> Name:
        """The node of a name."""
        name = letter + index
        declared = name in self.vocabulary
        if declared or not (letter in GREEK or letter.isalpha() or letter.startswith(r"\mathrm{")):
            return super().declared(letter, index, token)
        return Name(name)
