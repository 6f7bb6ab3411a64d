"""Where a set is singular: real points at which differentials are dependent, which are sought."""

from __future__ import annotations

from kowalevski_cas.algebra.numbers import dependence, rank
from kowalevski_cas.problem.differentials import factors_of_multipliers, has, multipliers
from kowalevski_cas.problem.evidence import At, Point
from kowalevski_cas.problem.examine import law
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Fails
from kowalevski_cas.problem.place import PointEvaluation, number_formula
from kowalevski_cas.search.place import Candidate, PointFinder


def dependence_at(goal: Fails) -> At | None:
    """A point at which differentials have a combination that vanishes, not all of it being zero.

    What should vanish by the conclusions are its coefficients, in which equations of the goal are
    linear; the others hold at the point. ``None`` if there are none, or no point is found.
    """
    at = finder_of(goal.space)
    rows = factors_of_multipliers(goal, at)
    if not any(rows):
        return None
    names = multipliers(goal)
    known = at.differences([equation for equation in goal.given if not has(equation, names)])
    entries = [entry for row in rows for entry in row]

    def good(candidate: Candidate) -> bool:
        return rank([[candidate(entry) for entry in row] for row in rows]) < len(rows)

    point = PointFinder(finder_of).point(at, known, [*law(goal, at), *entries], good)
    if point is None:
        return None
    place, bars = PointEvaluation(at, point), dict(at.setting.conjugates)
    values, found = dict(point.values), dependence([[*map(place, row)] for row in rows])
    for name, number in zip(names, found or (), strict=True):
        values[name] = number_formula(number)
        if name in bars:
            values[bars[name]] = number_formula(number.conjugate_root(number.ring.roots.index("i")))
    return At(Point(values))
