"""What a formula stands for: a scalar, a vector or a matrix, or perhaps a function."""

from __future__ import annotations

from kowalevski_cas.notation.formula import (
    Application,
    Conjugate,
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    Root,
    ScalarProduct,
    Sum,
    Vector,
)
from kowalevski_cas.notation.vocabulary import MATRIX, SCALAR, VECTOR, Vocabulary


def rank(formula: Formula, vocabulary: Vocabulary) -> int:
    r"""0 for a scalar, 1 for a vector, 2 for a matrix, as the vocabulary declares the names.

    A matrix times a vector is a vector; a matrix by its rows is a vector of vectors.
    """
    match formula:
        case Name(name):
            return vocabulary.ranks.get(name, SCALAR)
        case Number() | ScalarProduct() | Application():
            return SCALAR
        case Product(factors):
            ranks = {rank(factor, vocabulary) for factor in factors}
            return VECTOR if VECTOR in ranks else max(ranks)
        case Sum(terms):
            return max(rank(term, vocabulary) for term in terms)
        case Quotient(inner, _) | Power(inner, _):
            return rank(inner, vocabulary)
        case PoissonBracket(left, right):
            return max(rank(left, vocabulary), rank(right, vocabulary))
        case CrossProduct():
            return VECTOR
        case Vector(components):
            return min(MATRIX, VECTOR + rank(components[0], vocabulary))
        case Diagonal():
            return MATRIX
    # A sign, a root, a bar or a derivative changes nothing; a word is a scalar.
    return next((rank(inner, vocabulary) for inner in formula.children()), SCALAR)


def applies(left: Formula, right: Formula, raised: bool = False) -> bool:
    """Whether a formula, and another one in brackets behind it, look like a function of it.

    They do if the first is a name, with what stands on it, and a product would need no brackets.
    It needs those around a sum; and those that a power or a prime is ``raised`` on, around
    whatever is no name or number.
    """
    while isinstance(left, Derivative | Power | Conjugate):
        left = next(left.children())
    needed = (*_SUMS, Product, Quotient, Power, Root) if raised else _SUMS
    return isinstance(left, Name) and not isinstance(right, needed)


_SUMS = (Sum, Negative, CrossProduct, ScalarProduct, PoissonBracket)
