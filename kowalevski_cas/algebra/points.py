"""What the arithmetics of points have in common: a question to points, and an answer."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from kowalevski_cas.algebra.programs import Program, Programs

ExactPoint = Mapping[str, tuple[Fraction, Fraction]]
"""Real and imaginary parts of the generators."""


class NoPoint(ValueError):
    """No point could be found; the message says why."""


class Question(NamedTuple):
    """Whether ``residuals`` vanish wherever ``given`` do; or whether a matrix has a rank there.

    ``rows`` are those of a matrix that has the rank ``rank`` at almost every point.
    One of ``somewhere`` is non-zero at almost every point.
    """

    ring: Programs
    residuals: Sequence[Program] = ()
    given: Sequence[Program] = ()
    rows: Sequence[Sequence[Program]] = ()
    rank: int = 0
    somewhere: Sequence[Program] = ()

    def programs(self) -> list[Program]:
        """Everything that is evaluated at a point."""
        return [*self.residuals, *self.somewhere, *(entry for row in self.rows for entry in row)]


class Answer(NamedTuple):
    """What points say: yes, no (at this point), or nothing (``holds`` is ``None``) for a reason.

    ``bound`` is the chance of a wrong yes, ``radius`` that of the largest ball around a residual.
    """

    holds: bool | None
    words: str = ""
    bound: float | None = None
    radius: float | None = None
    point: Mapping[str, str] = {}
    left: str = ""
    right: str = "0"


class Points(ABC):
    """Numbers of one kind, and what they say at points. ``seed`` chooses the points."""

    name: str

    def __init__(self, seed: int) -> None:
        self.seed = seed

    @abstractmethod
    def answer(self, question: Question) -> Answer:
        """What this arithmetic says to a question."""
