"""Whether all polynomials are known that a field multiplies by a factor, or which one is not."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from kowalevski_cas.algebra.polynomials import TooLarge
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Further
from kowalevski_cas.problem.goals import Kernel
from kowalevski_cas.problem.kernel import check_complete, check_further
from kowalevski_cas.problem.place import Misplaced, PointEvaluation
from kowalevski_cas.problem.space import all_names
from kowalevski_cas.search.integrals import first_integrals
from kowalevski_cas.search.place import Candidate, PointFinder

POINTS = 3
"""At how many points of the constants it is tried that nothing is missing."""


def complete(goal: Kernel, finder: PointFinder) -> At | None:
    """A point of the constants at which nothing is missing."""
    at, names = finder.of(goal.space), all_names(goal.space)
    found: list[At] = []
    tried = 0

    def good(candidate: Candidate) -> bool:
        nonlocal tried
        tried += 1
        point = candidate.point(names)
        try:
            check_complete(goal, at, PointEvaluation(at, point))
        except Misplaced:
            return not at.setting.constants or tried == POINTS
        found.append(At(point))
        return True

    finder.point(at, [], _divide_row(goal, at), good, most=0)
    return next(iter(found), None)


def further(goal: Kernel, finder: PointFinder) -> At | Further | None:
    """A point where what is listed is no solution, or a polynomial that is missing."""
    at, divided = finder.of(goal.space), _divide_row(goal, finder.of(goal.space))
    rest = next((element for element in _rests(goal, at) if not element.is_zero), None)
    if rest is not None:
        there = finder.point(at, [], [*divided, rest], lambda c: not c(rest).is_zero)
        return None if there is None else At(there)
    point = finder.point(at, [], divided, most=0)
    if point is None:
        return None
    factor, integrals = at.scalar(goal.factor), [*map(at.scalar, goal.integrals)]
    with suppress(TooLarge):
        for element in first_integrals(
            at, goal.degree, goal.weights, cofactor=factor, integrals=integrals
        ):
            with suppress(Misplaced):
                check_further(goal, formula_in(element), at, PointEvaluation(at, point))
                return Further(formula_in(element), point)
    return None


def _divide_row(goal: Kernel, at: Evaluation) -> list[Element]:
    return [*at.law, at.scalar(goal.factor)]


def _rests(goal: Kernel, at: Evaluation) -> Iterator[Element]:
    """What vanishes if all that is listed are solutions."""
    for formula in goal.integrals:
        yield at.derivative(at.scalar(formula))
    for formula in goal.solutions:
        element = at.scalar(formula)
        yield at.derivative(element) - at.scalar(goal.factor) * element
