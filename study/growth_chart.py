"""The chart of how cost grows: time and memory against k, for each method, side by side."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

from kowalevski_cas import pictures
from study.charts import marked, names, seconds, shown, size
from study.step import Row

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WORDS = {"complex": "complex variables: (15)", "real": "real variables: (16)"}
PANELS = {
    "times": ("time until step $k$ is decided", seconds, (2e-4, 30.0)),
    "memory": ("most memory so far", size, (6e6, 4e9)),
}
"""The words, the units and the limits of each axis, by what is drawn along it."""


def chart(rows: Sequence[Row]) -> Figure:
    """A column a case: above the time until the k-th identity is decided, below the memory."""
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    marks = {method: mark for mark, method in marked(names(rows, "method"))}
    figure = pictures.new_figure(height=7.0)
    grid = figure.add_gridspec(3, len(WORDS), height_ratios=[3, 3, 1.35])
    notes = figure.add_subplot(grid[2, :])
    for column, case in enumerate(WORDS):
        for line, (key, (words, units, limits)) in enumerate(PANELS.items()):
            axes = figure.add_subplot(grid[line, column])
            for row in rows:
                if row["case"] == case:
                    _line(axes, row, key, marks[row["method"]])
            axes.set(yscale="log", ylim=limits)
            axes.xaxis.set_major_locator(MaxNLocator(integer=True))
            axes.yaxis.set_major_formatter(FuncFormatter(units))
            if column == 0:
                axes.set_ylabel(words)
            else:
                axes.yaxis.set_tick_params(labelleft=False)
            if line == 0:
                axes.set_title(WORDS[case], size=8.5)
                found = axes.get_legend_handles_labels()
                legend = notes.legend(*found, loc="upper center", ncols=4, borderaxespad=0)
                legend.set_in_layout(False)
        axes.set_xlabel("$k$")
    notes.axis("off")
    stops = "\n".join(_stops(rows, case) for case in WORDS)
    notes.text(0, 0.5, stops, size=7.3, va="top").set_in_layout(False)
    return figure


def _line(axes: Axes, row: Row, key: str, mark: pictures.Mark) -> None:
    """What was reached; a cross over the end where a limit stopped it."""
    pairs = [(k, v) for k, v in zip(row["steps"], row[key], strict=True) if v]
    if not pairs:
        return
    xs, ys = zip(*pairs, strict=True)
    axes.plot(xs, ys, ms=3.6, label=shown(row["method"]), **mark.line)
    if row["verdict"] != "reached":
        axes.plot(xs[-1:], ys[-1:], color=pictures.INK, marker="x", ms=7, ls="none", mew=1.1)


def _stops(rows: Sequence[Row], case: str) -> str:
    """In words, how far each method came and which limit stopped it."""
    parts = [
        f"{shown(row['method'])} {max(row['steps'], default=0)}"
        + (f" ({row['reason']})" if row["verdict"] != "reached" else "")
        for row in rows
        if row["case"] == case
    ]
    words = f"Last k in {case} variables (× where a limit stopped it): {', '.join(parts)}."
    return textwrap.fill(words, 106)
