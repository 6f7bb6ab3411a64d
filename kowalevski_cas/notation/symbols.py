"""Letters with all that stands on them, and the arguments of macros."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from contextlib import suppress

from kowalevski_cas.notation.cursor import Cursor, Piece
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import (
    Application,
    Conjugate,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Sum,
    Transposed,
)
from kowalevski_cas.notation.functions import EXTREMES, LETTERS, OF_A_MATRIX
from kowalevski_cas.notation.macros import GREEK, INSTEAD
from kowalevski_cas.notation.tokens import DEEPEST, Token
from kowalevski_cas.notation.values import is_rational, rank
from kowalevski_cas.notation.vocabulary import MATRIX, VECTOR

TRANSPOSED = frozenset({"T", r"\mathsf{T}", r"\mathrm{T}", r"\top", r"\intercal", "t"})
"""The marks of a transposed matrix."""
_SPACE = re.compile(r"\\[,;: ]|~")
_PI = r"\pi"
_DOTS = {r"\dot": 1, r"\ddot": 2, r"\dddot": 3, r"\ddddot": 4}


class _Scripts:
    """What stands on a letter: its index, primes and power, and where they end."""

    def __init__(self, name_end: int) -> None:
        self.name_end = name_end
        self.index = ""
        self.primes = self.primes_end = 0
        self.power: Piece | None = None
        self.transposed = False
        self.timed = False


class Symbols(Cursor):
    """Reads names, accents, primes, powers and arguments."""

    says_what_moves = True
    """Whether names that the vocabulary says to move do so, and others do not."""

    # What the parser reads further on.
    sum: Callable[[], Piece]
    term: Callable[[], Piece]
    factor: Callable[[], Piece]
    bracket: Callable[[], Piece]
    read_list: Callable[..., tuple[Piece, ...]]

    # Names

    def symbol(self, accents: tuple[str, ...] = (), start: int = -1, braces: int = 0) -> Piece:
        """A letter with its index, accents, primes and power; or a function and its argument."""
        token = self.take()
        if token.text == r"\nabla" and (gradient := self.gradient(token)) is not None:
            return gradient
        if token.text in INSTEAD and token.text not in self.names:
            raise self.error(INSTEAD[token.text], token)
        self.at += braces
        accents_end = self.tokens[self.at - 1].end
        on = self.scripts_on(token)
        name = token.text + on.index
        if name == "e" and on.power is not None and "e" not in self.names:
            return self.exponential(token, on, accents)
        if on.primes and self.is_applied(
            primed := name + "'" * on.primes
        ):  # as that of Weierstrass
            name, on.primes = primed, 0
        if name in LETTERS and self.is_free(name) and self.tokens[self.at].kind == "open":
            return self.application(LETTERS[name], token.start, on.power)
        if self.is_applied(name) and not (accents and self.is_factor(name)):
            return self.applied(name, token, on, bool(accents))
        if (primed := name + "'" * on.primes) in self.names:  # as k', which no motion derives
            piece: Piece = (self.names[primed], token.start, max(on.name_end, on.primes_end), ())
            on.primes = 0
        else:
            piece = (self.name_node(token.text, on.index, token), token.start, on.name_end, ())
        if accents:
            piece = _with_accents(piece, accents, start, max(on.name_end, accents_end))
        piece = _with_primes(piece, on.primes, on.primes_end)
        return self.with_scripts(piece, on)

    def with_scripts(self, piece: Piece, on: _Scripts) -> Piece:
        """A piece with the mark of a transposed matrix, or the power, that stands on it."""
        if on.transposed:
            return (Transposed(piece[0]), piece[1], self.tokens[self.at - 1].end, (piece,))
        return piece if on.power is None else self.with_power(piece, on.power)

    def scripts_on(self, token: Token) -> _Scripts:
        """All that stands on a letter and behind it."""
        on = _Scripts(token.end)
        while (kind := self.tokens[self.at].kind) in ("_", "^", "prime") or (
            not on.timed and self.at_time(token.text + on.index)
        ):
            if kind == "open":
                self.at += 3
                on.timed, on.name_end = True, self.tokens[self.at - 1].end
            elif kind == "_":
                if on.index:
                    raise self.error("a second index")
                on.index = self.index()
                on.name_end = self.tokens[self.at - 1].end
            elif self.vocabulary.rank(token.text + on.index) == MATRIX and self.takes_transposed():
                on.transposed = True
                break
            elif on.power is not None:
                raise self.error("two powers in a row; set brackets")
            elif kind == "prime":
                self.at += 1
                on.primes, on.primes_end = on.primes + 1, self.tokens[self.at - 1].end
            elif more := self.primes():
                on.primes, on.primes_end = on.primes + more, self.tokens[self.at - 1].end
            else:
                on.power = self.exponent()
        return on

    def gradient(self, token: Token) -> Piece | None:
        """The gradient by the only vector that moves; ``None`` if there are several, or none."""
        moving = [name for name in self.vocabulary.vectors if name in self.vocabulary.moving]
        if len(moving) != 1 or self.tokens[self.at].kind in ("^", "_", "times"):
            return None
        piece = self.number(self.operand(r"\nabla"))
        return (Partial(piece[0], moving[0]), token.start, piece[2], (piece,))

    def exponential(self, token: Token, on: _Scripts, accents: tuple[str, ...]) -> Piece:
        """The function exp, printed as a power."""
        if accents or on.primes:
            raise self.error("what is derived here? set brackets around the power of e", token)
        assert on.power is not None
        end = self.tokens[self.at - 1].end
        return (Application(r"\exp", (on.power[0],)), token.start, end, (on.power,))

    def at_time(self, name: str) -> bool:
        """Whether the time stands here in brackets, as the argument of a name that moves."""
        tokens, at = self.tokens, self.at
        return (
            tokens[at].text == "("
            and name in self.vocabulary.moving
            and tokens[at + 1].text in self.vocabulary.times
            and tokens[at + 2].text == ")"
        )

    def is_free(self, name: str) -> bool:
        """Whether nothing that is declared has a name."""
        return name not in self.names and name not in self.vocabulary.functions

    def is_applied(self, name: str) -> bool:
        """Whether a name is a function here, with an argument to follow."""
        if name not in self.vocabulary.functions:
            return False
        return self.upright(name) or self.tokens[self.at].kind == "open"

    def is_factor(self, name: str) -> bool:
        """Whether the bracket behind a rate is a factor: what is in it is more than an argument."""
        behind = self.tokens[self.at + 1 : self.at + 3]
        alone = behind[0].kind == "letter" and behind[-1].kind in ("close", "comma", "_")
        return name in self.vocabulary.moving and name in self.names and not alone

    def upright(self, name: str) -> bool:
        """Whether a name is a function that needs no brackets."""
        known = name in self.vocabulary.functions and name not in self.names
        return known and name[0] == "\\" and name not in GREEK

    def application(self, name: str, start: int, power: Piece | None) -> Piece:
        """A function's argument, which is a bracket or, after an upright name, one factor."""
        if power is not None and _may_be_inverse(power[0]):
            raise self.error(f"a negative power of the function {name} is ambiguous")
        opened = self.tokens[self.at].kind == "open"
        below = (
            self.read_list(name in EXTREMES) if opened else (self.phase() or self.operand(name),)
        )
        end = self.tokens[self.at - 1].end
        piece: Piece = (Application(name, tuple(b[0] for b in below)), start, end, below)
        if power is not None:
            return (Power(piece[0], power[0]), start, end, (piece, power))
        return self.scripts(piece) if opened else piece

    def applied(self, name: str, token: Token, on: _Scripts, accented: bool) -> Piece:
        r"""A function with its argument; with primes, as in :math:`V'(q)`, derived by it.

        Beside another time than t primes at a time are derivatives by that. At a number, as in
        :math:`V''(0)`, the derivative is a function with these primes.
        """
        start = token.start
        if not (on.primes or accented):
            return self.application(name, start, on.power)
        derived = not accented and on.power is None
        if derived and self.is_at_number():
            return self.application(name + "'" * on.primes, start, None)
        by = self.named_argument() if derived else ""
        times = self.vocabulary.times
        if not by or not (by not in times or times <= {"t", by}):
            message = f"by what is {name} derived? print \\partial {name}/\\partial x"
            raise self.error(message, token)
        piece, power = self.application(name, start, None), None
        if isinstance(piece[0], Power):  # of the derivative, and not of what is derived
            piece, power = piece[3]
        for _ in range(on.primes):
            piece = (Partial(piece[0], by), start, piece[2], (piece,))
        return self.scripts(piece if power is None else self.with_power(piece, power))

    def named_argument(self) -> str:
        """The name in brackets that stands here alone, as an argument by which is derived."""
        argument = self.only_argument()
        named = isinstance(argument, Name) and argument.name != _PI
        return argument.name if named and isinstance(argument, Name) else ""

    def is_at_number(self) -> bool:
        r"""Whether a number in brackets stands here alone, as :math:`0` or :math:`-\pi/2`."""
        argument = self.only_argument()
        return argument is not None and argument.names() <= {_PI}

    def only_argument(self) -> Formula | None:
        """What stands here alone in brackets; ``None``, and no move, for anything else."""
        start, level = self.at, self.level
        try:
            listed = self.read_list()
        except NotationError:
            return None
        finally:
            self.at, self.level = start, level
        return listed[0][0] if len(listed) == 1 else None

    def phase(self) -> Piece | None:
        r"""Constants and what moves: \cos\omega t, \sin k(x-ct); ``None``, and no move, else.

        Of what else stands side by side behind a function it cannot be seen how far it reaches.
        """
        start, level, factors = self.at, self.level, list[Piece]()
        with suppress(NotationError):
            while self.starts() and not self.ends_argument(self.tokens[self.at]):
                factors.append(self.factor())
        *before, last = [factor[0] for factor in factors] or [Number(0)]
        moving = self.vocabulary.times
        if self.says_what_moves:
            moving |= self.vocabulary.moving
        moves = isinstance(last, Name | Sum) and not last.names().isdisjoint(moving)
        moves = moves and not _is_bent(last) and not self.is_apart(factors[-2:])
        if before and moves and all(node.names().isdisjoint(moving) for node in before):
            return (Product((*before, last)), factors[0][1], factors[-1][2], tuple(factors))
        self.at, self.level = start, level
        return None

    def is_apart(self, factors: Sequence[Piece]) -> bool:
        """Whether a space stands before the last of two factors, and this is not the time."""
        (_, _, end, _), (last, start, *_) = factors[0], factors[-1]
        spaced = _SPACE.search(self.tex[end:start]) is not None
        return spaced and last.names().isdisjoint(self.vocabulary.times)

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
        piece = _with_accents(argument, (accents[0],), start, self.tokens[self.at - 1].end)
        return self.scripts(piece)

    # Scripts and arguments

    def scripts(self, piece: Piece) -> Piece:
        """Primes and one power on anything but a letter."""
        while (kind := self.tokens[self.at].kind) in ("_", "^", "prime"):
            if kind == "_":
                raise self.error("an index stands on something that is not a letter")
            if kind == "prime":
                self.at += 1
                piece = _with_primes(piece, 1, self.tokens[self.at - 1].end)
            elif rank(piece[0], self.vocabulary) == MATRIX and self.takes_transposed():
                end = self.tokens[self.at - 1].end
                piece = (Transposed(piece[0]), piece[1], end, (piece,))
            elif more := self.primes():
                piece = _with_primes(piece, more, self.tokens[self.at - 1].end)
            else:
                power = self.exponent()
                if self.tokens[self.at].kind in ("^", "prime"):
                    raise self.error("two powers in a row; set brackets")
                return self.with_power(piece, power)
        return piece

    def takes_transposed(self) -> bool:
        """Whether the mark of a transposed matrix is raised here; it is behind then."""
        raised = [token.text for token in self.tokens[self.at : self.at + 4]]
        braces = raised[1:2] == ["{"]
        mark = raised[1 + braces : 2 + braces]
        if raised[0] != "^" or not {*mark} & TRANSPOSED or (braces and raised[3:] != ["}"]):
            return False
        self.at += 2 + 2 * braces
        return True

    def number(self, piece: Piece) -> Piece:
        """The piece, which must be no vector."""
        if rank(piece[0], self.vocabulary) == VECTOR:
            raise NotationError("a number is expected here, not a vector", self.tex, piece[1])
        return piece

    def with_power(self, piece: Piece, power: Piece) -> Piece:
        """A power; it ends here, and behind the piece."""
        if power[0] != Number(2):  # the square of a vector is that of its length
            self.number(piece)
        end = max(piece[2], self.tokens[self.at - 1].end)
        return (Power(piece[0], power[0]), piece[1], end, (piece, power))

    def exponent(self) -> Piece:
        """What stands behind the sign of a power; a name in brackets there is no power."""
        self.script()
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
            return (self.name_node(token.text, "", token), token.start, token.end, ())
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
        token = self.tokens[self.at]
        named = operator in self.vocabulary.functions  # a derivative may reach over functions
        function = named and self.ends_argument(token)
        if is_rational(piece[0]) and token.kind == "letter" and not function:
            other = self.factor()  # as in \sin 2x, and \sin\frac12x
            piece = (Product((piece[0], other[0])), piece[1], other[2], (piece, other))
            token = self.tokens[self.at]
            function = named and self.ends_argument(token)
        function = function or (named and self.stands_apart(piece[0], token))
        while operator in OF_A_MATRIX and rank(piece[0], self.vocabulary) == MATRIX:
            factor = self.next_matrix()  # as in \mathrm{tr} LQ
            if factor is None:
                break
            below = (piece, factor)
            piece = (Product((piece[0], factor[0])), piece[1], factor[2], below)
            token = self.tokens[self.at]
        if token.kind == "slash" or (self.starts() and not function):
            raise self.error(f"how far does {operator} reach? set brackets")
        return piece

    def next_matrix(self) -> Piece | None:
        """The matrix that stands right behind another one; ``None``, and no move, if none does."""
        start, level = self.at, self.level
        if self.starts():
            factor = self.factor()
            if rank(factor[0], self.vocabulary) == MATRIX:
                return factor
        self.at, self.level = start, level
        return None

    def stands_apart(self, argument: Formula, token: Token) -> bool:
        r"""Whether a space ends a letter as the argument, as in \sin\theta\,(a-b); not before t.

        Behind what moves a bracket does so of which no phase is made: \sin\theta(1-\cos\theta).
        """
        if isinstance(argument, Name) and token.kind == "open" and self.may_move(argument.name):
            if self.is_before_bent():
                return True
        gap = self.tex[self.tokens[self.at - 1].end : token.start]
        apart = token.text not in self.vocabulary.times and token.kind in ("open", "letter")
        return isinstance(argument, Name) and apart and _SPACE.search(gap) is not None

    def may_move(self, name: str) -> bool:
        """Whether a name moves, as far as the vocabulary says what does; no number does."""
        return name in self.vocabulary.moving if self.says_what_moves else name != _PI

    def is_before_bent(self) -> bool:
        """Whether functions or powers stand in the bracket that begins here, and no time."""
        start, level = self.at, self.level
        try:
            inside = self.factor()[0]
            return _is_bent(inside) and inside.names().isdisjoint(self.vocabulary.times)
        except NotationError:
            return False
        finally:
            self.at, self.level = start, level

    def ends_argument(self, token: Token) -> bool:
        """Whether no argument of a function goes on here: at another function, or at a rate."""
        return token.kind == "operator" or token.text in _DOTS or self.upright(token.text)


def _may_be_inverse(exponent: Formula) -> bool:
    r"""Whether a raised exponent may mark the inverse of a function, as no :math:`-2` does."""
    return isinstance(exponent, Negative) and not (
        isinstance(exponent.argument, Number) and exponent.argument.value > 1
    )


def _is_bent(formula: Formula) -> bool:
    """Whether functions or powers stand in a formula, as in no phase."""
    return any(isinstance(node, Application | Power) for node in formula.nodes())


def _with_accents(piece: Piece, accents: tuple[str, ...], start: int, end: int) -> Piece:
    """The piece under its accents, the outermost first."""
    for accent in reversed(accents):
        if accent == r"\overline":
            piece = (Conjugate(piece[0]), start, end, (piece,))
        else:
            for _ in range(_DOTS[accent]):
                piece = (Derivative(piece[0], "dot"), start, end, (piece,))
    return piece


def _with_primes(piece: Piece, primes: int, end: int) -> Piece:
    """The piece with its primes."""
    for _ in range(primes):
        piece = (Derivative(piece[0], "prime"), piece[1], max(end, piece[2]), (piece,))
    return piece
