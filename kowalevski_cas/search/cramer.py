"""The one solution of equations that are linear in what is counted, by Cramer's rule."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from typing import NamedTuple

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import coefficients
from kowalevski_cas.algebra.present import formula_in, formula_rows
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Name, Negative, Number
from kowalevski_cas.problem.evidence import Point, Roots
from kowalevski_cas.problem.goals import Count
from kowalevski_cas.search.levels import LevelEquations, new_name, point_evidence, small
from kowalevski_cas.search.points import constant

Row = list[fmpq_mpoly]


class LinearSolution(NamedTuple):
    """Unknowns x that equations e give: :math:`d x_k - n_k` is the k-th row times e.

    d is ``below``, and n ``above``; no unknown stands in d, in n or in the rows.
    """

    above: Row
    below: fmpq_mpoly
    rows: list[Row]


def cramer(goal: Count, system: LevelEquations) -> Roots | None:
    """The one solution; ``None`` if the equations are not linear, or not independent."""
    at = system.at
    zero: fmpq_mpoly = at.ring.polynomials.zero
    known = [element.parts.get(0, zero) for element in at.differences(goal.equations)]
    found = _eliminate(known, [at.names.index(name) for name in goal.names])
    if found is None:
        return None

    def element(polynomial: fmpq_mpoly) -> Element:
        return at.ring.element({0: polynomial}, {})

    point = _point(goal, system, found)
    if point is None:
        return None
    below = element(found.below)
    rows = [[*map(element, row)] for row in found.rows]
    return Roots(
        root=new_name(at),
        form=Name(goal.names[0]),
        eliminant=(formula_in(-element(found.above[0]) / below),),
        solved=tuple(
            (name, formula_in(element(above)), formula_in(below))
            for name, above in zip(goal.names, found.above, strict=True)
        ),
        rows=formula_rows([[entry / below for entry in rows[0]], *rows]),
        quotients=(*(Number(0) for _ in known), Negative(Number(1))),
        factors=(),
        minors=((Number(1), ()),),
        point=point,
    )


def _point(goal: Count, system: LevelEquations, found: LinearSolution) -> Point | None:
    """The solution for some small constants."""
    names, own = system.at.names, [system.at.names.index(name) for name in system.constants]
    for numbers in small(len(own)):
        values = dict(zip(own, map(Fraction, numbers), strict=True))
        below = constant(found.below, values)
        if below:
            numerators = (constant(above, values) for above in found.above)
            point = {n: v / below for n, v in zip(goal.names, numerators, strict=True)}
            point |= {names[place]: number for place, number in values.items()}
            if system.makes_sense(point):
                return point_evidence(point)
    return None


def _eliminate(known: Sequence[fmpq_mpoly], places: Sequence[int]) -> LinearSolution | None:
    """The unknowns by elimination without fractions; ``None`` if that is not possible."""
    size, count = len(places), len(known)
    units = [(*(int(j == k) for j in range(size)),) for k in range(size)]
    rows: list[Row] = []
    for k, polynomial in enumerate(known):
        parts = coefficients(polynomial, places)
        if any(sum(exponents) > 1 for exponents in parts):
            return None
        one, zero = (polynomial.context().constant(n) for n in (1, 0))
        own = [parts.get(unit, zero) for unit in units]
        rows.append([*own, *(one if j == k else zero for j in range(count))])
    below = _reduce_columns(rows, size)
    if below is None:
        return None
    left = [row[size:] for row in rows]
    if any(sum(a * e for a, e in zip(row, known, strict=True)) for row in left[size:]):
        return None
    factor = reduce(lambda a, b: a.gcd(b), (e for row in left[:size] for e in row), below)
    factor *= (below / factor).leading_coefficient()
    below, left = below / factor, [[entry / factor for entry in row] for row in left[:size]]
    gens = known[0].context().gens()
    above = [
        below * gens[place] - sum(a * e for a, e in zip(row, known, strict=True))
        for place, row in zip(places, left, strict=True)
    ]
    return LinearSolution(above, below, left)


def _reduce_columns(rows: list[Row], size: int) -> fmpq_mpoly | None:
    """Make the first columns a multiple of the unit matrix, and return the factor.

    The rows are those of Bareiss: every division is exact.
    """
    last = rows[0][0].context().constant(1)
    for column in range(size):
        pivots = [k for k in range(column, len(rows)) if rows[k][column]]
        if not pivots:
            return None
        best = min(pivots, key=lambda k: (not rows[k][column].is_constant(), len(rows[k][column])))
        rows[column], rows[best] = rows[best], rows[column]
        pivot = rows[column]
        for k, row in enumerate(rows):
            if k != column:
                pairs = zip(row, pivot, strict=True)
                rows[k] = [(a * pivot[column] - row[column] * b) / last for a, b in pairs]
        last = pivot[column]
    return last
