"""Where two solutions of one system begin, and whether they part."""

from __future__ import annotations

from contextlib import suppress

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Name
from kowalevski_cas.problem.along import ORDER, InitialValueProblem, check_equal
from kowalevski_cas.problem.evidence import At, Departure, Point
from kowalevski_cas.problem.goals import Along
from kowalevski_cas.problem.place import Misplaced
from kowalevski_cas.search.place import Candidate, Good, PointFinder


def initial_point(
    goal: Along, finder: PointFinder, good: Good = lambda there: True
) -> Point | None:
    """A real point where the motion begins, all that is stated is defined, and all is good."""
    at = finder.of(goal.space)
    solved = InitialValueProblem(goal, at)
    rates = [at.derivative(at.scalar(Name(name))) for name in solved.initial]
    return finder.point(at, solved.differences, [*solved.values.values(), *rates], good, most=0)


def equal(goal: Along, finder: PointFinder) -> At | None:
    """The beginning of the motion, if the two sides are equal."""
    with suppress(Misplaced):
        check_equal(InitialValueProblem(goal, finder.of(goal.space)))
        point = initial_point(goal, finder)
        return None if point is None else At(point)
    return None


def departure(goal: Along, finder: PointFinder) -> Departure | None:
    """The beginning of the motion, and the order of the first derivative that is another one."""
    with suppress(Misplaced):
        at = finder.of(goal.space)
        solved = InitialValueProblem(goal, at)
        values = solved.values.items()
        differences = [at.scalar(Name(name)) - value for name, value in values]
        for order in range(ORDER + 1):

            def part(there: Candidate, differences: list[Element] = differences) -> bool:
                return not there.vanish(differences)

            if (point := initial_point(goal, finder, part)) is not None:
                return Departure(point, order)
            differences = [*map(at.derivative, differences)]
    return None
