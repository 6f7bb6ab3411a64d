"""Evidence for a goal, or against it: found with FLINT, and never believed here."""

from __future__ import annotations

from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Evidence
from kowalevski_cas.problem.goals import Along, Count, Exists, Fails, Follows, Goal, Kernel, Rank
from kowalevski_cas.search.along import departure, equal
from kowalevski_cas.search.bound import find_bound_values, never
from kowalevski_cas.search.count import others, roots
from kowalevski_cas.search.follows import FollowsFinder
from kowalevski_cas.search.kernels import complete, further
from kowalevski_cas.search.ranks import RankFinder


class Finder(FollowsFinder, RankFinder):
    """Evidence for the goals of one problem."""

    def proof(self, goal: Goal, at: Evaluation | None = None) -> Evidence | None:
        """Evidence that a goal holds."""
        match goal:
            case Exists():
                return find_bound_values(goal, self, self.proof)
            case Fails():
                return self.failure(goal, at or self.of(goal.space))
            case Follows():
                return self.entailment(goal, at or self.of(goal.space))
            case Rank():
                return self.independent(goal, at or self.of(goal.space))
            case Count():
                return roots(goal, self)
            case Kernel():
                return complete(goal, self)
            case Along():
                return equal(goal, self)

    def refutation(self, goal: Goal) -> Evidence | None:
        """Evidence that a goal is false."""
        match goal:
            case Exists():
                return never(goal, self)
            case Fails():
                shown = self.entailment(goal, self.of(goal.space))
                return None if shown is None or self._divides(shown, goal) else shown
            case Follows():
                return self.failure(goal, self.of(goal.space))
            case Rank():
                return self.dependent(goal)
            case Count():
                return others(goal, self)
            case Kernel():
                return further(goal, self)
            case Along():
                return departure(goal, self)
