"""The chart of speed against accuracy: error rates above, and a rail for proof below."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from kowalevski_cas import pictures
from study.charts import seconds, shown
from study.summary import Summary, pareto

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

LINE = 0.22
"""The height in inches of a line of the rail."""

SEEN, BOUND = 2.6, 0.55
"""The heights in inches of the part with measured shares, and of that with guaranteed bounds."""

COLUMN = 0.52
"""Where the column of labels begins, as a share of the width."""

APART = 1.14
"""The factor by which points are drawn apart that would cover each other."""


def chart(found: Sequence[Summary]) -> Figure:
    """Time against the error rate or its bound; methods that prove have lines of their own.

    The axis of errors is broken between shares that can be measured and guaranteed bounds.
    """
    timed = [summary for summary in found if summary.seconds]
    proofs = sorted((s for s in timed if s.is_proof), key=lambda s: s.time)
    bounds = [s for s in timed if not s.is_proof and not s.errors and s.bound is not None]
    others = [s for s in timed if not s.is_proof and s not in bounds]
    lost = [summary for summary in found if not summary.seconds]
    heights = [SEEN, BOUND, LINE * (len(proofs) + 1.2)]
    figure = pictures.new_figure(height=sum(heights) + 1.05 + 0.15 * len(lost))
    layout: Any = figure.get_layout_engine()
    layout.set(hspace=0, h_pad=0.02)
    seen, bound, rail = figure.subplots(3, 1, sharex=True, gridspec_kw={"height_ratios": heights})
    _times(seen, timed)
    _errors(seen, others, (0.5, 3.0))
    _errors(bound, bounds, (30.0, 30.0))
    _proofs(rail, proofs)
    for axes, methods in ((seen, others), (bound, bounds)):
        ends = [(s.spread[1], rate, _label(s)) for s, rate in apart(methods)]
        pictures.label_column(axes, ends, COLUMN)
    ends = [(s.spread[1], line, _label(s)) for line, s in enumerate(proofs)]
    pictures.label_column(rail, ends, COLUMN)
    _front((seen, bound, rail), pareto(timed), proofs)
    _broken(seen, bound)
    figure.legend(
        handles=_handles(),
        loc="outside lower center",
        ncols=5,
        fontsize=7,
        columnspacing=1.2,
        handletextpad=0.1,
    )
    seen.set_ylabel("share of wrong answers")
    bound.set_ylabel("bound")
    rail.set_xlabel("time for a statement in a running process: median, and eight of ten")
    seen.set_title("How wrong can it be, and how long does it take?")
    for k, summary in enumerate(lost):
        figure.text(0.02, 0.01 + 0.03 * k, _label(summary), size=7.5)
    return figure


def _times(axes: Axes, timed: Sequence[Summary]) -> None:
    """A log axis of time, with words for its ticks and room for labels."""
    from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

    low = min((s.spread[0] for s in timed), default=1e-3) / 2
    high = max((s.spread[1] for s in timed), default=1.0) * 1.3
    axes.set_xscale("log")
    axes.set_xlim(low, low * (high / low) ** (1 / COLUMN))
    powers = (10.0**k for k in range(-9, 9))
    axes.xaxis.set_major_locator(FixedLocator([t for t in powers if low <= t <= 2 * high]))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(seconds))


def _errors(axes: Axes, methods: Sequence[Summary], room: tuple[float, float]) -> None:
    """Points for methods that may be wrong; ``room`` is that above and below, as factors."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    axes.set_yscale("log")
    rates = [summary.rate for summary in methods] or [0.1]
    above, below = room
    axes.set_ylim(min(rates) / below, min(1.0, max(rates)) * above if above > 1 else 1.0)
    axes.yaxis.set_major_locator(LogLocator(numticks=4))
    if above > 1:
        axes.yaxis.set_minor_locator(NullLocator())
    else:
        axes.yaxis.set_major_formatter(FuncFormatter(lambda share, _: f"{100 * share:.3g} %"))
    axes.spines["bottom"].set_visible(False)
    axes.xaxis.set_tick_params(length=0)
    for summary, rate in apart(methods):
        mark = _mark(summary)
        _point(axes, summary, rate, mark)
        if summary.is_estimate:
            axes.annotate(
                "", (summary.time, rate), (0, -13), textcoords="offset points",
                arrowprops={"arrowstyle": "<|-", "color": mark.colour, "lw": 0.9, "shrinkB": 3},
            )  # fmt: skip


