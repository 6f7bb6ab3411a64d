"""The arithmetics of this program: exact ones, and those that look at points."""

from __future__ import annotations

from kowalevski_cas.algebra import load, load_points
from kowalevski_cas.algebra.points import Question
from kowalevski_cas.problem.goals import Problem
from study.labelled import Labelled, holds, identities, residuals
from study.methods.method import ACCEPTED, NONE, REJECTED, Method
from study.paper import sampler
from study.step import Measured

SEED = 2002


class ExactArithmetic(Method):
    """Polynomials: the residual of a statement is brought to its only form."""

    proves = True

    def prepare(self, one: Labelled) -> Problem:
        load(self.name)
        return one.statement.problem

    def answer(self, prepared: Problem) -> Measured:
        return {"verdict": ACCEPTED if holds(prepared, self.name) else REJECTED}


class PointArithmetic(Method):
    """Residuals are put to points, and never expanded: what is accepted is likely."""

    def prepare(self, one: Labelled) -> Problem:
        load_points(self.name, SEED)
        return one.statement.problem

    def answer(self, prepared: Problem) -> Measured:
        points, of, bounds = load_points(self.name, SEED), sampler(), []
        for goal in identities(prepared):
            at = of(goal.space)
            asked = [at.carry(element) for element in residuals(Problem((goal,)), of)]
            answer = points.answer(Question(at.programs, asked))
            if answer.holds is None:
                return {"verdict": NONE, "reason": answer.words}
            if not answer.holds:
                return {"verdict": REJECTED}
            bounds.append(answer.bound)
        known = [bound for bound in bounds if bound is not None]
        return {"verdict": ACCEPTED, **({"bound": max(known)} if known else {})}
