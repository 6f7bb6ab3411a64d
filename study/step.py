"""What a step of the study has to offer: tasks to measure, and a chart of their rows."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING, Any, Protocol

from kowalevski_cas.tools import MissingTool

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DISAGREEMENT = "disagreement"
"""The verdict where exact arithmetics contradict each other: a bug, whatever else is measured."""

ERROR = "error"
"""The verdict of a measurement that failed: a bug, of the method or of the study."""

LEFT_OUT = "left out"
"""The verdict of a measurement that was not made."""

Measured = Mapping[str, Any]
"""What one measurement found, as JSON: ``seconds``, ``verdict``, ``reason``, and whatever else."""

Row = dict[str, Any]
"""A stored measurement: ``method`` and ``case`` of its task with what was measured."""


@dataclass(frozen=True)
class Task:
    """One measurement: a method on a case.

    ``method`` and ``case`` name the row, once in a step; ``run`` measures it.
    """

    method: str
    case: str
    run: Callable[[], Measured]

    def row(self) -> Row:
        """Measure.

        Where the measurement does not say so itself, the time is that of the whole call, and
        the verdict is ``measured``. An exception is a row with the verdict ``error``, so that
        a method that fails is still seen; what is not installed is left out.
        """
        start = perf_counter()
        try:
            found = self.run()
        except (MissingTool, ModuleNotFoundError) as missing:
            found = {"seconds": None, "verdict": LEFT_OUT, "reason": str(missing)}
        except Exception as error:
            reason = f"{type(error).__name__}: {error}"
            found = {"seconds": None, "verdict": ERROR, "reason": reason}
        usual = {"seconds": perf_counter() - start, "verdict": "measured"}
        return {"method": self.method, "case": self.case, **usual, **found}


class StudyStep(Protocol):
    """A module with these names is a step."""

    TITLE: str
    """What the step measures, in a few words."""

    CAPTION: str
    """What the chart shows, and for which parameters: plain text, mathematics between dollars."""

    def measure(self, quick: bool) -> Iterable[Task]:
        """The tasks in their order; with ``quick`` a few that take seconds together."""

    def draw(self, rows: Sequence[Row]) -> Figure:
        """The chart of these rows; called inside the style of all pictures."""
