"""What a formula stands for: a scalar, a vector or a matrix, or perhaps a function."""

from __future__ import annotations

from kowalevski_cas.notation.formula import (
    Application,
    Changed,
    Commutator,
    Conjugate,
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    Modulus,
    Name,
    Negative,
    Number,
    Partial,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    Root,
    ScalarProduct,
    Sum,
    Summation,
    Vector,
)
from kowalevski_cas.notation.symbol import name_of_rate
from kowalevski_cas.notation.vocabulary import MATRIX, SCALAR, VECTOR, Vocabulary

_RANKS = dict.fromkeys((Number, ScalarProduct, Modulus), SCALAR) | {
    CrossProduct: VECTOR,
    Diagonal: MATRIX,
    Commutator: MATRIX,
}


def rank(formula: Formula, vocabulary: Vocabulary) -> int:
    r"""0 for a scalar, 1 for a vector, 2 for a matrix, as the vocabulary declares the names.

    A matrix times a vector is a vector; a matrix by its rows is a vector of vectors.
    """
    if type(formula) in _RANKS:
        return _RANKS[type(formula)]
    match formula:
        case Name(name) | Application(name):
            return vocabulary.rank(name)
        case Product(factors):
            ranks = {rank(factor, vocabulary) for factor in factors}
            return VECTOR if VECTOR in ranks else max(ranks)
        case Sum() | PoissonBracket():
            return max(rank(part, vocabulary) for part in formula.children())
        case Power(inner, _):  # of a vector there is only the scalar square
            found = rank(inner, vocabulary)
            return SCALAR if found == VECTOR else found
        case Partial(inner, by):
            return max(rank(inner, vocabulary), vocabulary.rank(name_of_rate(by)))
        case Summation(_, _, _, inner) | Quotient(inner, _):
            return rank(inner, vocabulary)
        case Vector(components):
            return min(MATRIX, VECTOR + rank(components[0], vocabulary))
    # A sign, a root, a bar or a derivative changes nothing; a word is a scalar.
    return next((rank(inner, vocabulary) for inner in formula.children()), SCALAR)


def applies(left: Formula, right: Formula, raised: bool = False) -> bool:
    """Whether a formula, and another one in brackets behind it, look like a function of it.

    They do if the first is a name, with what stands on it, and a product would need no brackets.
    It needs those around a sum; and those that a power or a prime is ``raised`` on, around
    whatever is no name or number, as around a derivative.
    """
    while isinstance(left, Derivative | Power | Conjugate | Changed):
        left = left.children()[0]
    needed = (*_SUMS, Product, Quotient, Power, Root, Derivative) if raised else _SUMS
    return isinstance(left, Name) and not isinstance(right, needed)


def is_rational(formula: Formula) -> bool:
    """Whether it is printed as a whole number, or a fraction of two."""
    match formula:
        case Number() | Quotient(Number(), Number()):
            return True
    return False


_SUMS = (Sum, Summation, Negative, CrossProduct, ScalarProduct, PoissonBracket, Modulus, Commutator)
