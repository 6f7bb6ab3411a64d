"""Speed against accuracy: each method is put to statements of which the truth is known."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import groupby, zip_longest
from math import inf
from statistics import median, quantiles
from typing import TYPE_CHECKING, Any

from kowalevski_cas.library import available
from kowalevski_cas.pictures import INK, PlotMark, mark, new_figure
from study.charts import digit, display_name, points, seconds
from study.labelled import ArithmeticDisagreement, Labelled, labelled_set, spread
from study.methods import ACCEPTED, REJECTED, STARTED, ExportProgram, Method, methods
from study.step import DISAGREEMENT, Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

TITLE = "speed against accuracy"

MUTANTS = 3
"""How many mutants are taken of each statement."""

MOST, QUICK = 300, 6
"""How many statements a method is put to at most, and in a quick study."""

STARTS, QUICK_STARTS = 25, 1
"""How often a program that is started for each statement is started for nothing."""

GROUNDS = "#e9f0f5", "white"
"""What the classes stand on, in turn."""

CAPTION = (
    "How long a method takes for a statement, and how sure its answer is. Each was put to "
    f"identities of the derivations, to misprints, {MUTANTS} one-token mutants and near misses of "
    f"each: at most {MOST} statements, half of them true, fewer where a method is slow. Three "
    "exact arithmetics, which agree, say which are true. A mark is the median time, a bar spans "
    "eight of ten. A full disc: the answers are proofs, and none was wrong; hollow: not all was "
    "answered. A triangle: a bound is guaranteed. A hollow square: no error in $n$ trials; a share "
    "above $3/n$ would have been seen with a chance of 95 %. A full square: wrong answers were "
    "seen. Exact arithmetics, points, the checker and SymPy answer in a process that runs; the "
    "other programs are started for each statement, which is counted: a tick is what they take for "
    f"$x=x$, as the median of {STARTS} starts. All times are of the processor. Floating point is "
    "slower than a proof: it looks at 64 points at once, in many small steps by NumPy, and each "
    "carries the size of what was rounded."
)


def measure(quick: bool) -> Iterable[Task]:
    """Each method on each statement of its share.

    Methods take turns, so that a noisy moment of the machine touches all of them.
    """
    statements = labelled_set(1, available()[:1]) if quick else labelled_set(MUTANTS)
    turns = []
    for method in methods():
        most = min(method.share or MOST, QUICK if quick else MOST)
        share = spread(statements, most)
        tasks = [Task(method.name, s.id, partial(_decide, method, s)) for s in share]
        if isinstance(method, ExportProgram):
            many = QUICK_STARTS if quick else STARTS
            for k in range(many):  # among the others
                tasks.insert(
                    k * len(share) // many + k, Task(method.name, f"start {k + 1}", method.start)
                )
        turns.append(tasks)
    return (task for turn in zip_longest(*turns) for task in turn if task is not None)


def _decide(method: Method, statement: Labelled) -> Measured:
    found = {**method.decide(statement), "kind": statement.kind, "proves": method.proves}
    try:
        return {**found, "truth": statement.truth}
    except ArithmeticDisagreement as error:
        return {**found, "verdict": DISAGREEMENT, "reason": str(error)}


# -- what the rows say together --------------------------------------------------------


@dataclass(frozen=True)
class Summary:
    """The measurements of one method, of which at least one took time, and its starts."""

    method: str
    rows: Sequence[Row]
    starts: Sequence[Row] = ()

    @cached_property
    def counts(self) -> Counter[tuple[str, bool]]:
        """How many true and how many false statements it got right or wrong, or left open."""
        return Counter((_outcome(row), row["truth"]) for row in self.rows if "truth" in row)

    @property
    def wrong(self) -> int:
        """How many answers are wrong."""
        return self.counts["wrong", True] + self.counts["wrong", False]

    @property
    def answers(self) -> int:
        """How many statements it accepts or rejects."""
        return self.wrong + self.counts["right", True] + self.counts["right", False]

    @cached_property
    def times(self) -> tuple[float, float, float]:
        """The median time for a statement, and those between which eight of ten lie."""
        found = [row["seconds"] for row in self.rows if row.get("seconds") is not None]
        deciles = quantiles(found, n=10, method="inclusive") if len(found) > 1 else found
        return median(found), deciles[0], deciles[-1]

    @property
    def start(self) -> float | None:
        """The median time for a start; none if it is not started for each statement."""
        return median(row["seconds"] for row in self.starts) if self.starts else None

    @property
    def grade(self) -> tuple[int, float, str]:
        """How sure an answer is, to be sorted, and in words."""
        bounds = [row["bound"] for row in self.rows if row.get("bound") is not None]
        if self.wrong or not self.answers:
            return 3, self.wrong, "wrong answers seen" if self.wrong else "no answer"
        if any(row["proves"] for row in self.rows):
            return 0, 0.0, "proof"
        if bounds:
            return 1, max(bounds), f"chance of error ≤ {digit(max(bounds))}"
        return 2, 1 / self.answers, f"0 of {self.answers} wrong: ≤ 3/{self.answers}"

    @property
    def words(self) -> str:
        """What went wrong, in a few words; empty if nothing did."""
        of = Counter(row.get("truth") for row in self.rows)
        parts = {
            outcome: ", ".join(
                f"{self.counts[outcome, truth]} of {of[truth]} {word}"
                for truth, word in ((True, "true"), (False, "false"))
                if self.counts[outcome, truth]
            )
            for outcome in ("wrong", "no answer")
        }
        return "; ".join(f"{outcome}: {shares}" for outcome, shares in parts.items() if shares)


def _outcome(row: Row) -> str:
    if row["verdict"] not in (ACCEPTED, REJECTED):
        return "no answer"
    return "right" if (row["verdict"] == ACCEPTED) is row["truth"] else "wrong"


def summaries(rows: Iterable[Row]) -> list[Summary]:
    """One summary a method that was measured, the surest first, then the fastest."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row["method"], []).append(row)
    timed = []
    for method, mine in found.items():
        starts = [row for row in mine if row["verdict"] == STARTED]
        others = [row for row in mine if row["verdict"] != STARTED]
        if any(row.get("seconds") is not None for row in others):
            timed.append(Summary(method, others, starts))
    return sorted(timed, key=lambda summary: (summary.grade, summary.times))


