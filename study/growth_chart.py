"""The chart of how cost grows: time and memory against k, for each method, side by side."""

from __future__ import annotations

import csv
import io
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

from kowalevski_cas import pictures
from study.names import shown
from study.speed_accuracy_chart import seconds
from study.step import Row

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WORDS = {
    "complex": "complex variables: (15)",
    "real": "real variables: (16)",
}
KEYS = {"times": "time until step $k$ is decided", "memory": "most memory so far"}
LIMITS = {"times": (2e-4, 30.0), "memory": (6e6, 4e9)}


def chart(rows: Sequence[Row], cases: Sequence[str]) -> Figure:
    """A column a case: above the time until the k-th identity is decided, below the memory."""
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    methods = list(dict.fromkeys(row["method"] for row in rows))
    marks = {method: pictures.mark(k) for k, method in enumerate(methods)}
    with pictures.style():
        figure = pictures.new_figure(pictures.WIDTH, 7.0)
        grid = figure.add_gridspec(3, len(cases), height_ratios=[3, 3, 1.35])
        notes = figure.add_subplot(grid[2, :])
        for column, case in enumerate(cases):
            own = [row for row in rows if row["case"] == case]
            for line, (key, words) in enumerate(KEYS.items()):
                axes = figure.add_subplot(grid[line, column])
                for row in own:
                    _line(axes, row, key, marks[row["method"]])
                axes.set_yscale("log")
                axes.set_ylim(LIMITS[key])
                axes.xaxis.set_major_locator(MaxNLocator(integer=True))
                axes.yaxis.set_major_formatter(FuncFormatter(UNITS[key]))
                if column == 0:
                    axes.set_ylabel(words)
                else:
                    axes.yaxis.set_tick_params(labelleft=False)
                if line == 0:
                    axes.set_title(WORDS[case], size=8.5)
                    found = axes.get_legend_handles_labels()
                    notes.legend(
                        *found, loc="upper center", ncols=4, borderaxespad=0
                    ).set_in_layout(False)
            axes.set_xlabel("$k$")
        notes.axis("off")
        stops = (_stops([row for row in rows if row["case"] == case], case) for case in cases)
        said = notes.text(0, 0.5, "\n".join(stops), size=7.3, va="top")
        said.set_in_layout(False)
    return figure


def _line(axes: Axes, row: Row, key: str, mark: pictures.Mark) -> None:
    """What was reached; a cross over the end where a limit stopped it."""
    pairs = [(k, v) for k, v in zip(row["steps"], row[key], strict=True) if v]
    if not pairs:
        return
    xs, ys = zip(*pairs, strict=True)
    axes.plot(
        xs,
        ys,
        color=mark.colour,
        marker=mark.marker,
        ls=mark.dashes,
        ms=3.6,
        label=shown(row["method"]),
    )
    if row["verdict"] != "reached":
        axes.plot(xs[-1:], ys[-1:], color=pictures.INK, marker="x", ms=7, ls="none", mew=1.1)


def _stops(rows: Sequence[Row], case: str) -> str:
    """In words, how far each method came and which limit stopped it."""
    parts = [
        f"{shown(row['method'])} {max(row['steps'], default=0)}"
        + (f" ({row['reason']})" if row["verdict"] != "reached" else "")
        for row in rows
    ]
    words = f"Last k in {case} variables (× where a limit stopped it): {', '.join(parts)}."
    return textwrap.fill(words, 106)


def size(value: float, _: object = None) -> str:
    """Bytes in words.

    >>> [size(value) for value in (1e6, 1e8, 1e10)]
    ['1 MB', '100 MB', '10 GB']
    """
    return f"{value / 1e9:.3g} GB" if value >= 1e9 else f"{value / 1e6:.3g} MB"


UNITS = {"times": seconds, "memory": size}


def table(rows: Sequence[Row]) -> str:
    """Every step of every method as CSV."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["variables", "method", "k", "seconds", "bytes", "stopped by"])
    for row in rows:
        for k, time, memory in zip(row["steps"], row["times"], row["memory"], strict=True):
            stop = row["reason"] if k == row["steps"][-1] else ""
            writer.writerow([row["case"], row["method"], k, time, memory or "", stop])
        if not row["steps"]:
            writer.writerow([row["case"], row["method"], 0, "", "", row["reason"]])
    return text.getvalue()
