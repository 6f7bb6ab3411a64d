"""Eliminants: a form that tells the solutions of a system apart, and the equation for it.

The system sets homogeneous polynomials in some unknowns equal to parameters. So
the parameters are functions of the unknowns, a relation with parameters is a
linear dependence of polynomials in the unknowns, and it is found degree by
degree by linear algebra over the rationals.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import NamedTuple

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import terms_of
from kowalevski_cas.algebra.kernels import kernel
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.problem.polynomial_fields import primitive

LARGEST = 6
"""The largest degree of an eliminant that is looked for."""

LARGEST_RELATION = 12
"""The largest degree of a relation that gives an unknown."""


class Eliminant(NamedTuple):
    """A form s of the unknowns, its equation, and each unknown as ``numerator(s) / denominator``.

    Exponents are those of s, then of the parameters; ``form`` holds the
    coefficients of the unknowns.
    """

    form: tuple[int, ...]
    equation: Terms
    denominators: tuple[Terms, ...]
    numerators: tuple[Terms, ...]


Exponents = tuple[int, ...]
Columns = list[tuple[Exponents, fmpq_mpoly]]


def eliminant(levels: Sequence[fmpq_mpoly], unknowns: Sequence[fmpq_mpoly]) -> Eliminant | None:
    """The form of unknowns with an integral equation of least degree, if one is separating."""
    degrees = [_degree(level) for level in levels]
    if 0 in degrees:
        return None
    forms = sorted(product((0, 1), repeat=len(unknowns)), key=sum)[1:]
    for degree in range(1, LARGEST + 1):
        for form in forms:
            chosen = [u for u, c in zip(unknowns, form, strict=True) if c]
            value = sum(chosen, levels[0].context().constant(0))
            columns = list(_products(value, levels, degrees, degree, degree))
            equation = _relation(columns, (degree, *(0 for _ in levels)))
            if equation is None:
                continue
            solved = [_solved(u, value, levels, degrees, degree) for u in unknowns]
            rows = [row for row in solved if row is not None]
            if len(rows) == len(unknowns):
                denominators, numerators = zip(*rows, strict=True)
                return Eliminant(form, equation, denominators, numerators)
    return None


def _solved(
    unknown: fmpq_mpoly,
    value: fmpq_mpoly,
    levels: Sequence[fmpq_mpoly],
    degrees: Sequence[int],
    size: int,
) -> tuple[Terms, Terms] | None:
    """``denominator * unknown = numerator``, a polynomial in the form."""
    for degree in range(1, LARGEST_RELATION + 1):
        first = list(_products(unknown, levels, degrees, degree - 1, 0))
        left = [((-1, *key[1:]), unknown * column) for key, column in first]
        relation = _relation([*left, *_products(value, levels, degrees, degree, size - 1)])
        if relation is not None:
            sign = 1 if relation[max(k for k in relation if k[0] < 0)] > 0 else -1
            denominator = {(0, *k[1:]): sign * v for k, v in relation.items() if k[0] < 0}
            return denominator, {k: -sign * v for k, v in relation.items() if k[0] >= 0}
    return None


def _products(
    value: fmpq_mpoly,
    levels: Sequence[fmpq_mpoly],
    degrees: Sequence[int],
    degree: int,
    largest: int,
) -> Iterator[tuple[Exponents, fmpq_mpoly]]:
    """Products of powers of the form, up to the largest one, and of the levels, of one degree."""
    one = levels[0].context().constant(1)

    def extend(rest: int, index: int) -> Iterator[tuple[Exponents, fmpq_mpoly]]:
        if index == len(levels):
            if rest == 0:
                yield (), one
            return
        for exponent in range(rest // degrees[index] + 1):
            for key, column in extend(rest - exponent * degrees[index], index + 1):
                yield (exponent, *key), levels[index] ** exponent * column

    for power in range(min(degree, largest) + 1):
        for key, column in extend(degree - power, 0):
            yield (power, *key), value**power * column


def _relation(columns: Columns, leading: Exponents | None = None) -> Terms | None:
    """A linear dependence of the columns; with a ``leading`` one, whose coefficient is 1."""
    for vector in kernel([terms_of(column) for _, column in columns]):
        found = {key: value for (key, _), value in zip(columns, vector, strict=True) if value}
        if leading is None:
            return primitive(found)
        if leading in found:
            return {key: value / found[leading] for key, value in found.items()}
    return None


def _degree(polynomial: fmpq_mpoly) -> int:
    """The degree of a homogeneous polynomial, 0 if it is none."""
    degrees = {sum(exponents) for exponents in polynomial.to_dict()}
    return int(degrees.pop()) if len(degrees) == 1 else 0
