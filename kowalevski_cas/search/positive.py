"""Positive polynomials: as sums of squares that do not vanish together."""

from __future__ import annotations

from kowalevski_cas.algebra.present import formula_in, fraction_formula
from kowalevski_cas.problem.evidence import Proof, Squares
from kowalevski_cas.problem.goals import Positive
from kowalevski_cas.search.cofactors import cofactors
from kowalevski_cas.search.place import PointFinder
from kowalevski_cas.search.squares import sum_of_squares


def positive(goal: Positive, finder: PointFinder) -> Squares | None:
    """The formula as a sum of squares, where division shows that it is not zero."""
    at = finder.of(goal.space)
    value, known = at.scalar(goal.formula), at.differences(goal.given)
    if value.denominator or value.parts.keys() != {0}:
        return None
    found = sum_of_squares(value.terms()[0])
    zero = cofactors(at.ring.one, [*known, value], ())
    if found is None or zero is None:
        return None
    squares = tuple(
        (fraction_formula(number), formula_in(at.ring.from_terms({0: base})))
        for number, base in found
    )
    point = finder.point(at, known, [value, *known])
    return Squares(squares, ((),), point, Proof((tuple(map(formula_in, zero)),)))
