"""How many differentials are independent."""

from __future__ import annotations

from itertools import combinations

from kowalevski_cas.algebra.linear import determinant
from kowalevski_cas.algebra.numbers import rank
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Evidence, Minors
from kowalevski_cas.problem.goals import (
    Rank,
)
from kowalevski_cas.search.place import Candidate, PointFinder


class RankFinder(PointFinder):
    """Evidence for the ranks of differentials, or against them."""

    def independent(self, goal: Rank, at: Evaluation) -> At | None:
        """A point where all differentials are independent, if they are as many as claimed."""
        return self._independent(goal, at) if self._count(goal, at) == goal.rank else None

    def dependent(self, goal: Rank) -> Evidence | None:
        """A point where another number is independent, or minors that vanish."""
        at = self.of(goal.space)
        if self._count(goal, at) != goal.rank:
            return self._independent(goal, at)
        rows = self._gradients(goal, at)
        columns = combinations(range(len(goal.space.variables)), len(rows))
        minors = [determinant([[row[k] for k in chosen] for row in rows]) for chosen in columns]
        return Minors(((),) * len(minors)) if all(minor.is_zero for minor in minors) else None

    def _count(self, goal: Rank, at: Evaluation) -> int:
        return len(goal.functions) + len(at.differences(goal.given))

    def _gradients(self, goal: Rank, at: Evaluation) -> list[list[Element]]:
        chosen = [at.scalar(f) for f in goal.functions] + at.differences(goal.given)
        return [[at.partial(f, name) for name in goal.space.variables] for f in chosen]

    def _independent(self, goal: Rank, at: Evaluation) -> At | None:
        rows, known = self._gradients(goal, at), at.differences(goal.given)

        def good(candidate: Candidate) -> bool:
            return rank([[candidate(entry) for entry in row] for row in rows]) == len(rows)

        divided = [*known, *(entry for row in rows for entry in row)]
        point = self.point(at, known, divided, good)
        return None if point is None else At(point)
