"""Real points at which hypotheses hold, found once for all that may be concluded from them."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.examine import law
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.problem.space import all_names
from kowalevski_cas.search.place import Candidate, Of, PointFinder

POINTS = 3
"""At how many points a conclusion is looked at."""


class HypothesisPoints:
    """Calling it says whether a conclusion fails at a real point of its hypotheses.

    ``of`` evaluates spaces with FLINT. What fails at a point is false; what holds at these few may
    be false all the same.
    """

    def __init__(self, goal: Follows, of: Of) -> None:
        self.found: list[Candidate] = []
        at = of(goal.space)
        known = at.differences(goal.given)
        PointFinder(of).point(at, known, [*law(goal, at), *known], self._keep, 0)

    def _keep(self, candidate: Candidate) -> bool:
        """Keep a point, and say whether there are enough."""
        candidate.point(all_names(candidate.at.setting))
        self.found.append(candidate)
        return len(self.found) == POINTS

    def refute(self, goal: Follows, at: Evaluation) -> bool:
        """Whether all conclusions fail at one of the points, where everything is defined."""
        conclusions = [at.differences(conclusion) for conclusion in goal.conclusions]
        return any(
            all(_fails(candidate, conclusion) for conclusion in conclusions)
            for candidate in self.found
        )


def _fails(candidate: Candidate, conclusion: Sequence[Element]) -> bool:
    """Whether some of these elements has a value at a point, which is not zero."""
    try:
        return not candidate.vanish(conclusion)
    except ZeroDivisionError:
        return False
