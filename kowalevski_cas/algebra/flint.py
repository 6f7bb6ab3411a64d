"""Polynomials of FLINT, by python-flint: the default arithmetic."""

from __future__ import annotations

import copyreg
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.polynomials import Coefficients, Map, Polynomials, Terms


def to_fraction(value: fmpq) -> Fraction:
    """A rational number of FLINT as one of Python."""
    return Fraction(int(value.p)) if value.q == 1 else Fraction(int(value.p), int(value.q))


def to_flint(value: int | Fraction) -> fmpq:
    """A rational number of Python as one of FLINT."""
    return fmpq(value.numerator, value.denominator)


def terms_of(polynomial: fmpq_mpoly) -> Terms:
    """The neutral form of a polynomial."""
    both = zip(polynomial.monoms(), polynomial.coeffs(), strict=True)
    return {tuple(map(int, e)): to_fraction(value) for e, value in both}


def polynomial_of(context: fmpq_mpoly_ctx, terms: Coefficients) -> fmpq_mpoly:
    """The polynomial with these coefficients."""
    # FLINT takes whole numbers as they are.
    return context.from_dict({e: v if type(v) is int else to_flint(v) for e, v in terms.items()})


def coefficients(
    polynomial: fmpq_mpoly, places: Sequence[int]
) -> dict[tuple[int, ...], fmpq_mpoly]:
    """Those of a polynomial in the variables at some places; they have the others in them."""
    groups: dict[tuple[int, ...], dict[tuple[int, ...], fmpq]] = {}
    for exponents, value in polynomial.to_dict().items():
        key = tuple(int(exponents[k]) for k in places)
        others = tuple(0 if k in places else e for k, e in enumerate(exponents))
        groups.setdefault(key, {})[others] = value
    return {key: polynomial.context().from_dict(terms) for key, terms in groups.items()}


def with_values(polynomial: fmpq_mpoly, values: Mapping[int, int]) -> fmpq_mpoly:
    """A polynomial with numbers for the variables at some places."""
    names = polynomial.context().names()
    return polynomial.subs({names[place]: value for place, value in values.items()})


class Arithmetic(Polynomials):
    """``fmpq_mpoly`` in lexicographic order."""

    name = "flint"

    def __init__(self, generators: tuple[str, ...]) -> None:
        super().__init__(generators)
        names = tuple(f"g{index}" for index in range(len(generators)))
        self.context = fmpq_mpoly_ctx.get(names, Ordering.lex)
        self._generators = self.context.gens()
        self.zero = self.context.constant(0)
        self.one = self.context.constant(1)

    def generator(self, index: int) -> fmpq_mpoly:
        return self._generators[index]

    def constant(self, value: int | Fraction) -> fmpq_mpoly:
        return self.context.constant(to_flint(value))

    def derivative(self, polynomial: fmpq_mpoly, index: int) -> fmpq_mpoly:
        return polynomial.derivative(index)

    def substitution(self, values: Sequence[fmpq_mpoly], target: Polynomials) -> Map:
        assert isinstance(target, Arithmetic)
        if all(value.is_constant() for value in values):  # FLINT puts in numbers faster
            numbers = [value.leading_coefficient() if value else 0 for value in values]
            return lambda polynomial: target.context.constant(polynomial(*numbers))
        return lambda polynomial: polynomial.compose(*values)

    def is_monomial(self, polynomial: fmpq_mpoly) -> bool:
        return len(polynomial) == 1

    def occurring_places(self, polynomial: fmpq_mpoly) -> list[int]:
        return [place for place, degree in enumerate(polynomial.degrees()) if degree > 0]

    def terms(self, polynomial: fmpq_mpoly) -> Terms:
        return terms_of(polynomial)

    def from_terms(self, terms: Coefficients) -> fmpq_mpoly:
        return polynomial_of(self.context, terms)


def _restore(names: tuple[str, ...], order: str, terms: Terms) -> fmpq_mpoly:
    return polynomial_of(_context(names, order), terms)


def _plain(polynomial: fmpq_mpoly) -> tuple[Any, ...]:
    context = polynomial.context()
    return _restore, (context.names(), context.ordering().value, terms_of(polynomial))


def _context(names: tuple[str, ...], order: str) -> fmpq_mpoly_ctx:
    return fmpq_mpoly_ctx.get(names, Ordering(order))


# Polynomials, and what holds them, are sent from process to process.
copyreg.pickle(fmpq_mpoly, _plain)
copyreg.pickle(
    fmpq_mpoly_ctx, lambda context: (_context, (context.names(), context.ordering().value))
)
