"""A step with a few trivial methods, and functions for a worker."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from pathlib import Path

from study import Measured, Row, Task

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

    def draw(self, rows: Sequence[Row], folder: Path) -> None:
        (folder / "toys.txt").write_text("\n".join(row["method"] for row in rows))


def double(question: float) -> Measured:
    return {"verdict": "proved", "answer": 2 * question}


def sleep(question: float) -> Measured:
    time.sleep(question)
    return {"verdict": "proved"}


def swell(question: int) -> Measured:
    return {"verdict": "proved", "size": len(bytearray(question * 2**20))}


def fail(question: str) -> Measured:
    raise ValueError(question)
