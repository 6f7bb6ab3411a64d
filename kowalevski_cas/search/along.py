"""Where two solutions of one system begin, and whether they part."""

from __future__ import annotations

from contextlib import suppress

from kowalevski_cas.notation import Name
from kowalevski_cas.problem.along import ORDER, Solved, check_departure, check_equal
from kowalevski_cas.problem.evidence import At, Departure, Point
from kowalevski_cas.problem.goals import Along
from kowalevski_cas.problem.place import Misplaced, Place
from kowalevski_cas.search.place import PointFinder


def beginning(goal: Along, finder: PointFinder) -> Point | None:
    """A real point where the motion begins, and all that is stated is defined."""
    at = finder.of(goal.space)
    solved = Solved(goal, at)
    rates = [at.derivative(at.scalar(Name(name))) for name in solved.initial]
    return finder.point(at, solved.differences, [*solved.values.values(), *rates])


def equal(goal: Along, finder: PointFinder) -> At | None:
    """The beginning of the motion, if the two sides are equal."""
    with suppress(Misplaced):
        check_equal(Solved(goal, finder.of(goal.space)))
        point = beginning(goal, finder)
        return None if point is None else At(point)
    return None


def departure(goal: Along, finder: PointFinder) -> Departure | None:
    """The beginning of the motion, and the order of the first derivative that is another one."""
    with suppress(Misplaced):
        at, point = finder.of(goal.space), beginning(goal, finder)
        for order in range(ORDER + 1) if point is not None else ():
            with suppress(Misplaced):
                check_departure(Solved(goal, at), order, Place(at, point))
                return Departure(point, order)
    return None
