"""Derivatives that are printed as quotients, with a line or with a slash."""

from __future__ import annotations

from kowalevski_cas.notation.atoms import DETERMINANT, Atoms
from kowalevski_cas.notation.cursor import Piece
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import (
    Application,
    Derivative,
    Name,
    Partial,
    Product,
    Quotient,
    Vector,
)
from kowalevski_cas.notation.values import is_rational

_DIFFERENTIALS = ("d", r"\partial")


class Derivatives(Atoms):
    """Reads fractions, and which of them are derivatives."""

    lone_d = False
    """Whether a d that is no part of a derivative is a name."""

    def read_frac(self) -> Piece:
        """A fraction; over d and an independent variable it is a derivative."""
        written = self.read_derivative() or self.jacobian()
        if written is not None:
            return written
        start = self.take().start
        above, below = self.argument(), self.number(self.argument())
        end = self.tokens[self.at - 1].end
        return self.scripts((Quotient(above[0], below[0]), start, end, (above, below)))

    def read_derivative(self) -> Piece | None:
        r"""``\frac{dF}{d\tau}``, ``\frac{d}{d\tau}`` with what it is applied to; so too with ∂."""
        fraction = self.at
        start = self.tokens[fraction].start
        above = fraction + 1
        braced = self.tokens[above].kind == "{"
        d = self.tokens[above + braced].text
        if d not in _DIFFERENTIALS:
            return None
        below = self.behind_group(above)
        by = self.denominator(below, d)
        if not by:
            self.at = fraction
            return None
        behind = self.at
        self.at = above + braced + 1
        if self.order() != len(by):
            raise self.error("the orders above and below differ", self.tokens[fraction])
        applied = self.at == below - braced
        if applied:
            self.at = behind
            piece = self.differentiated(f"the derivative by {by[-1]}")
            if self.tokens[self.at].kind in ("^", "prime"):
                piece = self.scripts(piece)
            end = self.tokens[self.at - 1].end
        else:
            piece = self.term()
            if self.at != below - braced:
                raise self.unexpected()
            self.at = behind
            if d != "d":
                piece = self.at_arguments(piece, by)
            end = self.tokens[self.at - 1].end
        piece = _derivative(piece, d, by, start, end)
        return piece if applied else self.scripts(piece)

    def jacobian(self) -> Piece | None:
        r"""The determinant of the derivatives of some functions by as many variables.

        It is printed as :math:`\partial(f,g)/\partial(x,y)`, with a line; what a matrix is set
        equal to is the matrix of these derivatives.
        """
        start, listed = self.at, list[tuple[Piece, ...]]()
        self.at += 1
        for _ in range(2):
            texts = [token.text for token in self.tokens[self.at : self.at + 3]]
            if texts != ["{", r"\partial", "("]:
                self.at = start
                return None
            self.at += 2
            listed.append(self.read_list())
            self.close("}")
        functions, variables = listed
        names = [piece[0].name for piece in variables if isinstance(piece[0], Name)]
        if not len(names) == len(variables) == len(functions) > 1:
            raise self.error("as many functions as variables by which they are derived")
        rows = (Vector(tuple(Partial(one[0], name) for name in names)) for one in functions)
        matrix = Vector(tuple(rows))
        node = matrix if self.gives_matrix() else Application(DETERMINANT, (matrix,))
        return self.scripts(
            (node, self.tokens[start].start, self.tokens[self.at - 1].end, functions)
        )

    def gives_matrix(self) -> bool:
        """Whether a matrix follows behind an equals sign, and no determinant."""
        sign, *behind = self.tokens[self.at : self.at + 3]
        if behind and behind[0].text in ("(", "["):
            del behind[0]
        begins = bool(behind) and behind[0].kind == "begin"
        return sign.text == "=" and begins and "v" not in behind[0].text.lower()

    def differentiated(self, operator: str) -> Piece:
        """What a derivative is applied to; a number before it goes with it."""
        start, level = self.at, self.level
        if self.tokens[start].kind != "open":
            factor = self.factor()
            if is_rational(factor[0]) and self.starts():
                rest = self.operand(operator)
                if self.starts():
                    raise self.error(f"how far does {operator} reach? set brackets")
                return Product((factor[0], rest[0])), factor[1], rest[2], (factor, rest)
            self.at, self.level = start, level
        return self.operand(operator)

    def at_arguments(self, piece: Piece, by: list[str]) -> Piece:
        r"""A function at the names behind its derivative, as \frac{\partial H}{\partial p}(q,p)."""
        start, level, function = self.at, self.level, piece[0]
        if isinstance(function, Name) and self.is_applied(function.name):
            listed = self.read_list()
            names = tuple(one[0] for one in listed)
            if len(names) > 1 and {*by} <= {one.name for one in names if isinstance(one, Name)}:
                end = self.tokens[self.at - 1].end
                return (Application(function.name, names), piece[1], end, listed)
            self.at, self.level = start, level
        return piece

    def factor(self) -> Piece:
        """An atom with its powers and primes, or a derivative with a slash, as dx/dt."""
        token = self.tokens[self.at]
        if token.text not in _DIFFERENTIALS:
            return super().factor()
        indexed = self.tokens[self.at + 1].kind == "_"
        if token.text in self.names or (token.text == "d" and (self.lone_d or indexed)):
            if not (below := self.slash_derivative_begins()):
                return super().factor()
            if token.text in self.names and below not in self.vocabulary.times:
                raise self.error("a derivative, or the name d? print a fraction, or a dot", token)
        if indexed:
            return self.subscripted()
        if self.differential_begins():
            self.at += 1
            return Name("d"), token.start, token.end, ()
        self.at += 1
        order = self.order()
        piece = super().factor()
        if self.tokens[self.at].kind != "slash" or self.tokens[self.at + 1].text != token.text:
            d = token.text if token.text == "d" else rf"{token.text} "
            raise self.error(f"a derivative is expected here, as {d}x/{d}t", token)
        self.at += 2
        by = self.differential(token.text)
        if len(by) != order:
            raise self.error("the orders above and below differ", token)
        return _derivative(piece, token.text, by, token.start, self.tokens[self.at - 1].end)

    def subscripted(self) -> Piece:
        r"""A partial derivative by an index, as :math:`\partial_pH` and :math:`\partial_{q_1}V`."""
        start = self.tokens[self.at].start
        self.at += 2
        by: list[str] = []
        if self.tokens[self.at].kind == "{":
            self.at += 1
            while self.tokens[self.at].kind != "}" and (found := self.differential(r"\partial")):
                by += found
            self.close("}")
        elif self.tokens[self.at].text in self.vocabulary.ranks:
            by = [self.take().text]
        if not by:
            raise self.unexpected()
        by *= self.order()
        piece = self.factor()
        token = self.tokens[self.at]
        if token.kind == "slash" or (self.starts() and token.text != r"\partial"):
            raise self.error(f"how far does the derivative by {by[-1]} reach? set brackets")
        return _derivative(piece, r"\partial", by, start, self.tokens[self.at - 1].end)

    def differential_begins(self) -> bool:
        """Whether the differential of a time begins here, as in a change of the time."""
        letter = self.tokens[self.at + 1]
        time = letter.kind == "letter" and letter.text in self.vocabulary.times
        return self.tokens[self.at].text == "d" and time and not self.slash_derivative_begins()

    def slash_derivative_begins(self) -> str:
        """The letter by which a slash derives, where a derivative begins, as dx/dt; or nothing."""
        start, level = self.at, self.level
        try:
            self.at += 1
            self.order()
            super().factor()
            behind = self.tokens[self.at : self.at + 3]
            derives = [t.text for t in behind[:2]] == ["/", "d"] and behind[2].kind == "letter"
            return behind[2].text if derives else ""
        except NotationError:
            return ""
        finally:
            self.at, self.level = start, level

    def denominator(self, at: int, d: str) -> list[str]:
        """The variables in the denominator that begins at the token; none if it is no such one."""
        self.at, by = at + 1, list[str]()
        if self.tokens[at].kind != "{":
            return []
        while self.tokens[self.at].text == d:
            self.at += 1
            found = self.differential(d)
            if not found:
                return []
            by += found
        if self.tokens[self.at].kind != "}":
            return []
        self.at += 1
        return by

    def differential(self, d: str) -> list[str]:
        """The variable behind a d or a ∂, as often as its order says; none if it is none.

        Behind a d it is an independent variable; behind a ∂ it is any scalar or vector, or, under
        dots, a velocity.
        """
        dots = self.take().text if self.tokens[self.at].kind == "accent" else ""
        braced = bool(dots) and self.tokens[self.at].kind == "{"
        self.at += braced
        if self.tokens[self.at].kind != "letter" or (d == "d" and dots):
            return []
        letter, index = self.take().text, ""
        if self.tokens[self.at].kind == "_":
            index = self.index()
        if braced:
            self.close("}")
            index = index or (self.index() if self.tokens[self.at].kind == "_" else "")
        name = letter + index
        if name not in (self.vocabulary.times if d == "d" else self.vocabulary.ranks):
            return []
        return [f"{dots}{{{letter}}}{index}" if dots else name] * self.order()

    def order(self) -> int:
        """The order of a derivative, printed as a power: 1 without one, 0 if it is no number."""
        if self.tokens[self.at].kind != "^":
            return 1
        self.script()
        braced = self.tokens[self.at].kind == "{"
        self.at += braced
        if self.tokens[self.at].kind != "number":
            return 0
        digit = self.take()
        self.at += braced
        return int(digit.text) if len(digit.text) < 3 else 0


def _derivative(piece: Piece, d: str, by: list[str], start: int, end: int) -> Piece:
    """The derivative by the variables, the last one first."""
    node = Derivative if d == "d" else Partial
    for name in reversed(by):
        piece = (node(piece[0], name), start, end, (piece,))
    return piece
