"""Whether a formula stands for a scalar, a vector or a matrix."""

from __future__ import annotations

from kowalevski_cas.notation.formula import (
    Application,
    CrossProduct,
    Diagonal,
    Formula,
    Name,
    Number,
    PoissonBracket,
    Power,
    Product,
    Quotient,
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
