"""Certificates for systems that are solved by the roots of one equation."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.proof.roots import Roots, Sign
from kowalevski_cas.search.eliminants import eliminant
from kowalevski_cas.search.squares import sum_of_squares

if TYPE_CHECKING:
    from kowalevski_cas.claims.real_roots import System


def real_roots(system: System) -> Roots | None:
    """An eliminant of the system with its certificate, or ``None``."""
    if any(level.is_zero for level in system.levels):
        return None
    levels = [level.parts[0] for level in system.levels]
    found = eliminant(levels, [unknown.parts[0] for unknown in system.unknowns])
    if found is None:
        return None
    polynomials = system.ring.polynomials
    equation = polynomials.from_terms(found.equation)
    quotients = []
    for rest in system.residuals(found):
        quotient, remainder = divmod(rest.parts.get(0, polynomials.zero), equation)
        if not polynomials.is_zero(remainder):
            return None
        quotients.append(polynomials.terms(quotient))
    products = system.products(found)
    if any(product.is_zero for product in products):
        return None
    split = [product.parts[0].factor() for product in products]
    factors: list[Terms] = []
    for _, parts in split:
        factors += [t for f, _ in parts if (t := polynomials.terms(f)) not in factors]
    rows = []
    for content, parts in split:
        powers = [0] * len(factors)
        for factor, exponent in parts:
            powers[factors.index(polynomials.terms(factor))] = int(exponent)
        rows.append((Fraction(int(content.p), int(content.q)), tuple(powers)))
    signs = tuple(_sign(factor, system) for factor in factors)
    return Roots(found, tuple(quotients), tuple(rows), signs)


def _sign(factor: Terms, system: System) -> Sign:
    """A factor as a sum of squares."""
    if squares := sum_of_squares(factor):
        return Sign(factor, squares, ())
    value = system.into(system.everywhere)(system.element(factor))
    return Sign(factor, (), sum_of_squares(value.terms().get(0, {})) or ())
