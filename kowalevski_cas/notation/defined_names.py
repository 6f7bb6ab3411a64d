r"""What each statement of a display defines, read off its TeX before any name is declared.

Names are canonical, as the reader makes them. A member of a chain of equalities defines a name if
it is nothing but this name, a function with its arguments, or a bracket of two names.
"""

from __future__ import annotations

from contextlib import suppress
from functools import cache
from itertools import groupby
from typing import NamedTuple

from kowalevski_cas.notation.cursor import END, Cursor
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import EQUALITIES
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.layout import statements
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.tokens import BEGINNING, ENDING, Token
from kowalevski_cas.notation.vocabulary import Vocabulary

CLOSING = r"\}"
UNDECLARED = Vocabulary()


class DefinedNames(NamedTuple):
    """The names that a statement defines, those whose squares it gives, and if it has a matrix.

    Of ``multiples`` it gives a whole multiple, as of T in :math:`2T=v^2`, or the opposite.
    """

    names: tuple[str, ...]
    squares: tuple[str, ...]
    matrix: bool = False
    multiples: tuple[str, ...] = ()


@cache
def defined_names(tex: str) -> tuple[DefinedNames, ...]:
    r"""What each statement of a display defines; raises ``NotationError`` for broken TeX.

    >>> defined_names(r"H = \omega_1^2 - x \equiv h, \quad r^2 = x^2")[0].names
    ('H', 'h')
    >>> defined_names(r"({\bs \alpha}, {\bs \alpha}) = a^2")[0].squares
    ('a',)
    >>> defined_names(r"2T = v^2")[0].multiples
    ('T',)
    >>> [*defined_names(r"\varphi(s) = 4ms^2, \quad {\bf e}_1 = (1,0)")][1].names
    ('\\mathbf{e}_1',)
    """
    return tuple(_heads(tokens, tex) for tokens, _, _ in statements(tex))


def _heads(tokens: list[Token], tex: str) -> DefinedNames:
    """What one statement defines; what is no equality defines nothing."""
    signs = {token.text for token in tokens if token.kind == "relation"}
    if not signs <= EQUALITIES:
        return DefinedNames((), ())
    runs = groupby(tokens, key=lambda token: token.kind == "relation")
    members = [_Member(tex, [*run], UNDECLARED) for relation, run in runs if not relation]
    if len(members) < 2:
        return DefinedNames((), ())
    found = [member.read() for member in members]
    names = tuple(dict.fromkeys(name for name, square in found if name and not square))
    diagonal = any(member.tokens[0].text == "diag" for member in members)
    return DefinedNames(
        names,
        tuple(dict.fromkeys(name for name, square in found if name and square)),
        any(member.matrix() for member in members)
        or (diagonal and not any(symbol(name).is_bold for name in names)),
        tuple(filter(None, (member.multiple() for member in members))),
    )


class _Member(Cursor):
    """One member of a chain."""

    def read(self) -> tuple[str, bool]:
        """The name that the member is, and whether it is its square; no name if it is neither."""
        try:
            name = self.bracket() if self.here(r"\{") else self.name()
            if self.here("("):
                name += f"({self.list_of_names(')')})"
            power = self.tokens[self.at].kind == "^" and self.power()
        except NotationError:
            return "", False
        read = self.tokens[self.at].kind == END and power in (False, "2")
        return (name, power == "2") if read else ("", False)

    def multiple(self) -> str:
        """The name of which the member is a whole multiple, or the opposite; empty for none."""
        self.at = 1
        with suppress(NotationError):
            if self.tokens[0].kind == "number" or self.tokens[0].text == "-":
                name = self.name()
                return name if self.tokens[self.at].kind == END else ""
        return ""

    def matrix(self) -> bool:
        """Whether matrices by their rows make it up: no columns, no functions of matrices."""
        blocks: list[list[str]] = []
        depth = 0
        for k, token in enumerate(self.tokens[:-1]):
            depth -= token.kind in ENDING
            if token.kind == "begin" and not depth:
                blocks.append([self.tokens[k - 1].text, token.text])
            elif blocks and depth == 1:
                blocks[-1].append(token.kind)
            depth += token.kind in BEGINNING
        values = {"vmatrix", *FUNCTIONS}
        return bool(blocks) and all(
            {"row", "cell"} <= {*b} and values.isdisjoint(b) for b in blocks
        )

    def here(self, text: str) -> bool:
        """Whether this bracket opens here."""
        return self.tokens[self.at].kind == "open" and self.tokens[self.at].text == text

    def name(self) -> str:
        """A letter with its index."""
        if self.tokens[self.at].kind != "letter":
            raise self.unexpected()
        letter = self.take().text
        return letter + self.index() if self.tokens[self.at].kind == "_" else letter

    def argument(self) -> str:
        """A name, perhaps under a dot, as in L(q, dot{q})."""
        if self.tokens[self.at].text != r"\dot":
            return self.name()
        self.at += 1
        letter = self.in_braces()
        return rf"\dot{{{letter}}}" + (self.index() if self.tokens[self.at].kind == "_" else "")

    def bracket(self) -> str:
        """A bracket of names."""
        return rf"\{{{self.list_of_names(CLOSING)}\}}"

    def list_of_names(self, closing: str) -> str:
        """Names in brackets, with commas between them."""
        self.at += 1
        names = [self.argument()]
        while self.tokens[self.at].kind == "comma":
            self.at += 1
            names.append(self.argument())
        if self.take().text != closing:
            raise self.unexpected()
        return ",".join(names)

    def power(self) -> str:
        """What stands in a power of one sign."""
        self.at += 1
        return self.in_braces()

    def in_braces(self) -> str:
        """One sign, perhaps in braces."""
        braced = self.tokens[self.at].kind == "{"
        self.at += braced
        if self.tokens[self.at].kind == END:
            raise self.unexpected()
        text = self.take().text
        if braced and self.take().kind != "}":
            raise self.unexpected()
        return text
