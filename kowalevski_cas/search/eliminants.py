"""Eliminants: a form that tells the solutions of a system apart, and the equation for it.

The system sets polynomials in some unknowns equal to parameters. What is asked for stands in a
Gröbner basis for which the unknowns come first, then the form, and the parameters last.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from typing import NamedTuple

from flint import Ordering, fmpq_mpoly_ctx

from kowalevski_cas.algebra.flint import polynomial_of, terms_of
from kowalevski_cas.algebra.ideals import reduce_groebner_basis
from kowalevski_cas.algebra.polynomials import Terms, TooLarge, primitive
from kowalevski_cas.search.combinations import complete


class Eliminant(NamedTuple):
    """A form s of the unknowns, its equation, and each unknown as ``numerator(s) / denominator``.

    Exponents are those of s, then of the parameters; ``form`` holds the
    coefficients of the unknowns.
    """

    form: tuple[int, ...]
    equation: Terms
    denominators: tuple[Terms, ...]
    numerators: tuple[Terms, ...]


def eliminant(levels: Sequence[Terms], size: int) -> Eliminant | None:
    """A sum of few of the unknowns with an integral equation, by which all of them are told."""
    for form in sorted(product((0, 1), repeat=size), key=sum)[1:]:
        found = complete(_elimination_formulas(levels, form, place) for place in range(size))
        if found is not None:
            equations, denominators, numerators = zip(*found, strict=True)
            return Eliminant(form, equations[0], denominators, numerators)
    return None


def _elimination_formulas(
    levels: Sequence[Terms], form: Sequence[int], place: int
) -> tuple[Terms, Terms, Terms] | None:
    """The equation of the form, and the unknown at a place as a denominator and a numerator."""
    size = len(form)
    order = sorted(range(size), key=lambda k: k == place)  # this unknown comes last
    names = [*(f"x{k}" for k in order), "s", *(f"p{j}" for j in range(len(levels)))]
    context, rest = fmpq_mpoly_ctx.get(names, Ordering.lex), (0,) * (len(levels) + 1)
    units = {tuple(int(j == k) for j in range(size)): Fraction(c) for k, c in enumerate(form) if c}
    sides = (
        polynomial_of(context, {(*(e[k] for k in order), *rest): v for e, v in side.items()})
        for side in (units, *levels)
    )
    given = [side - value for side, value in zip(sides, context.gens()[size:], strict=True)]
    try:
        basis = reduce_groebner_basis(given)
    except TooLarge:
        return None
    own = [
        {e[size - 1 :]: value for e, value in terms_of(polynomial).items()}
        for polynomial in basis
        if not any(polynomial.degrees()[: size - 1])
    ]
    equation = next(
        (polynomial for polynomial in own if not any((max(polynomial)[0], *max(polynomial)[2:]))),
        None,
    )
    linear = next(
        (primitive(polynomial) for polynomial in own if max(polynomial)[:2] == (1, 0)), None
    )
    if equation is None or linear is None:
        return None
    below = {e[1:]: value for e, value in linear.items() if e[0]}
    above = {e[1:]: -value for e, value in linear.items() if not e[0]}
    return {e[1:]: value for e, value in equation.items()}, below, above
