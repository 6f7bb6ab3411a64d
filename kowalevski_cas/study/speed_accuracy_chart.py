"""The chart of speed against accuracy: error rates above, and a rail for proof below."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from kowalevski_cas import pictures
from kowalevski_cas.study.names import shown
from kowalevski_cas.study.summary import Summary, pareto

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LINE = 0.24
"""The height in inches of a line of the rail."""


def chart(found: Sequence[Summary]) -> Figure:
    """Time against the error rate or its bound; methods that prove have lines of their own."""
    timed = [summary for summary in found if summary.seconds]
    proofs = sorted((s for s in timed if s.is_proof), key=lambda s: s.time)
    others = sorted((s for s in timed if not s.is_proof), key=lambda s: (-s.rate, s.time))
    lost = [summary for summary in found if not summary.seconds]
    rail = LINE * (len(proofs) + 1.2)
    upper = 3.1
    with pictures.style():
        figure = pictures.new_figure(pictures.WIDTH, upper + rail + 0.9 + 0.15 * len(lost))
        above, below = figure.subplots(
            2, 1, sharex=True, gridspec_kw={"height_ratios": [upper, rail], "hspace": 0.02}
        )
        _times(above, timed)
        _errors(above, others)
        _proofs(below, proofs)
        _front(above, below, pareto(timed), proofs)
        below.set_xlabel("median time for a statement, in a running process")
        above.set_title("How wrong can it be, and how long does it take?")
        for k, summary in enumerate(lost):
            figure.text(0.02, 0.01 + 0.03 * k, _label(summary), size=7.5)
    return figure


def _times(axes: Axes, timed: Sequence[Summary]) -> None:
    """A log axis of time, with words for its ticks and room for labels."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    low = min((s.spread[0] for s in timed), default=1e-3)
    high = max((s.spread[1] for s in timed), default=1.0)
    axes.set_xscale("log")
    axes.set_xlim(low / 2, max(high, low * 10) * 60)
    axes.xaxis.set_major_locator(LogLocator(numticks=20))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(seconds))


def seconds(value: float, _: object = None) -> str:
    """A time in words.

    >>> [seconds(value) for value in (1e-5, 0.01, 1, 100)]
    ['10 µs', '10 ms', '1 s', '100 s']
    """
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= 0.999 * size:
            return f"{value / size:.3g} {unit}"
    return f"{value * 1e9:.3g} ns"


def _errors(axes: Axes, others: Sequence[Summary]) -> None:
    """Points for the methods that may be wrong."""
    axes.set_yscale("log")
    lowest = min((s.rate for s in others), default=0.01)
    axes.set_ylim(min(lowest, 0.01) / 5, 2.2)
    axes.set_ylabel("share of wrong answers, or its bound")
    points, segments = [], []
    for summary in others:
        mark = _mark(summary)
        _point(axes, summary, summary.rate, mark)
        if summary.is_estimate:
            axes.annotate(
                "", (summary.time, summary.rate / 2.6), (summary.time, summary.rate / 1.25),
                arrowprops={"arrowstyle": "-|>", "color": mark.colour, "lw": 0.9},
            )  # fmt: skip
            segments.append((summary.time, summary.rate / 2.6, summary.time, summary.rate))
        low, high = summary.spread
        segments.append((low, summary.rate, high, summary.rate))
        points.append((summary.time, summary.rate, _label(summary)))
    pictures.label_points(axes, points, segments)


def _proofs(axes: Axes, proofs: Sequence[Summary]) -> None:
    """A line for each method whose answers are proofs."""
    axes.set_ylim(len(proofs) - 0.4, -0.9)
    axes.set_yticks([])
    axes.grid(axis="y", visible=False)
    axes.set_facecolor("#f1f5f8")
    axes.set_ylabel("proof")
    for line, summary in enumerate(proofs):
        _point(axes, summary, line, _mark(summary))
        axes.annotate(
            _label(summary), (summary.spread[1], line), (6, 0), textcoords="offset points",
            va="center", size=7.5, color=pictures.INK,
        )  # fmt: skip


def _front(above: Axes, below: Axes, front: Sequence[Summary], proofs: Sequence[Summary]) -> None:
    """The Pareto front, from the fastest method down to the fastest proof."""
    if len(front) < 2:
        return
    bottom = above.get_ylim()[0]
    xs: list[float] = []
    ys: list[float] = []
    for before, after in pairwise(front):
        xs += [before.time, after.time]
        ys += [before.rate, before.rate]
    last = front[-1]
    xs.append(last.time)
    ys.append(bottom if last.is_proof else last.rate)
    line: dict[str, Any] = {"color": pictures.FAINT, "lw": 1.0, "ls": (0, (4, 2)), "zorder": 1}
    above.plot(xs, ys, **line)
    if last.is_proof:
        below.plot([last.time] * 2, [below.get_ylim()[1], proofs.index(last)], **line)


def _point(axes: Axes, summary: Summary, y: float, mark: pictures.Mark) -> None:
    low, high = summary.spread
    axes.plot([low, high], [y, y], color=mark.colour, lw=1.0, solid_capstyle="butt", zorder=2)
    axes.plot(
        [summary.time], [y], color=mark.colour, marker=mark.marker, ls="none", ms=6,
        mfc="white" if summary.is_estimate else mark.colour, zorder=3,
    )  # fmt: skip


def _mark(summary: Summary) -> pictures.Mark:
    """One mark for proofs, one for bounds, one for what was seen to be wrong or may be."""
    return pictures.mark(0 if summary.is_proof else 2 if summary.bound is not None else 1)


def _label(summary: Summary) -> str:
    words = summary.words
    return f"{shown(summary.method)}: {words}" if words else shown(summary.method)
