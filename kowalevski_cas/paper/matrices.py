"""Matrices that are printed by their rows: sums, products, inverses, derivatives, determinants."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce

from kowalevski_cas.notation import (
    Application,
    Commutator,
    Derivative,
    Diagonal,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Transposed,
    Vector,
    to_latex,
    total,
)
from kowalevski_cas.notation.values import rank
from kowalevski_cas.notation.vocabulary import MATRIX
from kowalevski_cas.paper.functions import value_of
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.problem.space import Meaningless

Rows = tuple[tuple[Formula, ...], ...]


def is_matrix(formula: Formula, setting: Meaning) -> bool:
    """Whether a formula stands for a matrix."""
    return rank(formula, setting.texts.vocabulary) == MATRIX


def rows(formula: Formula, setting: Meaning, within: tuple[str, ...] = ()) -> Rows:
    """The entries of a matrix, in the operations of a space.

    Raises :class:`Meaningless` if there are none, or if one of the names ``within`` whose
    definition it stands is used in it.
    """

    def of(part: Formula) -> Rows:
        return rows(part, setting, within)

    match formula:
        case Name(name) if name in within:
            raise Meaningless(f"{name} is defined by itself", name)
        case Name(name) if name in setting.scene.definitions:
            return rows(setting.definition(name), setting, (*within, name))
        case Application() if formula.function not in OF_MATRICES:
            return of(value_of(formula, setting))
        case Vector(lines) if all(isinstance(line, Vector) for line in lines):
            return tuple(tuple(map(setting.plain, line.children())) for line in lines)
        case Diagonal(entries):
            return diagonal([*map(setting.plain, entries)])
        case Negative(argument):
            return _each(of(argument), Negative)
        case Derivative(argument, mark):
            return _each(of(argument), lambda entry: setting.plain(Derivative(entry, mark)))
        case Sum(terms) if any(is_matrix(term, setting) for term in terms):
            return reduce(_sum, as_matrices(terms, setting, within))
    return _multiply(formula, setting, of)


def by_rows(formula: Formula, setting: Meaning) -> bool:
    """Whether a matrix by its rows stands in a formula, or in the definition of a matrix there."""
    if isinstance(formula, Vector):
        return rank(formula, setting.texts.vocabulary) == MATRIX
    if isinstance(formula, Application) and is_matrix(formula, setting):
        return True
    if isinstance(formula, Transposed) or (
        isinstance(formula, Power) and isinstance(formula.exponent, Negative)
    ):
        return is_matrix(formula, setting)
    if isinstance(formula, Name) and is_matrix(formula, setting):
        place = setting.scene.definitions.get(formula.name)
        return place is not None and (
            place.heads.matrix or by_rows(setting.definition(formula.name), setting)
        )
    return any(by_rows(child, setting) for child in formula.children())


def as_matrices(
    formulas: Sequence[Formula],
    setting: Meaning,
    within: tuple[str, ...] = (),
    are_equal: bool = False,
) -> list[Rows]:
    """Several matrices; a number among them stands for a multiple of the unit matrix.

    Where they are said to be equal it has to be 0 or 1, as in :math:`RR^T=1`.
    """
    found = {
        k: rows(formula, setting, within)
        for k, formula in enumerate(formulas)
        if is_matrix(formula, setting) or (are_equal and formula not in (Number(0), Number(1)))
    }
    size = len(next(iter(found.values())))
    return [
        found[k] if k in found else diagonal([setting.plain(formula)] * size)
        for k, formula in enumerate(formulas)
    ]


def _multiply(formula: Formula, setting: Meaning, of: Callable[[Formula], Rows]) -> Rows:
    """The entries of what is made of matrices by multiplication, or is transposed."""
    match formula:
        case Commutator(left, right):
            first, second = product(of(left), of(right)), product(of(right), of(left))
            return _sum(first, _each(second, Negative))
        case Transposed(argument):
            return tuple(zip(*of(argument), strict=True))
        case Power(base, Number(0)):
            return diagonal([Number(1)] * len(of(base)))
        case Power(base, Number(exponent)):
            return reduce(product, [of(base)] * exponent)
        case Power(base, Negative(Number(exponent))) if exponent:
            return reduce(product, [inverse(of(base))] * exponent)
        case Quotient(above, below):
            divisor = setting.plain(below)
            return _each(of(above), lambda entry: Quotient(entry, divisor))
        case Product(factors) if any(is_matrix(factor, setting) for factor in factors):
            matrices = [of(factor) for factor in factors if is_matrix(factor, setting)]
            scalars = tuple(setting.plain(f) for f in factors if not is_matrix(f, setting))
            whole = reduce(product, matrices)
            return _each(whole, lambda entry: Product((*scalars, entry))) if scalars else whole
    raise Meaningless(f"{to_latex(formula)} is no matrix that is known here")


def sizes(matrix: Rows) -> tuple[int, int]:
    """The numbers of rows and columns."""
    return len(matrix), len(matrix[0])


def determinant(matrix: Rows) -> Formula:
    """The determinant, by minors of the first row; raises :class:`Meaningless` without one."""
    if len(matrix) != len(matrix[0]):
        raise Meaningless("the determinant of a matrix that is not square")
    if len(matrix) == 1:
        return matrix[0][0]
    # by minors and not by elimination, which would divide by entries that may vanish
    terms: list[Formula] = []
    for k, entry in enumerate(matrix[0]):
        if entry == Number(0):
            continue
        minor = determinant(tuple((*row[:k], *row[k + 1 :]) for row in matrix[1:]))
        term = Product((entry, minor))
        terms.append(Negative(term) if k % 2 else term)
    return total(terms)


def inverse(matrix: Rows) -> Rows:
    """The inverse, by minors over the determinant; raises :class:`Meaningless` without one."""
    whole, size = determinant(matrix), range(len(matrix))
    if len(matrix) == 1:
        return ((Quotient(Number(1), whole),),)

    def entry(i: int, k: int) -> Formula:
        # the adjugate is transposed: for the entry (i, k) row k and column i are left out
        rest = [row for n, row in enumerate(matrix) if n != k]
        minor = determinant(tuple((*row[:i], *row[i + 1 :]) for row in rest))
        if minor == Number(0):
            return minor
        return Quotient(Negative(minor) if (i + k) % 2 else minor, whole)

    return tuple(tuple(entry(i, k) for k in size) for i in size)


def trace(matrix: Rows) -> Formula:
    """The sum of the diagonal; raises :class:`Meaningless` without one."""
    if len(matrix) != len(matrix[0]):
        raise Meaningless("the trace of a matrix that is not square")
    return total(row[k] for k, row in enumerate(matrix))


OF_MATRICES = {r"\det": determinant, r"\mathrm{tr}": trace}
"""The functions of matrices."""


def diagonal(entries: Sequence[Formula]) -> Rows:
    """The matrix with this diagonal, and zeros beside it."""
    size = range(len(entries))
    return tuple(tuple(entries[i] if i == j else Number(0) for j in size) for i in size)


def _each(matrix: Rows, function: Callable[[Formula], Formula]) -> Rows:
    return tuple(tuple(map(function, row)) for row in matrix)


def _sum(left: Rows, right: Rows) -> Rows:
    if sizes(left) != sizes(right):
        raise Meaningless("matrices that differ in size are added")
    return tuple(tuple(map(Sum, zip(a, b, strict=True))) for a, b in zip(left, right, strict=True))


def matrix_times_column(matrix: Rows, column: Sequence[Formula]) -> tuple[Formula, ...]:
    """A matrix times a column; raises :class:`Meaningless` if their sizes do not fit."""
    if len(matrix[0]) != len(column):
        raise Meaningless("factors are multiplied whose sizes do not fit")
    return tuple(total(map(Product, zip(row, column, strict=True))) for row in matrix)


def product(left: Rows, right: Rows) -> Rows:
    """The product of two matrices."""
    columns = (matrix_times_column(left, column) for column in zip(*right, strict=True))
    return tuple(zip(*columns, strict=True))
