"""The phase point on N⁴ by a tower of quadratic generators, and by square roots in SymPy.

The three geometric integrals and the nine equations of motion are identities in the
separated variables and four square roots. Here they are proved in the exact
arithmetics, each time in a ring made anew, and put to SymPy's simplifiers as one
would type them, with ``sqrt``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from time import perf_counter
from typing import TYPE_CHECKING

from kowalevski_cas.algebra import EXACT, load
from kowalevski_cas.pictures import new_figure
from study.charts import legend_below, list_cases, marked, names, split
from study.labelled import holds
from study.methods.certificates import CALLS, MEBIBYTES, TARGET
from study.paper import paper
from study.step import Measured, Row, Task
from study.worker import asked

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "the phase point on N⁴: a tower of roots against square roots in SymPy"

PAPER = "kharlamov_savushkin2004"

CLAIMS = tuple(
    f"point.{name}" for name in ("a", "b", "c", "alpha", "beta", "omega_1", "omega_2", "omega_3")
)
"""The geometric integrals and the equations of motion; α and β have three components each."""

SECONDS = 120.0

TRUE = ("proved", "conditional", "accepted")


def measure(quick: bool) -> Iterable[Task]:
    """Each method on each claim."""
    for id in CLAIMS[:3] if quick else CLAIMS:
        for method in EXACT:
            yield Task(method, id, partial(_proved, method, id))
        for call in CALLS[:3] if quick else CALLS:
            yield Task(f"SymPy {call}", id, partial(_typed, call, id))


def _proved(method: str, id: str) -> Measured:
    """The verdict of an exact arithmetic; its library is loaded before the clock starts."""
    problem = paper(PAPER).statement(id).problem
    load(method)
    start = perf_counter()
    verdict = "proved" if holds(problem, method) else "refuted"
    return {"seconds": perf_counter() - start, "verdict": verdict, "reason": ""}


def _typed(call: str, id: str) -> Measured:
    question = {"method": call, "certificate": paper(PAPER).certificates[id].data}
    return asked(TARGET, SECONDS, MEBIBYTES, question)


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Time for each claim, a mark a method; hollow where the truth was not recognised."""
    methods, cases = names(rows, "method"), names(rows, "case")
    figure = new_figure(height=3.7)
    axes = figure.subplots()
    for index, (mark, method) in enumerate(marked(methods)):
        mine = [row for row in rows if row["method"] == method and row["seconds"] is not None]
        apart = 0.08 * (index - len(methods) / 2)
        total = sum(row["seconds"] for row in mine)
        split(
            axes,
            mark,
            [(r["seconds"], cases.index(r["case"]) + apart, r["verdict"] in TRUE) for r in mine],
            f"{method}, {total:.2g} s",
        )
    xlabel = "seconds; hollow where the method does not see that the statement is true"
    list_cases(axes, cases, xlabel)
    legend_below(figure, axes, 3, title="each method, and its time for all")
    return {"phase-point": figure}
