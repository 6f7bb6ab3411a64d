r"""Unit matrices that nothing defines: :math:`L-kE`, :math:`RR^{\mathsf T}=E`.

A letter E or I is one if multiples of it are added to matrices, or if one is equal to it, and if it
stands nowhere among numbers. Added by itself it may be a number as well.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from enum import Enum

from kowalevski_cas.notation import (
    Commutator,
    Derivative,
    Diagonal,
    Formula,
    Name,
    Negative,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    Transposed,
    Vector,
    Vocabulary,
    rank,
)
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.vocabulary import MATRIX, SCALAR

LETTERS = ("E", "I", r"\mathbb{E}", r"\mathbb{I}", r"\mathbf{E}", r"\mathbf{I}")


class _Place(Enum):
    """Where a name stands."""

    NUMBER = "where a number is expected"
    ADDED = "added to a matrix, as a number may be, too"
    MATRIX = "added to a matrix with another letter as a factor, or equal to a matrix"
    FACTOR = "beside a matrix, as a number may stand, too"


def unit_matrices(
    formulas: Collection[Formula],
    undefined: Collection[str],
    words: Vocabulary,
    vectors: Collection[int] = (),
) -> Iterator[str]:
    r"""The unit matrices among some names, as :math:`E=\operatorname{diag}(1,1)`.

    ``undefined`` are the names of which nothing says what they are, ``words`` know which names
    are matrices. Where no matrix is printed, they are of the size of all ``vectors``.

    Raises:
        ValueError: a name may stand for a number as well, or nothing says the size of the matrix.
    """
    for name in undefined:
        if symbol(name).head not in LETTERS:
            continue
        places = {one for formula in formulas for one in _places(formula, name, words)}
        is_number, is_matrix = _Place.NUMBER in places, _Place.MATRIX in places
        if is_matrix if is_number else not is_matrix and _Place.ADDED in places:
            raise ValueError(
                f"{name} may be a number, or the unit matrix: print 1 for the matrix, or "
                rf"{name}=\operatorname{{diag}}(1,\ldots) beside it; another letter for a number"
            )
        if is_matrix:
            yield f"{name}={_unit(_size(name, formulas, vectors))}"


def _unit(size: int) -> str:
    ones = ",".join("1" * size)
    return rf"\operatorname{{diag}}({ones})"


def _size(name: str, formulas: Collection[Formula], vectors: Collection[int]) -> int:
    """The number of rows of all matrices that are printed; else, of all vectors."""
    printed = [node for formula in formulas for node in formula.nodes()]
    sizes = {
        len(matrix.components)
        for matrix in printed
        if isinstance(matrix, Vector) and all(isinstance(row, Vector) for row in matrix.components)
    } | {len(matrix.entries) for matrix in printed if isinstance(matrix, Diagonal)}
    if (index := symbol(name).index).isdigit():
        sizes = {int(index)}
    sizes = sizes or {*vectors}
    if len(sizes) != 1:
        raise ValueError(
            rf"{name} is the unit matrix, and nothing says its size: print "
            rf"{name}=\operatorname{{diag}}(1,\ldots)"
        )
    return sizes.pop()


def _places(
    formula: Formula, name: str, words: Vocabulary, is_matrix: bool = False
) -> Iterator[_Place]:
    """Where a name stands in a formula, of which a matrix may be expected."""
    is_matrix = is_matrix or rank(formula, words) == MATRIX
    if formula == Name(name):
        yield _Place.ADDED if is_matrix else _Place.NUMBER
    elif isinstance(formula, Product) and Name(name) in formula.factors:
        others = [factor for factor in formula.factors if factor != Name(name)]
        yield _beside(others, words, is_matrix)
        yield from _in(others, name, words)
    elif isinstance(formula, Power | Quotient):
        base, other = formula.children()
        yield from _places(base, name, words, is_matrix)
        yield from _places(other, name, words)
    elif isinstance(formula, Relation):
        yield from _in_relation(formula, name, words)
    elif isinstance(formula, Sum | Negative | Derivative | Transposed | Commutator):
        yield from _in(formula.children(), name, words, is_matrix)
    else:
        yield from _in(formula.children(), name, words)


def _in(
    formulas: Collection[Formula], name: str, words: Vocabulary, are_matrices: bool = False
) -> Iterator[_Place]:
    for formula in formulas:
        yield from _places(formula, name, words, are_matrices)


def _beside(factors: Collection[Formula], words: Vocabulary, is_matrix: bool) -> _Place:
    """The place of a name among other factors of a product."""
    if any(rank(factor, words) != SCALAR for factor in factors):
        return _Place.FACTOR
    if is_matrix:
        return _Place.MATRIX if any(one.names() for one in factors) else _Place.ADDED
    return _Place.NUMBER


def _in_relation(formula: Relation, name: str, words: Vocabulary) -> Iterator[_Place]:
    """The places of a name in a relation; one that is given by its entries is no other thing."""
    ranks = [rank(member, words) for member in formula.members]
    if isinstance(formula.members[-1], Vector) and formula.members[0] == Name(name):
        yield _Place.NUMBER
        return
    pairs = zip(formula.members, ranks, strict=True)
    if MATRIX in ranks and any(name in one.names() and r != MATRIX for one, r in pairs):
        yield _Place.MATRIX
    yield from _in(formula.members, name, words, MATRIX in ranks)
