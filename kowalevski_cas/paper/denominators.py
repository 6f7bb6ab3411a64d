"""The denominators that are printed, and what has to vanish for them to vanish."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from fractions import Fraction

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Power, Product, Quotient
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.problem.space import Meaningless

Shape = frozenset[object]
"""A polynomial up to a constant factor, as a key."""

Denominators = dict[Formula, tuple[Element, set[Shape]]]
"""Factors of denominators, each as an element, and what one over it is divided by, in factors."""


def denominators(setting: Meaning, formulas: Iterable[Formula]) -> Denominators:
    """The factors of all denominators in formulas of a setting that mean something there."""
    found: Denominators = {}
    for formula in _below(formulas):
        with suppress(Meaningless, ZeroDivisionError):
            element = setting.finder.scalar(formula)
            divisors = element.ring.divided_by([element.inverse()])
            found[formula] = element, set().union(*map(factors_of, divisors))
    return found


def _below(formulas: Iterable[Formula]) -> Iterator[Formula]:
    waiting = [*formulas]
    while waiting:
        formula = waiting.pop()
        waiting += formula.children()
        if isinstance(formula, Quotient):
            below = formula.denominator
            for factor in below.factors if isinstance(below, Product) else (below,):
                yield factor.base if isinstance(factor, Power) else factor


def factors_of(element: Element) -> set[Shape]:
    """The irreducible factors of a numerator, as far as no root stands in it."""
    from kowalevski_cas.algebra.factors import irreducible_factors  # only deciding needs FLINT

    irreducible = irreducible_factors(element.terms()[0]) if 0 in element.terms() else []
    return {shape_of(element.ring.from_terms({0: terms})) for terms, _ in irreducible}


def shape_of(element: Element) -> Shape:
    """A numerator up to a constant factor, as a key."""
    parts = element.terms()
    lead = next((parts[m][max(parts[m])] for m in sorted(parts)), Fraction(1))
    return frozenset(
        (mask, exponents, (scaled := value / lead).numerator, scaled.denominator)
        for mask, terms in parts.items()
        for exponents, value in terms.items()
    )
