"""Where methods fail: a way to fail is one module here, and a line in :data:`WAYS`.

Each has a ``TITLE``, a ``CAPTION``, ``measure`` and ``draw``, as a step has, but draws a panel.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Protocol, cast

from kowalevski_cas.pictures import new_figure
from study.failures import branch, cancellation, differences, phase, primes, separatrix
from study.step import Row, Task

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


class Way(Protocol):
    """A way to fail; the rows of its tasks have its name as their case."""

    TITLE: str
    CAPTION: str

    def measure(self, quick: bool) -> Iterable[Task]:
        """The tasks, one a method."""

    def draw(self, axes: Axes, rows: Sequence[Row]) -> None:
        """The panel."""


WAYS = {
    "differences": cast(Way, differences),
    "primes": cast(Way, primes),
    "branch": cast(Way, branch),
    "cancellation": cast(Way, cancellation),
    "separatrix": cast(Way, separatrix),
    "phase": cast(Way, phase),
}
"""The ways to fail: verdicts in the upper line of the chart, digits in the lower one."""

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
