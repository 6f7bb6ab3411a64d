"""A way of deciding: it accepts a statement, rejects it, or gives no answer."""

from __future__ import annotations

from abc import ABC, abstractmethod

from study.labelled import Labelled
from study.step import Measured

ACCEPTED, REJECTED, NONE = "accepted", "rejected", "none"
"""The verdicts. A limit that is reached is ``timeout``, a failure ``error``: no answers either."""


class Method(ABC):
    """``proves`` says that an answer of this method is a proof, and an error would be a bug.

    ``share`` is how many statements of the labelled set it is put to, all of them if
    it is ``None``.
    """

    proves = False

    def __init__(self, name: str, share: int | None = None) -> None:
        self.name = name
        self.share = share

    @abstractmethod
    def decide(self, statement: Labelled) -> Measured:
        """The verdict on a statement, with the seconds that it took in a running process."""

    @abstractmethod
    def cold(self, statement: Labelled) -> float:
        """The seconds from the start of a process of its own to the verdict on a true statement."""
