"""The judge, of problems as they are made and as they stand in certificates."""

from kowalevski_cas.algebra import load
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.codec import read_evidence, read_problem
from kowalevski_cas.problem.evaluate import Evaluation


def judge(arithmetic="flint"):
    made = {}

    def of(space):
        if space not in made:
            made[space] = Evaluation(space, load(arithmetic), others=of).adjoin_roots()
        return made[space]

    return Judge(of)


def judged(data):
    """Let the judge look at the evidence of a certificate; raises ``Unproved`` or ``FormatError``."""
    problem, one = read_problem(data), judge()
    if data["sign"] == "denied":
        entry = dict(data["evidence"][0])
        goal = problem.goals[entry.pop("goal")]
        one.denies(goal, read_evidence(entry, goal, False))
    else:
        for goal, entry in zip(problem.goals, data["evidence"], strict=True):
            one.holds(goal, read_evidence(entry, goal))
