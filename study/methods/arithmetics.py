"""The arithmetics of this program: exact ones, and those that look at points."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from time import perf_counter

from kowalevski_cas.algebra import load, load_points
from kowalevski_cas.algebra.points import Answer, Question
from kowalevski_cas.problem.goals import Problem
from study.labelled import Labelled, holds, identities, residuals
from study.methods.method import ACCEPTED, NONE, REJECTED, Method
from study.paper import sampled
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

    def cold(self, one: Labelled) -> float:
        """How long the command line takes for one claim."""
        name, claim = one.id.split("/")[:2]
        command = [sys.executable, "-m", "kowalevski_cas", "verify", name, "--only", claim]
        start = perf_counter()
        subprocess.run(
            [*command, "--arithmetic", self.name],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            check=False,
        )
        return perf_counter() - start


class PointArithmetic(ExactArithmetic):
    """Residuals are put to points, and never expanded: what is accepted is likely."""

    proves = False

    def prepare(self, one: Labelled) -> Problem:
        load_points(self.name, SEED)
        return one.statement.problem

    def answer(self, prepared: Problem) -> Measured:
        answers = list(self._answers(prepared))
        for answer in answers:
            if not answer.holds:
                verdict = NONE if answer.holds is None else REJECTED
                return {"verdict": verdict, "reason": answer.words}
        bounds = [answer.bound for answer in answers if answer.bound is not None]
        measured = {"verdict": ACCEPTED, "reason": answers[-1].words}
        return {**measured, "bound": max(bounds)} if bounds else measured

    def _answers(self, problem: Problem) -> Iterator[Answer]:
        points, of = load_points(self.name, SEED), sampled()
        for goal in identities(problem.goals):
            asked = residuals(Problem((goal,)), of)
            at = of(goal.space)
            yield points.answer(Question(at.programs, [at.carry(element) for element in asked]))
