"""Tokens of one statement to its tree, by recursive descent.

Where print can be read in two ways, the parser says so and does not choose.
"""

from __future__ import annotations

from kowalevski_cas.notation.cursor import END, Piece
from kowalevski_cas.notation.derivatives import Derivatives
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import (
    Constant,
    CrossProduct,
    Derivative,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    ScalarProduct,
    Sum,
    Unwritten,
)
from kowalevski_cas.notation.unicode import SIGNS
from kowalevski_cas.notation.values import applies, rank
from kowalevski_cas.notation.vocabulary import MATRIX, VECTOR

TALLEST = 150


class Parser(Derivatives):
    """Reads the tokens of one statement."""

    def statement(self) -> Piece:
        """A chain of relations, or an expression."""
        members = [self.sum()]
        signs: list[str] = []
        while (token := self.tokens[self.at]).kind == "relation":
            if token.text not in SIGNS:
                raise self.error(f"the relation {token.text} cannot be read")
            self.at += 1
            signs.append(token.text)
            members.append(self.sum())
        if self.tokens[self.at].kind != END:
            raise self.unexpected()
        piece = members[0]
        if signs:
            self.refuse_mixed_ranks(members, "a vector is set equal to a number")
            node = Relation(tuple([member[0] for member in members]), tuple(signs))
            piece = (node, piece[1], members[-1][2], tuple(members))
        # A tree is no taller than its tokens are many: short formulas need no measuring.
        if len(self.tokens) > TALLEST:
            self.measure(piece)
        return piece

    def measure(self, piece: Piece) -> None:
        """Refuse a tree on which recursion would not be safe."""
        waiting = [(piece, 1)]
        while waiting:
            (_, start, _, below), height = waiting.pop()
            if height > TALLEST:
                message = f"a formula nested deeper than {TALLEST}"
                raise NotationError(message, self.tex, start)
            waiting.extend((child, height + 1) for child in below)

    def sum(self) -> Piece:
        """Terms with their signs; a single term is no sum."""
        terms: list[Piece] = []
        while True:
            token = self.tokens[self.at]
            sign = ""
            if token.kind == "sign":
                self.at += 1
                sign = token.text
                second = self.tokens[self.at]
                if second.kind == "sign":
                    if not (terms and sign == "+" and second.text == "-"):
                        raise self.error("two signs in a row")
                    self.at += 1
                    sign, token = "-", second
            elif terms:
                break
            term = self.term()
            if sign == "-":
                term = (Negative(term[0]), token.start, term[2], (term,))
            terms.append(term)
        if len(terms) == 1:
            return terms[0]
        self.refuse_mixed_ranks(terms, "a vector and a number are added")
        return (Sum(tuple([term[0] for term in terms])), terms[0][1], terms[-1][2], tuple(terms))

    def term(self) -> Piece:
        """Factors side by side, with dots and crosses between them."""
        factors = self.factors()
        if self.tokens[self.at].kind != "times":
            return _product(factors)
        left_rank = self.rank(factors)
        multiplied = False
        while self.tokens[self.at].kind == "times":
            cross = self.take()
            before, behind = self.tokens[self.at - 2], self.tokens[self.at]
            broken = "\\\\" in self.tex[before.end : behind.start]  # a product over two rows
            plain = broken or "number" in (before.kind, behind.kind)
            more = self.factors()
            right_rank = self.rank(more)
            if left_rank == right_rank == VECTOR:
                if multiplied:
                    raise self.error("which vectors are multiplied first? set brackets", cross)
                left, right = _product(factors), _product(more)
                multiplied = True
                kind = CrossProduct if cross.text == r"\times" else ScalarProduct
                node: Formula = kind(left[0], right[0])
                factors = [(node, left[1], right[2], (left, right))]
                left_rank = self.rank(factors)
            elif VECTOR in (left_rank, right_rank) and cross.text == r"\times":
                raise self.error("a vector product of a vector and something else", cross)
            elif cross.text == r"\times" and not plain:
                raise self.error("a vector product? set the vectors in bold; else a dot", cross)
            elif multiplied and VECTOR in (left_rank, right_rank):
                raise self.error("which vectors are multiplied first? set brackets", cross)
            else:
                factors += more
                left_rank = VECTOR if VECTOR in (left_rank, right_rank) else left_rank | right_rank
        return _product(factors)

    def rank(self, factors: list[Piece]) -> int:
        """The rank of a product."""
        return rank(_product(factors)[0], self.vocabulary)

    def factors(self) -> list[Piece]:
        """Factors side by side; what stands before a slash is all divided by what follows."""
        factors = [self.factor()]
        divided = False
        while (slash := self.tokens[self.at].kind == "slash") or self.starts():
            if slash:
                self.at += 1
                left = _product(factors)
                right = self.under_slash(left)
                node = Quotient(left[0], right[0])
                factors = [(node, left[1], right[2], (left, right))]
                divided = True
            elif divided:
                break
            else:
                factors.append(self.beside(factors[-1]))
        vectors = [f for f in factors if len(factors) > 1 and self.rank([f]) == VECTOR]
        if len(vectors) > 1:
            message = "two vectors side by side: which product is meant? set a dot or a cross"
            raise NotationError(message, self.tex, vectors[1][1])
        if divided and (self.starts() or self.tokens[self.at].kind == "times"):
            raise self.error("does this stand under the slash? set brackets, or use \\frac")
        return factors

    def under_slash(self, left: Piece) -> Piece:
        r"""What stands under a slash: a factor, with the letters right behind it that end it.

        So :math:`p^2/2m` is no half of a product, and :math:`eB/mc` has two letters below; of
        :math:`1/2m` and :math:`g/l\,x` it is not known.
        """
        first = self.tokens[self.at]
        below = [self.number(self.factor())]
        alone = self.at
        if isinstance(left[0], Number) or (len(first.text) > 1 and first.kind != "number"):
            return below[0]
        while (token := self.tokens[self.at]).kind == "letter":
            between = self.tex[below[-1][2] : token.start]
            if between.strip() if first.kind == "number" else between or len(token.text) > 1:
                break
            below.append(self.factor())
        if first.kind != "number" and self.starts():
            self.at, below = alone, below[:1]
        return _product(below)

    def beside(self, left: Piece) -> Piece:
        """The factor behind another one, where the two are no function with its argument."""
        first, joined = self.tokens[self.at], self.tokens[self.at - 1].kind != "close"
        listed = first.kind == "open" and self.tokens[self.at + 1].kind != "begin"
        right = inner = self.factor()
        if isinstance(left[0], Number) and first.kind == "number":
            raise self.error("two numbers side by side; set a dot between them", first)
        raised = False
        while isinstance(inner[0], Power | Derivative) and inner[3][0][1] == first.start:
            raised, inner = True, inner[3][0]
        applied = joined and listed and applies(left[0], inner[0], raised)
        if applied and self.rank([left]) != MATRIX:
            name = self.tex[left[1] : left[2]]
            message = f"a product, or {name} at this argument? print a dot, or declare it"
            raise self.error(message, first)
        return right

    def refuse_mixed_ranks(self, pieces: list[Piece], message: str) -> None:
        """Refuse vectors beside numbers, but for a zero and what is not written."""
        ranks = [
            (self.rank([piece]) == VECTOR, piece)
            for piece in pieces
            if not isinstance(piece[0], Constant | Unwritten) and piece[0] != Number(0)
        ]
        for vector, piece in ranks:
            if vector != ranks[0][0]:
                raise NotationError(message, self.tex, piece[1])


def _product(factors: list[Piece]) -> Piece:
    """The factors as one piece; a single factor is no product."""
    if len(factors) == 1:
        return factors[0]
    nodes = tuple([factor[0] for factor in factors])
    return (Product(nodes), factors[0][1], factors[-1][2], tuple(factors))
