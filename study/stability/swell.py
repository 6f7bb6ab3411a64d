r"""Expression swell: the largest claims, under a limit of time and memory for each method.

The identity :math:`F_2'=(U_1+U_2)F_1/\sqrt\theta` is true, and so are its derivatives; both
sides are differentiated k times before they are compared, and grow. A
method that reaches a limit is reported as ``timeout``, with the limit; it is no success.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from time import perf_counter
from typing import TYPE_CHECKING, Any

from kowalevski_cas.algebra import EXACT, POINTS, load_points
from kowalevski_cas.algebra.points import Question
from kowalevski_cas.pictures import INK, new_figure
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.problem.sampled import Sampled
from kowalevski_cas.verify.run import verify
from study.charts import legend_below, marked, names, split
from study.paper import exact, paper, sampled
from study.step import Measured, Row, Task
from study.worker import asked

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "expression swell under limits"

SECONDS, MEBIBYTES = 10.0, 1500

ORDERS = (0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 16)

CLAIMS = ("eq16.invariance", "redundant-integral", "critical-set", "limit")
"""The claims of the paper that take the most products."""

ANSWERS = ("proved", "conditional", "refuted", "probable", "enclosed")

TARGET = f"{__name__}:decide"


def measure(quick: bool) -> Iterable[Task]:
    """Each method on each member of the family, and on the largest claims."""
    for method in ("flint", "modular") if quick else (*EXACT, *POINTS):
        for order in (0, 1) if quick else ORDERS:
            yield _task(method, f"D^{order}", order=order)
        for id in () if quick else CLAIMS:
            yield _task(method, id, claim=id)


def _task(method: str, case: str, **question: Any) -> Task:
    question["method"] = method
    return Task(method, case, partial(asked, TARGET, SECONDS, MEBIBYTES, question))


def decide(question: Mapping[str, Any]) -> Measured:
    """The verdict of a method on a claim, or on derivatives of both sides of an identity."""
    if "claim" in question:
        return _claim(question["method"], question["claim"])
    return _derivatives(question["method"], question["order"])


def _claim(method: str, id: str) -> Measured:
    source = paper()
    start = perf_counter()
    run = verify(source.derivation, (method,), [id], certificates=source.certificates)
    seconds, (outcome,) = perf_counter() - start, run.outcomes
    return {"seconds": seconds, "verdict": str(outcome.verdict), "reason": outcome.message}


def _derivatives(method: str, order: int) -> Measured:
    (goal,) = paper().statement("F2-prime").problem.goals
    assert isinstance(goal, Follows)
    start = perf_counter()
    at = sampled()(goal.space) if method in POINTS else exact(method)(goal.space)
    ((left, right),) = at.pairs(goal.conclusions[0])
    for _ in range(order):
        left, right = at.derivative(left), at.derivative(right)
    verdict, bound = "refuted", None
    if isinstance(at, Sampled):
        answer = load_points(method).answer(Question(at.programs, [at.carry(left - right)]))
        bound = answer.bound
        if answer.holds is not False:
            likely = "probable" if answer.radius is None else "enclosed"
            verdict = likely if answer.holds else "undecided"
    elif (left - right).is_zero:
        verdict = "proved"
    return {"seconds": perf_counter() - start, "verdict": verdict, "bound": bound}


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Time against the order of the derivative, and for the largest claims; hollow at a limit."""
    cases, methods = names(rows, "case"), names(rows, "method")
    orders = [case for case in cases if case.startswith("D^")]
    claims = [case for case in cases if case not in orders]
    figure = new_figure(height=4.0)
    left, right = figure.subplots(1, 2, sharey=True, width_ratios=(1.4, 1))
    for index, (mark, method) in enumerate(marked(methods)):
        mine = {row["case"]: row for row in rows if row["method"] == method}
        above = SECONDS * 1.25 ** (index + 1)
        for axes, chosen, apart, dashes in (
            (left, orders, 0.0, mark.dashes),
            (right, claims, 0.09 * (index - len(methods) / 2), "none"),
        ):
            found = [(k + apart, mine[case]) for k, case in enumerate(chosen) if case in mine]
            done = [(k, row["seconds"], True) for k, row in found if row["verdict"] in ANSWERS]
            split(axes, mark, done, method, linestyle=dashes)
            stopped = [(k, above, False) for k, row in found if row["verdict"] not in ANSWERS]
            split(axes, mark, stopped, "")
    for axes in (left, right):
        axes.set_yscale("log")
        axes.axhline(SECONDS, color=INK, linewidth=0.8)
    left.set_xticks(range(len(orders)), [case[2:] for case in orders])
    left.set_xlabel(r"$k$ in $D^k(dF_2/d\tau)=D^k((U_1+U_2)F_1/\sqrt{\theta})$")
    left.set_ylabel("seconds")
    left.text(0, SECONDS * 1.08, "above: stopped by a limit, or no answer", fontsize=7)
    right.set_xticks(range(len(claims)), claims, rotation=25, ha="right")
    legend_below(figure, left, 6)
    figure.suptitle(f"limits: {SECONDS:g} s and {MEBIBYTES} MiB for each question", fontsize=8)
    return {"stability-swell": figure}
