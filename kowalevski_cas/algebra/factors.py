"""Irreducible factors of polynomials, found with FLINT."""

from __future__ import annotations

from fractions import Fraction

from flint import Ordering, fmpq, fmpq_mpoly_ctx

from kowalevski_cas.algebra.polynomials import Terms


def irreducible_factors(terms: Terms) -> list[tuple[Terms, int]]:
    """The irreducible factors of a polynomial with their exponents, numbers left out.

    >>> square = {(2, 0): Fraction(2), (1, 1): Fraction(-4), (0, 2): Fraction(2)}
    >>> irreducible_factors(square)
    [({(1, 0): Fraction(1, 1), (0, 1): Fraction(-1, 1)}, 2)]
    """
    size = len(next(iter(terms)))
    context = fmpq_mpoly_ctx.get(tuple(f"g{k}" for k in range(size)), Ordering.lex)
    polynomial = context.from_dict(
        {exponents: fmpq(v.numerator, v.denominator) for exponents, v in terms.items()}
    )
    return [
        (
            {
                tuple(map(int, exponents)): Fraction(int(value.p), int(value.q))
                for exponents, value in factor.to_dict().items()
            },
            int(exponent),
        )
        for factor, exponent in polynomial.factor()[1]
    ]