# -- the chart -------------------------------------------------------------------------


def draw(rows: Sequence[Row]) -> Figure:
    """A line a method, by classes from the surest down; time along the axis."""
    found = summaries(rows)
    figure = new_figure(height=0.9 + 0.27 * len(found))
    axes = figure.subplots()
    _times(axes, found)
    top = end = -0.5
    for number, (words, group) in enumerate(groupby(found, key=lambda summary: summary.grade[2])):
        ground = GROUNDS[number % 2]
        for one in group:
            _line(axes, end + 0.5, one, ground)
            end += 1
        axes.axhspan(top, end, color=ground, zorder=0, lw=0)
        middle, places = (top + end) / 2, axes.get_yaxis_transform()
        axes.text(1.02, middle, words, va="center", transform=places)
        top = end
    if found:
        fastest = min(found, key=lambda summary: summary.times)
        time = fastest.times[0]
        axes.axvline(time, color=INK, lw=0.9, ls=(0, (4, 2)), zorder=1)
        kind, name = fastest.grade[2].partition(":")[0], display_name(fastest.method)
        words = f"the fastest answer: {kind}, by {name} in {seconds(time)}"
        axes.set_title(words, weight="bold")
    most = max((len(summary.rows) for summary in found), default=0)
    axes.set_yticks(range(len(found)), [_label(summary, most) for summary in found])
    axes.set(
        ylim=(len(found) - 0.5, -0.5),
        xlabel="processor time for a statement: median, and eight of ten",
    )
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0)
    return figure


def _label(one: Summary, most: int) -> str:
    """The name of a method, with the number of its statements if others were put to more."""
    many = len(one.rows)
    return display_name(one.method) + (f", $n={many}$" if many < most else "")


def _times(axes: Axes, found: Sequence[Summary]) -> None:
    """A log axis of time, with words for its ticks."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    axes.set_xscale("log")
    axes.set_xlim(
        min((min(s.times[1], s.start or inf) for s in found), default=1e-3) / 2,
        max((s.times[2] for s in found), default=1.0) * 2,
    )
    axes.xaxis.set_major_locator(LogLocator())
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(seconds))


def _line(axes: Axes, line: float, one: Summary, ground: str) -> None:
    """The mark and the bar of a method, and what went wrong beside them, on its ground."""
    from matplotlib.patheffects import withStroke

    time, low, high = one.times
    look, full = _mark(one)
    axes.plot([low, high], [line, line], color=look.colour, lw=1.0, zorder=2)
    if one.start is not None:
        axes.plot([one.start], [line], color=look.colour, marker="|", ms=11, mew=1.6, zorder=2)
    axes.plot([time], [line], zorder=3, ms=6, **points(look, full))
    if one.words:
        left, right = axes.get_xlim()
        after = low * high < left * right  # where there is more room
        text: dict[str, Any] = {"ha": "left" if after else "right", "va": "center", "size": 6.5}
        words = re.sub("[;,] ", "\n", one.words)
        axes.annotate(
            words, (high if after else low, line), (5 if after else -5, 0),
            textcoords="offset points", path_effects=[withStroke(linewidth=2.5, foreground=ground)],
            **text,
        )  # fmt: skip


def _mark(one: Summary) -> tuple[PlotMark, bool]:
    """A mark a class, and whether it is full: all was answered, or an error was seen."""
    kind = one.grade[0]
    full = one.answers == len(one.rows) if kind < 2 else kind == 3
    return mark((0, 2, 1, 1)[kind]), full
