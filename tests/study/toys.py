"""A step with a few trivial methods."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from kowalevski_cas.pictures import new_figure
from study import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "toys"
CAPTION = "Some methods, and what $x$ costs."


class Interrupt:
    """The step of this module, with a list of what was run and tasks that may interrupt or fail."""

    TITLE, CAPTION = TITLE, CAPTION

    def __init__(self, at: str = "", fails: str = "") -> None:
        self.at, self.fails = at, fails
        self.ran: list[str] = []

    def measure(self, quick: bool) -> Iterable[Task]:
        for method in ("good", "fair", "slow"):
            yield Task(method, "one", lambda method=method: self._run(method))

    def _run(self, method: str) -> Measured:
        if method == self.at:
            raise KeyboardInterrupt
        self.ran.append(method)
        if method == self.fails:
            raise ValueError("it cannot")
        return {"seconds": 0.5, "verdict": "proved", "reason": ""}

    def draw(self, rows: Sequence[Row]) -> Figure:
        figure = new_figure(2, 1)
        figure.suptitle(" ".join(row["method"] for row in rows))
        return figure
