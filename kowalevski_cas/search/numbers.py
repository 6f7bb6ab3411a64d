"""Rational numbers for which equations hold identically: where their coefficients vanish."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction

from flint import Ordering, fmpq_mat, fmpq_mpoly_ctx

from kowalevski_cas.algebra.flint import polynomial_of, to_flint, to_fraction
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.collect import collect_sides
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Exists, Follows
from kowalevski_cas.problem.space import Equation
from kowalevski_cas.search.branches import branches
from kowalevski_cas.search.place import PointFinder
from kowalevski_cas.search.points import constant


def solve_for_numbers(goal: Exists, finder: PointFinder) -> dict[str, Formula] | None:
    """Numbers for which the identities of the goal hold, which are polynomials in them."""
    context = fmpq_mpoly_ctx.get(goal.numbers, Ordering.lex)
    identities = (inner for inner in goal.goals if isinstance(inner, Follows) and not inner.given)
    both = (
        (finder.of(identity.space), sides)
        for identity in identities
        for sides in identity.conclusions[0]
    )
    terms = (
        coefficient for at, sides in both for coefficient in _coefficients(sides, goal.numbers, at)
    )
    equations = [polynomial_of(context, term) for term in terms]
    for found in branches(equations, range(len(goal.numbers))):
        if len(found.solved) == len(goal.numbers):  # no other number stands in an equation
            values = {k: -constant(e, {}) / constant(e.derivative(k), {}) for k, e in found.solved}
            return {name: fraction_formula(values[k]) for k, name in enumerate(goal.numbers)}
    return None


def _coefficients(sides: Equation, numbers: Sequence[str], at: Evaluation) -> Iterable[Terms]:
    """What multiplies each monomial in the names of a space, as a polynomial in numbers."""
    collected = collect_sides(sides, numbers)
    elements = {tuple(map(m.count, numbers)): at.scalar(c) for m, c in collected.items()}
    below: dict[int, int] = {}
    for element in elements.values():
        below |= {k: max(e, below.get(k, 0)) for k, e in element.denominator.items()}
    found = defaultdict[object, Terms](dict)
    for powers, element in elements.items():
        for mask, part in Element(at.ring, element.over(below), {}).terms().items():
            for exponents, value in part.items():
                found[mask, exponents][powers] = value
    return found.values()


def linear_combination(
    rows: Sequence[Sequence[Fraction]], target: Sequence[Fraction]
) -> list[Fraction] | None:
    """Weights with which the rows add up to the target, with as few rows as come first."""
    if not rows:
        return None
    columns = [[*column, value] for *column, value in zip(*rows, target, strict=True)]
    reduced, rank = fmpq_mat([[*map(to_flint, column)] for column in columns]).rref()
    weights = [Fraction(0)] * len(rows)
    for k in range(rank):
        entries = [to_fraction(reduced[k, j]) for j in range(len(rows) + 1)]
        pivot = next(j for j, entry in enumerate(entries) if entry)
        if pivot == len(rows):
            return None
        weights[pivot] = entries[-1]
    return weights
