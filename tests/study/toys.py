"""A step with a few trivial methods; as a program, a worker that does as it is told."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from kowalevski_cas.pictures import new_figure
from study import Measured, Row, Task
from study.process import serve

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "toys"
CAPTION = "Some methods, and what $x$ costs."


class Interrupt:
    """The step of this module, with a list of what was run and a task that may interrupt."""

    TITLE, CAPTION = TITLE, CAPTION

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

    def draw(self, rows: Sequence[Row]) -> Figure:
        figure = new_figure(2, 1)
        figure.suptitle(" ".join(row["method"] for row in rows))
        return figure


def told(question: list) -> Measured:
    """Double a number, sleep, take memory, end, or fail."""
    word, value = question
    if word == "sleep":
        time.sleep(value)
    if word == "swell":
        bytearray(value * 2**20)
    if word == "end":
        os._exit(value)
    if word == "fail":
        print("what a library prints")
        raise ValueError(value)
    return {"verdict": "proved", "answer": 2 * value}


if __name__ == "__main__":
    print("what a library prints", file=sys.stderr)
    serve(told)
