"""How many differentials are independent."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.algebra.numbers import independent, rank
from kowalevski_cas.algebra.present import formula_rows
from kowalevski_cas.problem.differentials import differentials, functions_for_differentials, minors
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Evidence, Minors
from kowalevski_cas.problem.examine import law
from kowalevski_cas.problem.goals import Rank
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.follows import rows_of
from kowalevski_cas.search.place import Candidate, PointFinder, Values


class RankFinder(PointFinder):
    """Evidence for the ranks of differentials, or against them."""

    def independent(self, goal: Rank, at: Evaluation) -> At | None:
        """A point where all differentials are independent, if they are as many as claimed."""
        return (
            self._independent(goal, at)
            if len(functions_for_differentials(goal, at)) == goal.rank
            else None
        )

    def dependent(self, goal: Rank) -> Evidence | None:
        """A point where another number is independent, or minors that vanish on what is given.

        Where the given equations alone have dependent differentials, this says nothing of the
        functions; it is looked for if they are independent at a point.
        """
        at = self.of(goal.space)
        functions = functions_for_differentials(goal, at)
        if len(functions) != goal.rank:
            return self._independent(goal, at)
        given = replace(goal, functions=(), rank=len(functions) - len(goal.functions))
        if goal.functions and goal.given and self._independent(given, at) is None:
            return None
        found = minors(differentials(functions, at))
        rows, power = rows_of(found, at.differences(goal.given)) or ([], 0)
        if power != 1 or any(entry.denominator for row in rows for entry in row):
            return None
        return Minors(formula_rows(rows) or ((),) * len(found))

    def _independent(self, goal: Rank, at: Evaluation) -> At | None:
        rows, known = (
            differentials(functions_for_differentials(goal, at), at),
            at.differences(goal.given),
        )

        def are_independent(values: Values) -> bool:
            return independent([[values(entry) for entry in row] for row in rows])

        on_pieces = self.on_pieces(known, are_independent)
        below = []
        with suppress(Meaningless):  # of a space that says nothing of its motion
            below = at.ring.divisors_of(at.law)

        def good(candidate: Candidate) -> bool:
            # Other goals speak of the motion of this space: its point is one where it is defined.
            if any(candidate(divisor).is_zero for divisor in below):
                return False
            found = rank([[candidate(entry) for entry in row] for row in rows])
            return found == len(rows) and on_pieces(candidate)

        divided = [*law(goal, at), *known, *(entry for row in rows for entry in row)]
        point = self.point(at, known, divided, good)
        return None if point is None else At(point)
