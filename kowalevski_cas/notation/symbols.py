"""Letters with all that stands on them, and the arguments of macros."""

from __future__ import annotations

from abc import ABC, abstractmethod

from kowalevski_cas.notation.cursor import STARTS, Cursor, Piece
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import (
    Application,
    Conjugate,
    Derivative,
    Name,
    Negative,
    Number,
    Power,
)
from kowalevski_cas.notation.lexer import DEEPEST
from kowalevski_cas.notation.macros import GREEK
from kowalevski_cas.notation.values import rank
from kowalevski_cas.notation.vocabulary import VECTOR

_DOTS = {r"\dot": 1, r"\ddot": 2, r"\dddot": 3}


class Symbols(Cursor, ABC):
    """Reads names, accents, primes, powers and arguments."""

    @abstractmethod
    def sum(self) -> Piece:
        """A sum, which the parser reads."""

    @abstractmethod
    def factor(self) -> Piece:
        """An atom with its powers and primes, which the parser reads."""

    @abstractmethod
    def bracket(self) -> Piece:
        """A bracket, which the parser reads."""

    @abstractmethod
    def listed(self, pair: bool = False) -> tuple[Piece, ...]:
        """A list in brackets, which the parser reads."""

    # Names

    def symbol(self, accents: tuple[str, ...] = (), start: int = -1, braces: int = 0) -> Piece:
        """A letter with its index, accents, primes and power; or a function and its argument."""
        token = self.take()
        self.at += braces
        name_end, accents_end, primes_end = token.end, self.tokens[self.at - 1].end, 0
        index, primes, power = "", 0, None
        while (kind := self.tokens[self.at].kind) in ("_", "^", "prime"):
            if kind == "_":
                if index:
                    raise self.error("a second index")
                index = self.index()
                name_end = self.tokens[self.at - 1].end
            elif power is not None:
                raise self.error("two powers in a row; set brackets")
            elif kind == "prime":
                self.at += 1
                primes += 1
                primes_end = self.tokens[self.at - 1].end
            elif more := self.primes():
                primes += more
                primes_end = self.tokens[self.at - 1].end
            else:
                power = self.exponent()
        name = token.text + index
        if self.applied(name):
            if primes or accents:
                raise self.error(f"the derivative of the function {name} is ambiguous", token)
            return self.application(name, token.start, power)
        piece: Piece = (self.declared(token.text, index, token), token.start, name_end, ())
        if accents:
            piece = _accented(piece, accents, start, max(name_end, accents_end))
        piece = _primed(piece, primes, primes_end)
        return piece if power is None else self.powered(piece, power)

    def applied(self, name: str) -> bool:
        """Whether a name is a function here, with an argument to follow."""
        if name not in self.vocabulary.functions:
            return False
        upright = name not in self.names and name[0] == "\\" and name not in GREEK
        return upright or self.tokens[self.at].kind == "open"

    def application(self, name: str, start: int, power: Piece | None) -> Piece:
        """A function's argument, which is a bracket or, after an upright name, one factor."""
        if power is not None and isinstance(power[0], Negative):
            raise self.error(f"a negative power of the function {name} is ambiguous")
        opened = self.tokens[self.at].kind == "open"
        below = self.listed() if opened else (self.operand(name),)
        end = self.tokens[self.at - 1].end
        piece: Piece = (Application(name, tuple(b[0] for b in below)), start, end, below)
        if power is not None:
            return (Power(piece[0], power[0]), start, end, (piece, power))
        return self.scripts(piece) if opened else piece

    def read_accent(self) -> Piece:
        """Dots and bars; those on a single letter keep its index: dot{x}_1."""
        start, first = self.tokens[self.at].start, self.at
        accents: list[str] = []
        braces = 0
        while self.tokens[self.at].kind == "accent":
            accents.append(self.take().text)
            if self.tokens[self.at].kind == "{":
                braces += 1
                self.at += 1
        if len(accents) > DEEPEST:
            raise self.error(f"more than {DEEPEST} accents")
        behind = self.tokens[self.at + 1 : self.at + 1 + braces]
        if self.tokens[self.at].kind == "letter" and all(token.kind == "}" for token in behind):
            return self.symbol(tuple(accents), start, braces)
        self.at = first + 1
        argument = self.argument()
        piece = _accented(argument, (accents[0],), start, self.tokens[self.at - 1].end)
        return self.scripts(piece)

    # Scripts and arguments

    def scripts(self, piece: Piece) -> Piece:
        """Primes and one power on anything but a letter."""
        while (kind := self.tokens[self.at].kind) in ("_", "^", "prime"):
            if kind == "_":
                raise self.error("an index stands on something that is not a letter")
            if kind == "prime":
                self.at += 1
                piece = _primed(piece, 1, self.tokens[self.at - 1].end)
            elif more := self.primes():
                piece = _primed(piece, more, self.tokens[self.at - 1].end)
            else:
                power = self.exponent()
                if self.tokens[self.at].kind in ("^", "prime"):
                    raise self.error("two powers in a row; set brackets")
                return self.powered(piece, power)
        return piece

    def number(self, piece: Piece) -> Piece:
        """The piece, which must be no vector."""
        if rank(piece[0], self.vocabulary) == VECTOR:
            raise NotationError("a number is expected here, not a vector", self.tex, piece[1])
        return piece

    def powered(self, piece: Piece, power: Piece) -> Piece:
        """A power; it ends here, and behind the piece."""
        self.number(piece)
        end = max(piece[2], self.tokens[self.at - 1].end)
        return (Power(piece[0], power[0]), piece[1], end, (piece, power))

    def exponent(self) -> Piece:
        """What stands behind the sign of a power; a name in brackets there is no power."""
        self.at += 1
        bracket = self.tokens[self.at + (self.tokens[self.at].kind == "{")]
        piece = self.argument()
        if bracket.kind == "open" and isinstance(piece[0], Name | Number):
            raise self.error("is this a power? then it needs no brackets", bracket)
        return piece

    def argument(self) -> Piece:
        """A group in braces, or one digit, letter or macro without them."""
        token = self.tokens[self.at]
        if token.kind == "{":
            self.at += 1
            piece = self.sum()
            self.close("}")
            return piece
        if token.kind == "number":
            digit = self.digit()
            return (Number(int(digit.text)), digit.start, digit.end, ())
        if token.kind == "letter":
            self.at += 1
            return (self.declared(token.text, "", token), token.start, token.end, ())
        if token.kind in ("frac", "sqrt", "accent"):
            return self.factor()
        raise self.unexpected()

    def close(self, kind: str) -> None:
        """Move behind the closing token."""
        if self.tokens[self.at].kind != kind:
            raise self.unexpected()
        self.at += 1

    def operand(self, operator: str) -> Piece:
        """The bracket, or the single factor, that follows an operator."""
        if self.tokens[self.at].kind == "open":
            return self.bracket()
        piece = self.factor()
        following = self.tokens[self.at].kind
        if following == "slash" or (following in STARTS and following != "operator"):
            raise self.error(f"how far does {operator} reach? set brackets")
        return piece


def _accented(piece: Piece, accents: tuple[str, ...], start: int, end: int) -> Piece:
    """The piece under its accents, the outermost first."""
    for accent in reversed(accents):
        if accent == r"\overline":
            piece = (Conjugate(piece[0]), start, end, (piece,))
        else:
            for _ in range(_DOTS[accent]):
                piece = (Derivative(piece[0], "dot"), start, end, (piece,))
    return piece


def _primed(piece: Piece, primes: int, end: int) -> Piece:
    """The piece with its primes."""
    for _ in range(primes):
        piece = (Derivative(piece[0], "prime"), piece[1], max(end, piece[2]), (piece,))
    return piece
