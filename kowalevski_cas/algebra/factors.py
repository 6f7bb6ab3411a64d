"""Irreducible factors and quotients of polynomials, found with FLINT."""

from __future__ import annotations

from functools import reduce
from operator import or_

from flint import Ordering, fmpq_mpoly_ctx

from kowalevski_cas.algebra.flint import polynomial_of, terms_of
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.tower import Element


def irreducible_factors(terms: Terms) -> list[tuple[Terms, int]]:
    """The irreducible factors of a polynomial with their exponents, numbers left out.

    >>> from fractions import Fraction
    >>> square = {(2, 0): Fraction(2), (1, 1): Fraction(-4), (0, 2): Fraction(2)}
    >>> irreducible_factors(square)
    [({(1, 0): Fraction(1, 1), (0, 1): Fraction(-1, 1)}, 2)]
    """
    factors = polynomial_of(_context(terms), terms).factor()[1]
    return [(terms_of(factor), int(exponent)) for factor, exponent in factors]


def exact_quotient(terms: Terms, divisor: Terms) -> Terms | None:
    """The quotient of two polynomials, if the division leaves nothing."""
    above, below = (polynomial_of(_context(divisor), term) for term in (terms, divisor))
    quotient, rest = divmod(above, below)
    return None if rest else terms_of(quotient)


def vanishes_with(element: Element, divisor: Element) -> bool:
    """Whether an element vanishes wherever a polynomial does, for a power is a multiple of it.

    With a root ``r`` of ``y``, ``x + r`` does not vanish wherever its norm ``x^2 - y`` does.
    """
    # where it vanishes with its conjugates, so do all but the first coefficient of its
    # characteristic polynomial, of degree 2 to the number of roots: the power of this degree is a
    # multiple (Cayley, Hamilton)
    roots = reduce(or_, element.parts, 0).bit_count()
    power, (below,) = element ** (2**roots), divisor.terms().values()
    return all(exact_quotient(terms, below) is not None for terms in power.terms().values())


def _context(terms: Terms) -> fmpq_mpoly_ctx:
    size = len(next(iter(terms)))
    return fmpq_mpoly_ctx.get(tuple(f"g{k}" for k in range(size)), Ordering.lex)
