r"""Expression swell: the largest claims, under a limit of time and memory for each method.

The identity :math:`F_2'=(U_1+U_2)F_1/\sqrt\theta` is true, and so are its derivatives; both
sides are differentiated k times before they are compared, and grow. A
method that reaches a limit is reported as ``timeout``, with the limit; it is no success.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from time import perf_counter
from typing import Any

from kowalevski_cas.arithmetic import EXACT, POINTS, load_points
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import ask
from kowalevski_cas.library import find
from kowalevski_cas.notation import Relation
from kowalevski_cas.proof.evidence import load_evidence
from kowalevski_cas.proof.verify import Session
from kowalevski_cas.stage import scalar
from study.stability.material import PAPER, claim, paper
from study.step import Measured, Row, Task
from study.worker import Worker

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
            yield _task(method, f"D^{order}", {"order": order})
        for id in () if quick else CLAIMS:
            yield _task(method, id, {"claim": id})


def _task(method: str, case: str, question: Mapping[str, Any]) -> Task:
    def run() -> Measured:
        with Worker(TARGET, SECONDS, MEBIBYTES) as worker:
            return worker.ask({"method": method, **question})

    return Task(method, case, run)


def decide(question: Mapping[str, Any]) -> Measured:
    """The verdict of a method on a claim, or on derivatives of both sides of an identity."""
    method = question["method"]
    derivation, texts = paper()
    if "claim" in question:
        kept = load_evidence(find(PAPER))
        start = perf_counter()
        session = Session(derivation, (method,), False, kept)
        outcome = session.run([question["claim"]]).outcomes[-1]
        seconds = perf_counter() - start
        return {"seconds": seconds, "verdict": str(outcome.verdict), "reason": outcome.message}
    one = claim("F2-prime")
    assert one.printed is not None
    formula = texts.formula(one.printed)
    assert isinstance(formula, Relation)
    start = perf_counter()
    stage = Bench(method, texts).stage(one.scene)
    left, right = (scalar(member, stage) for member in formula.members[:2])
    for _ in range(question["order"]):
        left, right = stage.derivative(left), stage.derivative(right)
    verdict, bound = "refuted", None
    if method in POINTS:
        answer = load_points(method).answer(ask(stage, [left - right]))
        bound = answer.bound
        if answer.holds is not False:
            likely = "probable" if answer.radius is None else "enclosed"
            verdict = likely if answer.holds else "undecided"
    elif (left - right).is_zero:
        verdict = "proved"
    return {"seconds": perf_counter() - start, "verdict": verdict, "bound": bound}


def draw(rows: Sequence[Row], folder: Path) -> None:
    """Time against the order of the derivative, and for the largest claims; limits are crosses."""
    from kowalevski_cas import pictures

    methods = list(dict.fromkeys(row["method"] for row in rows))
    cases = list(dict.fromkeys(row["case"] for row in rows))
    orders = [case for case in cases if case.startswith("D^")]
    claims = [case for case in cases if case not in orders]
    with pictures.style():
        figure = pictures.new_figure(height=4.0)
        left, right = figure.subplots(1, 2, sharey=True, width_ratios=(1.4, 1))
        for index, method in enumerate(methods):
            mark = pictures.mark(index)
            for axes, names in ((left, orders), (right, claims)):
                mine = {row["case"]: row for row in rows if row["method"] == method}
                found = [(k, mine[name]) for k, name in enumerate(names) if name in mine]
                done = [(k, r) for k, r in found if r["verdict"] in ANSWERS]
                stopped = [(k, r) for k, r in found if r["verdict"] not in ANSWERS]
                shift = 0.0 if axes is left else 0.09 * (index - len(methods) / 2)
                axes.semilogy(
                    [k + shift for k, _ in done],
                    [r["seconds"] for _, r in done],
                    color=mark.colour,
                    marker=mark.marker,
                    linestyle=mark.dashes if axes is left else "none",
                    label=method,
                )
                axes.semilogy(
                    [k + shift for k, _ in stopped],
                    [SECONDS * 1.25 ** (index + 1) for _ in stopped],
                    color=mark.colour,
                    marker=mark.marker,
                    markerfacecolor="white",
                    linestyle="none",
                )
        for axes in (left, right):
            axes.axhline(SECONDS, color=pictures.INK, linewidth=0.8)
        left.set_xticks(range(len(orders)), [case[2:] for case in orders])
        left.set_xlabel(r"$k$ in $D^k(dF_2/d\tau)=D^k((U_1+U_2)F_1/\sqrt{\theta})$")
        left.set_ylabel("seconds")
        left.text(0, SECONDS * 1.08, "above: stopped by a limit, or no answer", fontsize=7)
        right.set_xticks(range(len(claims)), claims, rotation=25, ha="right")
        figure.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=6)
        figure.suptitle(f"limits: {SECONDS:g} s and {MEBIBYTES} MiB for each question", fontsize=8)
        pictures.save(figure, folder, "stability-swell")
