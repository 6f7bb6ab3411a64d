"""Polynomials of FLINT, by python-flint: the default arithmetic."""

from __future__ import annotations

import copyreg
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.polynomials import Polynomials, Terms


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

    def constant(self, value: Fraction) -> fmpq_mpoly:
        return self.context.constant(fmpq(value.numerator, value.denominator))

    def derivative(self, polynomial: fmpq_mpoly, index: int) -> fmpq_mpoly:
        return polynomial.derivative(index)

    def composed(
        self, polynomial: fmpq_mpoly, values: Sequence[fmpq_mpoly], target: Polynomials
    ) -> fmpq_mpoly:
        return (
            polynomial.compose(*values) if values else super().composed(polynomial, values, target)
        )

    def is_zero(self, polynomial: fmpq_mpoly) -> bool:
        return bool(polynomial.is_zero())

    def degrees(self, polynomial: fmpq_mpoly) -> Sequence[int]:
        return polynomial.degrees()

    def terms(self, polynomial: fmpq_mpoly) -> Terms:
        return {
            tuple(map(int, exponents)): Fraction(int(value.p), int(value.q))
            if value.q != 1
            else Fraction(int(value.p))
            for exponents, value in polynomial.to_dict().items()
        }

    def from_terms(self, terms: Mapping[tuple[int, ...], Fraction]) -> fmpq_mpoly:
        return self.context.from_dict(
            {e: fmpq(value.numerator, value.denominator) for e, value in terms.items()}
        )


def _restored(
    names: tuple[str, ...], order: str, terms: Mapping[tuple[int, ...], tuple[int, int]]
) -> fmpq_mpoly:
    context = fmpq_mpoly_ctx.get(names, Ordering(order))
    return context.from_dict({exponents: fmpq(*value) for exponents, value in terms.items()})


def _plain(polynomial: fmpq_mpoly) -> tuple[Any, ...]:
    context = polynomial.context()
    terms = {
        tuple(map(int, exponents)): (int(value.p), int(value.q))
        for exponents, value in polynomial.to_dict().items()
    }
    return _restored, (context.names(), context.ordering().value, terms)


copyreg.pickle(fmpq_mpoly, _plain)  # polynomials are sent from process to process
