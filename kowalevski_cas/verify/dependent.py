"""Claims that say the same of integrals: a function of one that is constant is constant too."""

from __future__ import annotations

from kowalevski_cas.problem.differentials import differentials, minors
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Rank
from kowalevski_cas.verify.statement import Statement


def depend(one: Statement, other: Statement) -> bool:
    """Whether the one function of a claim is a function of that of another one, as points tell."""
    from kowalevski_cas.problem.sampled import Sampled  # a recorded correction is only looked up

    ranks = [[g for g in claim.claimed if type(g) is Rank] for claim in (one, other)]
    if any(len(goals) != 1 or goals[0].given or goals[0].rank != 1 for goals in ranks):
        return False
    space = ranks[0][0].space
    at = Sampled(finder_of(space))
    functions = [at.scalar(formula) for (goal,) in ranks for formula in goal.functions]
    return all(minor.is_zero for minor in minors(differentials(functions, at)))
