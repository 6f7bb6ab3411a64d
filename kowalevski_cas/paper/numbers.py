"""Formulas that are numbers, by the numbers that their names stand for."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import prod

from kowalevski_cas.notation import Formula, Name, Negative, Number, Product, Quotient, Sum


def number_of(formula: Formula, definition: Callable[[str], Formula | None]) -> Fraction | None:
    r"""The number that a formula is, by what ``definition`` says of its names; or ``None``.

    So :math:`b+c` is 3 beside :math:`b=1, c=2b`, and :math:`b+c\ne0` says nothing.
    """
    if isinstance(formula, Number):
        return Fraction(formula.value)
    if isinstance(formula, Name):
        given = definition(formula.name)
        return number_of(given, definition) if given is not None else None
    if not isinstance(formula, Negative | Sum | Product | Quotient):
        return None
    values = [number_of(child, definition) for child in formula.children()]
    known = [value for value in values if value is not None]
    return _combined(formula, known) if len(known) == len(values) else None


def _combined(formula: Formula, values: list[Fraction]) -> Fraction | None:
    """The sum, product, quotient or opposite of numbers; ``None`` where 0 is divided by."""
    match formula:
        case Sum():
            return sum(values, Fraction(0))
        case Negative():
            return -values[0]
        case Quotient():
            return values[0] / values[1] if values[1] else None
    return prod(values, start=Fraction(1))
