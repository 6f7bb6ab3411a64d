"""Formulas as polynomials in bound names, with coefficients in which none stands."""

from __future__ import annotations

from collections.abc import Container
from itertools import product

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    times,
    total,
)
from kowalevski_cas.problem.space import Equation, Meaningless

Monomial = tuple[str, ...]
Collected = dict[Monomial, Formula]
"""Coefficients by sorted monomials; the empty one is what is free of bound names."""


def collect_sides(sides: Equation, bound: Container[str]) -> Collected:
    """The coefficients of the left minus the right side of an equation."""
    left, right = sides
    return collect(Sum((left, Negative(right))), bound)


def collect(formula: Formula, bound: Container[str]) -> Collected:
    """The coefficients of a formula; raises :class:`Meaningless` if it is no polynomial.

    >>> collect(Sum((Name("a"), Product((Name("b"), Name("M"))))), {"M"})
    {(): Name(name='a'), ('M',): Name(name='b')}
    """
    if not _mentions(formula, bound):
        return {} if formula == Number(0) else {(): formula}
    match formula:
        case Name(name):
            return {(name,): Number(1)}
        case Negative(argument):
            return {m: Negative(c) for m, c in collect(argument, bound).items()}
        case Sum(terms):
            return _sum([collect(term, bound) for term in terms])
        case Product(factors):
            return _product([collect(factor, bound) for factor in factors])
        case Power(base, Number(exponent)):
            return _product([collect(base, bound)] * exponent)
        case Quotient(above, below) if not _mentions(below, bound):
            return {m: Quotient(c, below) for m, c in collect(above, bound).items()}
    raise Meaningless("a bound name stands where no polynomial can be read")


def _mentions(formula: Formula, bound: Container[str]) -> bool:
    return any(name in bound for name in formula.names())


def _sum(parts: list[Collected]) -> Collected:
    groups: dict[Monomial, list[Formula]] = {}
    for part in parts:
        for monomial, coefficient in part.items():
            groups.setdefault(monomial, []).append(coefficient)
    return {m: total(terms) for m, terms in groups.items()}


def _product(parts: list[Collected]) -> Collected:
    terms: list[Collected] = []
    for choice in product(*(part.items() for part in parts)):
        monomial = tuple(sorted(name for names, _ in choice for name in names))
        terms.append({monomial: times(*(coefficient for _, coefficient in choice))})
    return _sum(terms)
