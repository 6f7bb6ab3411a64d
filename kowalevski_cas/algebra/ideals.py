"""Ideals of polynomials, by their reduced Gröbner bases."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from flint import Ordering, fmpq_mpoly, fmpz_mpoly_ctx, fmpz_mpoly_vec

from kowalevski_cas.algebra.flat import Flat
from kowalevski_cas.algebra.flint import terms_of
from kowalevski_cas.algebra.polynomials import TooLarge, primitive
from kowalevski_cas.algebra.tower import Element

LIMITS = (500, 10_000, 50_000)
"""Elements, terms of one and bits of a number with which a basis is given up that nobody made."""


def reduce_groebner_basis(polynomials: Sequence[fmpq_mpoly]) -> list[fmpq_mpoly]:
    """The reduced Gröbner basis of polynomials, where nobody asks how it is made.

    Raises:
        TooLarge: there are too many elements or terms on the way, or too large numbers.
    """
    context = polynomials[0].context()
    whole = fmpz_mpoly_ctx.get(context.names(), context.ordering())
    given = (primitive(terms_of(polynomial)) for polynomial in polynomials if polynomial)
    generators = [whole.from_dict({e: int(value) for e, value in terms.items()}) for terms in given]
    answer: Any = fmpz_mpoly_vec(generators, whole).buchberger_naive(
        LIMITS
    )  # its type leaves limits out
    found, complete = answer
    if not complete:
        raise TooLarge("a Gröbner basis has over {} elements, {} terms or {} bits".format(*LIMITS))
    rational = (
        context.from_dict(polynomial.to_dict()) for polynomial in found.autoreduction(groebner=True)
    )
    return [polynomial / polynomial.leading_coefficient() for polynomial in rational]


def remainder(polynomial: fmpq_mpoly, divisors: Sequence[fmpq_mpoly]) -> fmpq_mpoly:
    """What is left of a polynomial when no leading monomial of a divisor divides one of it."""
    before = None
    while before != polynomial:
        before = polynomial
        for divisor in filter(None, divisors):
            polynomial = divmod(polynomial, divisor)[1]
    return polynomial


def vanish_on(elements: Sequence[Element], known: Sequence[Element]) -> list[bool]:
    """Which elements are combinations of known ones, without a condition."""
    given = [element for element in known if not element.is_zero]
    if not elements or not given:
        return [element.is_zero for element in elements]
    # nothing is to be eliminated, and by degrees bases stay smallest
    flat = Flat(given[0].ring, Ordering.deglex)
    try:
        basis = reduce_groebner_basis([*map(flat.polynomial, given), *flat.relations()])
    except TooLarge:
        # what is not shown to be a combination counts as none
        return [False] * len(elements)
    return [remainder(flat.polynomial(element), basis).is_zero() for element in elements]
