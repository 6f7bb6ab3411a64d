"""Exact numbers as trees of a certificate."""

from __future__ import annotations

from kowalevski_cas.arithmetic.present import fraction_formula
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.proof.trees import CertificateError, Tree, encode


def number_tree(number: Element, squares: set[int]) -> Tree:
    """The tree of a number; the integers whose roots it needs are entered."""
    ring, terms = number.ring, []
    for mask, part in number.terms().items():
        for value in part.values():
            factors: list[Tree] = []
            for bit, name in enumerate(ring.roots):
                if mask >> bit & 1 and name == "i":
                    factors.append("i")
                elif mask >> bit & 1:
                    square = ring.radicands[bit].terms()
                    if set(square) != {0}:
                        raise CertificateError("a value at the point is a root of a root")
                    (radicand,) = square[0].values()
                    whole = radicand.numerator * radicand.denominator
                    if whole < 0:
                        raise CertificateError("a value at the point is an imaginary root")
                    squares.add(whole)
                    factors.append(["/", ["sqrt", whole], radicand.denominator])
            coefficient = encode(fraction_formula(value))
            terms.append(["*", coefficient, *factors] if factors else coefficient)
    if not terms:
        return 0
    return ["+", *terms] if len(terms) > 1 else terms[0]
