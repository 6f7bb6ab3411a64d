"""A way of deciding: it accepts a statement, rejects it, or gives no answer."""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cache
from typing import Any

from kowalevski_cas.export import Inexpressible
from kowalevski_cas.limits import time_limit
from kowalevski_cas.problem.checker import Rejected
from kowalevski_cas.problem.codec import evidence_data
from kowalevski_cas.problem.evidence import Entailment
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Problem
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.processes import each
from kowalevski_cas.search.place import PointFinder
from kowalevski_cas.verify.certificate import certificate_text
from study.labelled import Labelled, identities
from study.process import processor_seconds
from study.step import Measured

ACCEPTED, REJECTED, NONE = "accepted", "rejected", "none"
"""The verdicts. A limit that is reached is ``timeout``, a failure ``error``: no answers either."""

SECONDS = 20.0


class Method(ABC):
    """``proves`` says that an answer of this method is a proof, and an error would be a bug.

    ``share`` is how many statements of the labelled set it is put to, all of them if
    it is ``None``.
    """

    proves = False

    def __init__(self, name: str, share: int | None = None) -> None:
        self.name = name
        self.share = share

    def decide(self, one: Labelled) -> Measured:
        """The verdict on a statement, with the seconds of processor time that it took.

        A reason if there is none.
        """
        try:
            prepared = self.prepare(one)
        except (FormatError, Inexpressible, Rejected) as error:
            return {"seconds": None, "verdict": NONE, "reason": str(error.args[0])}
        (measured,) = each(self._time, [prepared])
        return measured

    def _time(self, prepared: Any) -> Measured:
        start = processor_seconds()
        try:
            with time_limit(SECONDS):
                answer = self.answer(prepared)
        except TimeoutError:
            return {"seconds": SECONDS, "verdict": "timeout", "reason": f"{SECONDS:g} s"}
        return {"seconds": processor_seconds() - start, **answer}

    @abstractmethod
    def prepare(self, one: Labelled) -> Any:
        """What the method is given; raises an error that says why if it cannot be stated."""

    @abstractmethod
    def answer(self, prepared: Any) -> Measured:
        """The verdict on what was prepared; this is what is timed."""


@cache
def certificate(one: Labelled) -> str:
    """What the certificate of an identity would be, were it true: its evidence is a point."""
    statement, evidence = one.statement, []
    points = PointFinder(finder_of)
    for goal in identities(Problem(statement.goals)):
        at = finder_of(goal.space)
        sides = [side for pair in at.pairs(goal.conclusions[0]) for side in pair]
        evidence.append(evidence_data(Entailment(point=points.point(at, divided=sides))))
    return certificate_text(statement, "holds", evidence)
