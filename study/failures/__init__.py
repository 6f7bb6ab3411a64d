"""Where methods fail: a way to fail is one module here, and a line in :data:`WAYS`.

Each has a ``TITLE``, a ``CAPTION`` and ``measure`` as a step has, and ``draw(axes, rows)`` for its
panel. The rows of its tasks, one a method, have its name as their case.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from matplotlib.figure import Figure

from kowalevski_cas.pictures import new_figure
from study.failures import branch, cancellation, differences, phase, primes, separatrix
from study.step import Row, Task

WAYS: dict[str, Any] = {
    "differences": differences,
    "primes": primes,
    "branch": branch,
    "cancellation": cancellation,
    "separatrix": separatrix,
    "phase": phase,
}
"""The modules: verdicts in the upper line of the chart, digits in the lower one."""

TITLE = "where methods fail"

CAPTION = " ".join(f"*{way.TITLE}*: {way.CAPTION}." for way in WAYS.values())


def measure(quick: bool) -> Iterable[Task]:
    """The tasks of all ways."""
    for way in WAYS.values():
        yield from way.measure(quick)


def draw(rows: Sequence[Row]) -> Figure:
    """A panel a way; below, relative errors on the same scale."""
    figure = new_figure(height=5.2)
    panels = figure.subplots(2, 3)
    for axes, (name, way) in zip(panels.flat, WAYS.items(), strict=True):
        way.draw(
            axes, [row for row in rows if row["case"] == name and row["verdict"] == "measured"]
        )
        axes.set_title(way.TITLE, size=8.5)
        for line in axes.lines:
            line.set(ms=3.2, lw=1.0)
    for axes in panels[1]:
        axes.set(yscale="log", ylim=(1e-20, 30))
        axes.yaxis.set_tick_params(labelleft=axes is panels[1, 0])
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.25), borderaxespad=0)
    panels[1, 0].set_ylabel("relative error")
    return figure
