"""Where a set has another dimension, or is singular: real points of a locus, which are sought."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from itertools import islice

from kowalevski_cas.algebra.ideals import vanish_on
from kowalevski_cas.algebra.numbers import rank, rational
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.differentials import differentials, functions_for_differentials
from kowalevski_cas.problem.evidence import Point
from kowalevski_cas.problem.examine import law
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Rank
from kowalevski_cas.problem.place import Misplaced
from kowalevski_cas.problem.space import Equation, all_names
from kowalevski_cas.search.place import Candidate, PointFinder
from kowalevski_cas.search.real import real_points

TRIES = 3
"""At how many points a rank is taken."""


def rank_on(goal: Rank, locus: tuple[Equation, ...]) -> tuple[int, Point] | None:
    """The codimension of a level on a locus where an equation says nothing, and a point of it.

    All equations of the set have independent differentials at the point, so that near it the set
    is a manifold; those of the locus that hold on the whole level are no equations of the set.
    ``None`` if all equations say something there, or no such point is found.
    """
    at = finder_of(goal.space)
    there = at.differences(locus)
    given = at.differences(goal.given)
    gone = vanish_on(given, there)
    if not any(gone):
        return None
    left = [element for element, vanishes in zip(given, gone, strict=True) if not vanishes]
    functions = [at.scalar(f) for f in goal.functions]
    names = all_names(goal.space)
    avoid = [*at.granted, *at.ring.divisors_of([*functions, *left, *there])]
    for point in islice(real_points(at, names, [*left, *there], avoid), TRIES):
        with suppress(ZeroDivisionError, Misplaced):
            candidate = Candidate(at, point)
            own = [*left, *_beside(functions, there, candidate)]
            rows = differentials([*functions, *own], at)
            moving = [
                [candidate(e) for e in row] for row in rows if not all(e.is_zero for e in row)
            ]
            if candidate.vanish(own) and rank(moving) == len(moving):
                return len(moving), candidate.point(names)
    return None


def _beside(
    functions: Sequence[Element], there: Sequence[Element], candidate: Candidate
) -> list[Element]:
    """What of a locus does not vanish on the whole level of functions through a point of it."""
    values = ((f, rational(candidate(f))) for f in functions)
    level = [f - f.ring.number(value) for f, value in values if value is not None]
    known = vanish_on(there, level)
    return [element for element, vanishes in zip(there, known, strict=True) if not vanishes]


def drop_on(goal: Rank, locus: tuple[Equation, ...]) -> tuple[int, Point] | None:
    """A point of a set on a locus where fewer differentials are independent, and how many."""
    at = finder_of(goal.space)
    finder = PointFinder(finder_of)
    known = [*at.differences(goal.given), *at.differences(locus)]
    rows = differentials(functions_for_differentials(goal, at), at)
    found: list[int] = []

    def good(candidate: Candidate) -> bool:
        found.append(rank([[candidate(entry) for entry in row] for row in rows]))
        return found[-1] < goal.rank

    point = finder.point(at, known, [*law(goal, at), *(e for row in rows for e in row)], good)
    return None if point is None else (found[-1], point)
