r"""Equations between columns that are printed by their entries, as one equation for each entry.

A column is one by its entries, a multiple of one, a sum of such, its derivative, and what
a matrix by its rows makes of one: :math:`\binom{\ddot x}{\ddot y}=-K\binom xy`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    Vector,
    Vocabulary,
    equal,
    times,
    total,
)
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.values import rank
from kowalevski_cas.notation.vocabulary import MATRIX, SCALAR
from kowalevski_cas.paper.matrices import Rows, matrix_times_column

Column = tuple[Formula, ...]


def equations_by_entries(
    formula: Formula, matrices: Mapping[str, Vector], words: Vocabulary
) -> Iterator[Formula]:
    """The equations between the entries of columns; none if a side is no column by its entries.

    ``matrices`` are names with what is printed of them, by rows. Zero may stand for zeros.

    Raises:
        Meaningless: the sizes do not fit.
    """
    if not (isinstance(formula, Relation) and formula.is_equality):
        return
    read = _Columns(matrices, words)
    columns = [read.column(one) for one in formula.members if one != Number(0)]
    sizes = {len(one) for one in columns}
    if len(sizes) != 1 or 0 in sizes:
        return
    zeros = (Number(0),) * sizes.pop()
    found = iter(columns)
    sides = [zeros if one == Number(0) else next(found) for one in formula.members]
    yield from (equal(*entries) for entries in zip(*sides, strict=True))


class _Columns:
    """The entries of columns, where some names stand for matrices by rows."""

    def __init__(self, matrices: Mapping[str, Vector], words: Vocabulary) -> None:
        self.matrices, self.words = matrices, words

    def column(self, formula: Formula) -> Column:
        """The entries of a column; none if it has no entries that are known."""
        match formula:
            case Vector(entries) if not any(isinstance(one, Vector) for one in entries):
                return entries
            case Negative(argument):
                return tuple(map(Negative, self.column(argument)))
            case Derivative(argument, mark):
                return tuple(Derivative(one, mark) for one in self.column(argument))
            case Quotient(above, below):
                return tuple(Quotient(one, below) for one in self.column(above))
            case Sum(terms):
                columns = [*map(self.column, terms)]
                if len({*map(len, columns)}) == 1:
                    return tuple(map(total, zip(*columns, strict=True)))
            case Product((*others, last)):
                return self.multiplied(others, self.column(last))
        return ()

    def multiplied(self, factors: list[Formula], column: Column) -> Column:
        """A column with numbers and matrices before it; none if another factor is there."""
        for factor in reversed(factors):
            if rows := self.rows(factor):
                column = column and matrix_times_column(rows, column)
            elif rank(factor, self.words) == SCALAR and not _may_be_matrix(factor):
                column = tuple(times(factor, one) for one in column)
            else:
                return ()
        return column

    def rows(self, formula: Formula) -> Rows:
        """The rows of a matrix that is printed by them; none of anything else."""
        printed = self.matrices.get(formula.name) if isinstance(formula, Name) else formula
        if not isinstance(printed, Vector) or rank(printed, self.words) != MATRIX:
            return ()
        return tuple(line.children() for line in printed.components)


def _may_be_matrix(factor: Formula) -> bool:
    """Whether a factor before a column may be a matrix that is nowhere printed by its rows."""
    match factor:
        case Name(name):
            letter = symbol(name).letter.lstrip("\\")
            return not letter[:1].islower() or letter == "sigma"
        case Power(base, exponent):
            return _may_be_matrix(base) or bool(exponent.names())
    return False
