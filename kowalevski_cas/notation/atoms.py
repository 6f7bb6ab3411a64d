"""The atoms of the grammar: numbers, brackets, roots, operators, matrices."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

from kowalevski_cas.notation.cursor import END, Piece
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import (
    Application,
    Commutator,
    Constant,
    CrossProduct,
    Diagonal,
    ImaginaryPart,
    Modulus,
    Number,
    PoissonBracket,
    Quotient,
    Radical,
    RealPart,
    Root,
    ScalarProduct,
    Summation,
    Unwritten,
    Vector,
)
from kowalevski_cas.notation.macros import PARTNERS
from kowalevski_cas.notation.symbols import Symbols
from kowalevski_cas.notation.values import rank
from kowalevski_cas.notation.vocabulary import MATRIX, SCALAR, VECTOR

_LONGEST_NUMBER = 1000
_NORM = re.compile(r"(?:\\left\s*)?\\(?:\||l?Vert)")
DETERMINANT = r"\det"
_SIGNS = frozenset({"sign", "relation"})
_BEFORE_DOTS = _SIGNS | {"comma", "cell", "row", "open", "{", "begin", END}
_BEHIND_DOTS = _SIGNS | {"comma", "cell", "row", "close", "}", "end", END}


class Atoms(Symbols):
    """Reads one atom at a time, by the kind of its first token."""

    def factor(self) -> Piece:
        """An atom with its powers and primes."""
        self.deeper()
        kind = self.tokens[self.at].kind
        if kind == "letter":
            piece = self.symbol()
        elif self.starts() or kind == "bar":
            piece = getattr(self, "read_" + kind)()
        else:
            raise self.unexpected()
        self.level -= 1
        return piece

    def read_number(self) -> Piece:
        """A non-negative number; a decimal is a fraction."""
        token = self.take()
        start, end = token.start, token.end
        if len(token.text) > _LONGEST_NUMBER:
            raise self.error(f"a number of more than {_LONGEST_NUMBER} digits", token)
        value = Fraction(token.text) if "." in token.text else int(token.text)
        parts = [Number(value.numerator), Number(value.denominator)]
        if value.denominator == 1:
            return self.scripts((parts[0], start, end, ()))
        below = tuple((part, start, end, ()) for part in parts)
        return self.scripts((Quotient(*parts), start, end, below))

    def read_open(self) -> Piece:
        """Brackets, with what stands on them."""
        return self.scripts(self.column(self.bracket()))

    def column(self, piece: Piece) -> Piece:
        """A vector that is listed as a row, and said to be a column: it is the same vector."""
        if not isinstance(piece[0], Vector) or not self.takes_transposed():
            return piece
        return (piece[0], piece[1], self.tokens[self.at - 1].end, piece[3])

    def read_bar(self) -> Piece:
        """A number between bars."""
        start, outer, first = self.take().start, self.barred, self.at
        self.barred = True
        inner = self.sum()
        self.barred = outer
        nested = any(token.kind == "bar" for token in self.tokens[first : self.at])
        self.close("bar")
        if nested and self.starts():
            raise self.error(r"which bars belong together? print \left| and \right|")
        return self.scripts(self.modulus(inner, start))

    def modulus(self, inner: Piece, start: int) -> Piece:
        """An absolute value, a length, or the determinant of a matrix."""
        whole = rank(inner[0], self.vocabulary)
        if whole == SCALAR and _NORM.match(self.tex, start):
            message = "the norm of a number? print |x|, or the vector in bold"
            raise NotationError(message, self.tex, start)
        node = Application(DETERMINANT, (inner[0],)) if whole == MATRIX else Modulus(inner[0])
        return (node, start, self.tokens[self.at - 1].end, (inner,))

    def read_sum(self) -> Piece:
        """A sum over an index, between limits that are printed."""
        sign, limits = self.take(), dict[str, Piece]()
        index, outer = "", self.bound
        while (kind := self.tokens[self.at].kind) in ("_", "^") and kind not in limits:
            self.at += 1
            if kind == "_":
                first = self.tokens[self.at : self.at + 3]
                if [token.kind for token in first[:2]] != ["{", "letter"] or first[-1].text != "=":
                    break
                index = first[1].text
                self.at += 3
                limits[kind] = self.sum()
                self.close("}")
            else:
                limits[kind] = self.argument()
        if len(limits) < 2:
            raise self.error(r"print where the sum begins and ends, as in \sum_{i=1}^{3}", sign)
        self.bound = (*outer, index)
        body = self.term()
        self.bound = outer
        below = (limits["_"], limits["^"], body)
        node = Summation(index, *(piece[0] for piece in below))
        return (node, sign.start, body[2], below)

    def read_product(self) -> Piece:
        """A product over an index is written out before, where that can be done."""
        raise self.error(r"a product over an index stands in a display of its own: write it out")

    def read_const(self) -> Piece:
        """The word const, to which a chain of equalities comes in the end."""
        before, token = self.tokens[self.at - 1], self.take()
        if self.at < 2 or before.kind != "relation" or self.tokens[self.at].kind != END:
            raise self.error("the word const stands at the end of an equation", token)
        return (Constant(), token.start, token.end, ())

    def read_dots(self) -> Piece:
        """An ellipsis, in the place of terms or of a member."""
        before, token = self.tokens[self.at - 1].kind, self.take()
        behind = self.tokens[self.at].kind
        placed = before in _BEFORE_DOTS and behind in _BEHIND_DOTS
        if not placed or _SIGNS.isdisjoint((before, behind)):
            raise self.error("an ellipsis stands for terms, and for nothing else", token)
        return (Unwritten(), token.start, token.end, ())

    def read_sqrt(self) -> Piece:
        """A square root, or one of another order that is a number."""
        sign = self.take()
        order = int(sign.text[6:-1] or 2)
        if self.tokens[self.at].text == "[" or order < 2:
            raise self.error(r"print the order of a root as a number above 1: \sqrt[3]{x}", sign)
        argument = self.number(self.argument())
        end = self.tokens[self.at - 1].end
        node = Root(argument[0]) if order == 2 else Radical(argument[0], order)
        return self.scripts((node, sign.start, end, (argument,)))

    def read_list(self, braces: bool = False, pair: bool = False) -> tuple[Piece, ...]:
        r"""What stands between brackets, separated by commas; a pair may stand in braces.

        A longer list may, too, if ``braces`` are round ones there, as in \max\{a,b,c\}.
        """
        opening = self.take()
        items = [self.sum()]
        while self.tokens[self.at].kind == "comma":
            self.at += 1
            items.append(self.sum())
        closing = self.tokens[self.at]
        if closing.kind != "close":
            raise self.unexpected()
        if PARTNERS[opening.text] != closing.text:
            raise self.error(f"{opening.text} is closed by {closing.text}")
        paired = pair and len(items) == 2
        if opening.text == "[":
            ranks = {rank(item[0], self.vocabulary) for item in items}
            paired &= ranks in ({MATRIX}, {VECTOR})
        paired |= braces and opening.text == r"\{"
        if len(items) > 1 and opening.text in ("[", r"\{") and not paired:
            message = "a list in these brackets cannot be read; use round ones"
            if opening.text == "[":
                message += ", or print the entries of the matrices of a commutator"
            raise self.error(message, opening)
        self.at += 1
        return tuple(items)

    def bracket(self) -> Piece:
        """A formula in brackets, a product or Poisson bracket of two, or a vector."""
        opening = self.tokens[self.at]
        items = self.read_list(pair=True)
        start, end = opening.start, self.tokens[self.at - 1].end
        if len(items) == 1:
            if opening.text == r"\langle":
                raise self.error("what does a mean value mean here?", opening)
            if opening.text == r"\lvert":
                return self.modulus(items[0], start)
            inner, _, _, below = items[0]
            return (replace(inner, bracket=opening.text), start, end, below)
        nodes = tuple(item[0] for item in items)
        if opening.text == r"\{":
            return (PoissonBracket(nodes[0], nodes[1]), start, end, items)
        if opening.text == "[":
            node = CrossProduct if rank(nodes[0], self.vocabulary) == VECTOR else Commutator
            return (node(nodes[0], nodes[1], bracket="["), start, end, items)
        if len(nodes) == 2:
            ranks = [rank(node, self.vocabulary) for node in nodes]
            if ranks == [VECTOR, VECTOR]:
                return (ScalarProduct(nodes[0], nodes[1]), start, end, items)
            if ranks[0] != ranks[1]:
                raise self.error(
                    "a pair of a vector and something else: print both in bold, with components",
                    opening,
                )
        if opening.text not in ("(", r"\lgroup"):
            raise self.error("declare the vectors of this product, or use round brackets", opening)
        return (Vector(nodes), start, end, items)

    def read_operator(self) -> Piece:
        """Re, Im and diag."""
        token = self.take()
        if token.text == "diag":
            if self.tokens[self.at].kind != "open":
                raise self.unexpected()
            entries = self.read_list()
            node = Diagonal(tuple(entry[0] for entry in entries))
            return self.scripts((node, token.start, self.tokens[self.at - 1].end, entries))
        bracketed = self.tokens[self.at].kind == "open"
        argument = self.operand(token.text)
        if bracketed and self.tokens[self.at].kind in ("^", "prime"):
            raise self.error(f"does this stand on {token.text} or on the bracket? set brackets")
        part = RealPart if token.text == "Re" else ImaginaryPart
        return (part(argument[0]), token.start, argument[2], (argument,))

    def read_begin(self) -> Piece:
        """A matrix by its rows; a single row or column is a vector."""
        environment = self.take()
        start = environment.start
        rows: list[list[Piece]] = [[]]
        while self.tokens[self.at].kind != "end":
            kind = self.tokens[self.at].kind
            if kind == "row":
                rows.append([])
                self.at += 1
            elif kind == "cell":
                self.at += 1
                if not rows[-1] or self.tokens[self.at].kind in ("cell", "row", "end"):
                    raise self.error("an empty cell in a matrix")
            else:
                rows[-1].append(self.sum())
        rows = [row for row in rows if row]
        end = self.take().end
        if not rows or len({len(row) for row in rows}) > 1:
            raise self.error("the rows of the matrix differ in length", self.tokens[self.at - 1])
        if len(rows) == 1 or len(rows[0]) == 1:
            line = tuple(cell for row in rows for cell in row)
            return self.scripts((Vector(tuple(cell[0] for cell in line)), start, end, line))
        pieces: list[Piece] = [
            (Vector(tuple(cell[0] for cell in row)), row[0][1], row[-1][2], tuple(row))
            for row in rows
        ]
        piece = (Vector(tuple(p[0] for p in pieces)), start, end, tuple(pieces))
        return self.scripts(self.modulus(piece, start) if environment.text == "vmatrix" else piece)
