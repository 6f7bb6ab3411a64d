"""A step with a few trivial methods, and functions for a worker."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from kowalevski_cas.pictures import new_figure
from study import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "toys"


class Interrupt:
    """The step of this module, with a list of what was run and a task that may interrupt."""

    TITLE = TITLE

    def __init__(self, at: str = "") -> None:
        self.at = at
        self.ran: list[str] = []

    def measure(self, quick: bool) -> Iterable[Task]:
        for method in ("good", "bad", "slow"):
            yield Task(method, "one", lambda method=method: self._run(method))

    def _run(self, method: str) -> Measured:
        if method == self.at:
            raise KeyboardInterrupt
        self.ran.append(method)
        if method == "bad":
            raise ValueError("it cannot")
        return {"seconds": 0.5, "verdict": "proved", "reason": ""}

    def draw(self, rows: Sequence[Row]) -> dict[str, Figure]:
        figure = new_figure(2, 1)
        figure.suptitle(" ".join(row["method"] for row in rows))
        return {"toys": figure}


def double(question: float) -> Measured:
    return {"verdict": "proved", "answer": 2 * question}


def sleep(question: float) -> Measured:
    time.sleep(question)
    return {"verdict": "proved"}


def swell(question: int) -> Measured:
    return {"verdict": "proved", "size": len(bytearray(question * 2**20))}


def end(question: int) -> Measured:
    if question:
        os._exit(question)
    return {"verdict": "proved"}


def fail(question: str) -> Measured:
    raise ValueError(question)
