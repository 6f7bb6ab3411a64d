"""Where a set has another dimension: at a point of a locus on which equations of it say nothing."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.algebra.ideals import vanish_on
from kowalevski_cas.algebra.numbers import rank, rational
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.differentials import differentials
from kowalevski_cas.problem.goals import Rank
from kowalevski_cas.problem.place import Misplaced, PointEvaluation
from kowalevski_cas.problem.space import Equation


def dimension_at(goal: Rank, locus: tuple[Equation, ...], place: PointEvaluation) -> int | None:
    """The dimension of a level at a point of a locus, if it is larger there than by the rank.

    All equations that say something on the locus have independent differentials at the point, so
    that near it the set is a manifold; those of the locus that hold on the whole level are no
    equations of the set. ``None`` if all equations say something there, or they are dependent.
    """
    at = place.at
    there, given = at.differences(locus), at.differences(goal.given)
    gone = vanish_on(given, there)
    left = [element for element, vanishes in zip(given, gone, strict=True) if not vanishes]
    functions = [at.scalar(f) for f in goal.functions]
    try:
        rows = differentials([*functions, *left, *_beside(functions, there, place)], at)
        moving = [[place(e) for e in row] for row in rows if not all(e.is_zero for e in row)]
    except (Misplaced, ZeroDivisionError):
        return None
    count = rank(moving)
    regular = count == len(moving) < goal.rank and any(gone)
    return len(goal.space.variables) - count if regular else None


def _beside(
    functions: Sequence[Element], there: Sequence[Element], place: PointEvaluation
) -> list[Element]:
    """What of a locus does not vanish on the whole level of functions through a point of it."""
    values = ((f, rational(place(f))) for f in functions)
    level = [f - f.ring.number(value) for f, value in values if value is not None]
    known = vanish_on(there, level)
    return [element for element, vanishes in zip(there, known, strict=True) if not vanishes]