def apart(methods: Sequence[Summary]) -> list[tuple[Summary, float]]:
    """The methods with the heights at which they are drawn: equal ones a little apart."""
    found: list[tuple[Summary, float]] = []
    for summary in sorted(methods, key=lambda s: (s.rate, -s.spread[1])):
        lowest = found[-1][1] * APART if found else 0.0
        found.append((summary, max(summary.rate, lowest)))
    return found


def _broken(above: Axes, below: Axes) -> None:
    """The two short strokes that say that an axis is broken."""
    style: dict[str, Any] = {
        "marker": [(-1, -0.6), (1, 0.6)], "markersize": 7, "ls": "none", "color": pictures.INK,
        "mew": 0.8, "clip_on": False,
    }  # fmt: skip
    above.plot([0], [0], transform=above.transAxes, **style)
    below.plot([0], [1], transform=below.transAxes, **style)


def _proofs(axes: Axes, proofs: Sequence[Summary]) -> None:
    """A line for each method whose answers are proofs."""
    axes.set_ylim(len(proofs) - 0.4, -0.8)
    axes.set_yticks([])
    axes.grid(axis="y", visible=False)
    axes.set_facecolor("#eef3f7")
    axes.set_ylabel("proof")
    for line, summary in enumerate(proofs):
        _point(axes, summary, line, _mark(summary))


def _front(parts: Sequence[Axes], front: Sequence[Summary], proofs: Sequence[Summary]) -> None:
    """The Pareto front, from the fastest method down to the fastest proof, part by part."""
    line: dict[str, Any] = {"color": pictures.INK, "lw": 0.9, "ls": (0, (4, 2)), "zorder": 1}
    ring: dict[str, Any] = {"color": pictures.INK, "ls": "none", "zorder": 4}
    for part, axes in enumerate(parts):
        bottom, top = axes.get_ylim()
        own = [s for s in front if _part(s) == part]
        above = [s for s in front if _part(s) < part]
        xs, ys = ([above[-1].time], [top]) if above else ([], [])
        for summary in own:
            y = proofs.index(summary) if summary.is_proof else summary.rate
            axes.plot([summary.time], [y], marker="o", ms=12, mfc="none", mew=0.9, **ring)
            if xs:
                xs, ys = [*xs, summary.time], [*ys, ys[-1]]
            xs, ys = [*xs, summary.time], [*ys, y]
        if any(_part(s) > part for s in front) and xs:
            xs, ys = [*xs, xs[-1]], [*ys, bottom]
        axes.plot(xs, ys, **line)


def _part(summary: Summary) -> int:
    """In which part of the chart a method is."""
    return 2 if summary.is_proof else 0 if summary.errors or summary.bound is None else 1


def _point(axes: Axes, summary: Summary, y: float, mark: pictures.Mark) -> None:
    low, high = summary.spread
    axes.plot([low, high], [y, y], color=mark.colour, lw=1.0, solid_capstyle="butt", zorder=2)
    axes.plot(
        [summary.time], [y], color=mark.colour, marker=mark.marker, ls="none", ms=6,
        mfc="white" if summary.is_estimate else mark.colour, zorder=3,
    )  # fmt: skip


def _handles() -> list[Line2D]:
    """What the markers mean."""
    from matplotlib.lines import Line2D

    words = {
        "measured": (1, True),
        "no error seen: at most": (1, False),
        "guaranteed bound": (2, True),
        "proof": (0, True),
    }
    handles = [
        Line2D(
            [], [], color=(mark := pictures.mark(k)).colour, marker=mark.marker, ls="none", ms=5,
            mfc=mark.colour if full else "white", label=label,
        )
        for label, (k, full) in words.items()
    ]  # fmt: skip
    ring = Line2D([], [], color=pictures.INK, marker="o", ls="none", ms=8, mfc="none")
    ring.set_label("none is faster and surer")
    return [*handles, ring]


def _mark(summary: Summary) -> pictures.Mark:
    """One mark for proofs, one for bounds, one for what was seen to be wrong or may be."""
    return pictures.mark(0 if summary.is_proof else 2 if summary.bound is not None else 1)


def _label(summary: Summary) -> str:
    words = summary.words
    return f"{shown(summary.method)}: {words}" if words else shown(summary.method)
