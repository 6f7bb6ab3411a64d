"""A place in the tokens of a statement, and what every part of the grammar asks of it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from kowalevski_cas.notation.errors import NotationError, Undeclared
from kowalevski_cas.notation.formula import Formula, Name
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.macros import GREEK
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.tokens import DEEPEST, UNFINISHED, Token
from kowalevski_cas.notation.vocabulary import Vocabulary

# A node, the interval that printed it, and the pieces of its children.
Piece = tuple[Formula, int, int, tuple["Piece", ...]]

END = "end of formula"
# The kinds of tokens with which a factor can begin.
STARTS = frozenset(
    """letter number open frac sqrt accent operator const dots begin sum product""".split()
)
_INDEX = frozenset({"letter", "number", "sign", "comma", "star", "prime", "slash", "_"})


class Cursor:
    """The tokens, the place, the vocabulary; names, indices and errors."""

    def __init__(self, tex: str, tokens: list[Token], vocabulary: Vocabulary) -> None:
        last = tokens[-1].end if tokens else 0
        self.tex = tex
        self.tokens = [*tokens, Token(END, "", last, last)]
        self.at = 0
        self.level = 0
        self.vocabulary = vocabulary
        self.names = vocabulary.names
        self.bound: tuple[str, ...] = ()  # indices of sums that are being read
        self.barred = False  # whether a bar that stands here would close what a bar has opened

    def take(self) -> Token:
        """The token here; the place moves behind it."""
        token = self.tokens[self.at]
        self.at += 1
        return token

    def starts(self) -> bool:
        """Whether a factor begins here."""
        kind = self.tokens[self.at].kind
        return kind in STARTS or (kind == "bar" and not self.barred)

    def deeper(self) -> None:
        """Count one level of nesting."""
        self.level += 1
        if self.level > DEEPEST:
            raise self.error(f"a formula nested deeper than {DEEPEST}")

    def error(self, message: str, token: Token | None = None) -> NotationError:
        """An error at the token, or here."""
        return NotationError(message, self.tex, (token or self.tokens[self.at]).start)

    def unexpected(self) -> NotationError:
        """The error for a token with which nothing can be done here."""
        token = self.tokens[self.at]
        if token.kind == END:
            return self.error("the formula breaks off here")
        if token.kind == "stop" and self.tokens[self.at + 1].kind == "number":
            return self.error("write a zero before the decimal point")
        if token.kind == "relation":
            if self.at == 0 or self.tokens[self.at - 1].kind in UNFINISHED:
                return self.error(f"something is missing before {token.text}")
            return self.error(f"the relation {token.text} stands inside brackets or an argument")
        if token.kind == "plusminus":
            message = f"the sign {token.text} is that of two statements; read_display reads both"
            return self.error(message)
        return self.error(f"{token.text or token.kind} is not expected here")

    def digit(self) -> Token:
        """The first digit of the number here, for an argument without braces."""
        token = self.tokens[self.at]
        if len(token.text) == 1:
            return self.take()
        if token.text[1] == ".":
            raise self.error("does the decimal stand here as a whole? set braces", token)
        middle = token.start + 1
        self.tokens[self.at] = Token("number", token.text[1:], middle, token.end)
        return Token("number", token.text[0], token.start, middle)

    def script(self) -> None:
        r"""Move into an index or a power; of x^10 only the 1 is raised in print, and is no more.

        Of a function that was meant: :math:`\sin^23x` has the argument 3x.
        """
        on_function = self.tokens[self.at - 1].text in FUNCTIONS
        self.at += 1
        number = self.tokens[self.at]
        if number.kind == "number" and len(number.text) > 1 and not on_function:
            raise self.error(
                f"TeX puts {number.text[0]} there, and the rest on the line: set braces"
            )

    def behind_group(self, at: int) -> int:
        """The index behind the argument that begins at the given token."""
        depth = 0
        while self.tokens[at].kind != END:
            depth += {"{": 1, "}": -1}.get(self.tokens[at].kind, 0)
            at += 1
            if depth == 0:
                break
        return at

    def letters(self) -> Iterator[tuple[str, str]]:
        """The letters from here on, each with the index behind it, its accent, primes and power.

        The place is behind what was given last.
        """
        for at in range(self.at, len(self.tokens)):
            token, self.at = self.tokens[at], at + 1
            if token.kind != "letter":
                continue
            while self.tokens[self.at].kind in ("prime", "}"):
                self.at += 1
            if self.tokens[self.at].kind == "^":
                behind = self.behind_group(self.at + 1)
                self.at = behind if self.tokens[behind].kind == "_" else self.at
            index = ""
            if self.tokens[self.at].kind == "_":
                with suppress(NotationError):
                    index = self.index()
            yield token.text, index

    def index(self) -> str:
        """The index behind an underscore, in canonical LaTeX."""
        self.script()
        kind = self.tokens[self.at].kind
        if kind == "number":
            return "_" + self.take().text
        if kind in ("letter", "star", "sign"):
            text = self.take().text
        elif kind == "{":
            self.at += 1
            text = ""
            while self.tokens[self.at].kind in _INDEX:
                below = self.tokens[self.at].kind == "_"
                more = self.index() if below and text else self.take().text
                gap = " " if text[-1:].isalpha() and "\\" in text and more[:1].isalpha() else ""
                text += gap + more
            if not text or text[0] in "_'" or self.tokens[self.at].kind != "}":
                raise self.error("an index is a row of letters, digits and signs")
            self.at += 1
        else:
            raise self.unexpected()
        return "_" + text if len(text) == 1 else f"_{{{text}}}"

    def primes(self) -> int:
        """How many primes a raised argument consists of; 0 and no move if it is a power."""
        at = self.at + 1
        braced = self.tokens[at].kind == "{"
        at += braced
        first = at
        while self.tokens[at].kind == "prime":
            at += 1
        count = at - first
        if count and (not braced or self.tokens[at].kind == "}"):
            self.at = at + braced if braced else first + 1
            return count if braced else 1
        return 0

    def name_node(self, letter: str, index: str, token: Token) -> Name:
        """The node of a name; one bold type is as good as another."""
        name = letter + index
        found = Name(name) if name in self.bound else self.names.get(name)
        others = symbol(name).in_other_types() if found is None else ()
        for other in (other.name for other in others):
            found = found or self.names.get(other)
        if found is not None:
            return found
        vocabulary = self.vocabulary
        if letter in vocabulary.families and any(bound in index for bound in self.bound):
            return Name(name)
        if name in vocabulary.functions:
            raise self.error(f"the argument of the function {name} is missing", token)
        what = f"{name} is not declared" if is_known(letter) else f"the macro {name} is not known"
        if is_word(letter):
            what = f"the word {name} is no function that is known, and not declared"
        known = (*vocabulary.ranks, *vocabulary.functions)
        raise Undeclared(f"{what} here", self.tex, token.start, name, known)


def is_word(letter: str) -> bool:
    r"""Whether it is a word: an upright one of several letters, of which none is a name.

    >>> is_word(r"\mathrm{sgn}"), is_word(r"\sigma")
    (True, False)
    """
    return symbol(letter).font == r"\mathrm"


def is_known(letter: str) -> bool:
    r"""Whether it is a letter, whatever its type and accents, and no macro of another meaning.

    >>> is_known(r"\hat{\mathbf{x}}"), is_known(r"\hat{\sin}")
    (True, False)
    """
    inner = symbol(letter).letter
    return inner in GREEK or inner.isalpha()
