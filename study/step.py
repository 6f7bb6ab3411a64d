"""What a step of the study has to offer: tasks to measure, and a picture of their rows."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

DISAGREEMENT = "disagreement"
"""The verdict where exact arithmetics contradict each other: a bug, whatever else is measured."""

Measured = Mapping[str, Any]
"""What one measurement found, as JSON: ``seconds``, ``verdict``, ``reason``, and whatever else."""

Row = dict[str, Any]
"""A stored measurement: ``method`` and ``case`` of its task with what was measured."""


@dataclass(frozen=True)
class Task:
    """One measurement: a method on a case.

    ``method`` and ``case`` name the row, once in a step; ``run`` measures it. An
    exception becomes a row with the verdict ``error``, so that a method that fails
    is still seen.
    """

    method: str
    case: str
    run: Callable[[], Measured]


class Step(Protocol):
    """A module with these names is a step."""

    TITLE: str
    """What the step measures, in a few words."""

    def measure(self, quick: bool) -> Iterable[Task]:
        """The tasks in their order; with ``quick`` a few that take seconds together."""

    def draw(self, rows: Sequence[Row], folder: Path) -> None:
        """Write pictures and tables of these rows into the folder, the same for the same rows."""
