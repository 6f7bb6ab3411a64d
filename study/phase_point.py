"""The phase point on N⁴ by a tower of quadratic generators, and by square roots in SymPy.

The three geometric integrals and the nine equations of motion are identities in the
separated variables and four square roots. Here they are proved in the exact
arithmetics, each time on a stage made anew, and put to SymPy's simplifiers as one
would type them, with ``sqrt``.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from time import perf_counter

from kowalevski_cas.arithmetic import EXACT
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.derivation import Derivation
from kowalevski_cas.library import find, load
from kowalevski_cas.proof.committed import FOLDER
from study.methods.by_hand import CALLS, MEBIBYTES, TARGET
from study.step import Measured, Row, Task
from study.worker import Worker

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
            yield Task(method, id, lambda m=method, i=id: _proved(m, i))  # type: ignore[misc]
        for call in CALLS[:3] if quick else CALLS:
            yield Task(f"SymPy {call}", id, lambda c=call, i=id: _typed(c, i))  # type: ignore[misc]


@cache
def _derivation() -> Derivation:
    return load(PAPER)


def _proved(method: str, id: str) -> Measured:
    """The verdict of an exact arithmetic; its library is loaded before the clock starts."""
    derivation = _derivation()
    one = next(claim for claim in derivation.claims if claim.id == id)
    texts = derivation.texts()
    Bench(method, texts).stage(derivation.claims[0].scene)
    start = perf_counter()
    finding = one.decide(Bench(method, texts))
    seconds = perf_counter() - start
    return {"seconds": seconds, "verdict": str(finding.verdict), "reason": finding.message}


def _typed(call: str, id: str) -> Measured:
    path = find(PAPER) / FOLDER / f"{id}.json"
    certificate = json.loads(path.read_text(encoding="utf-8"))
    with Worker(TARGET, SECONDS, MEBIBYTES) as worker:
        return worker.ask({"method": call, "certificate": certificate})


def draw(rows: Sequence[Row], folder: Path) -> None:
    """Time for each claim, a mark a method; open marks where the truth was not recognised."""
    from kowalevski_cas import pictures

    methods = list(dict.fromkeys(row["method"] for row in rows))
    cases = list(dict.fromkeys(row["case"] for row in rows))
    with pictures.style():
        figure = pictures.new_figure(height=3.7)
        axes = figure.subplots()
        for index, method in enumerate(methods):
            mark = pictures.mark(index)
            mine = [row for row in rows if row["method"] == method and row["seconds"] is not None]
            places = [cases.index(row["case"]) + 0.08 * (index - len(methods) / 2) for row in mine]
            fills = [mark.colour if row["verdict"] in TRUE else "white" for row in mine]
            total = sum(row["seconds"] for row in mine)
            axes.scatter(
                [], [], c=mark.colour, marker=mark.marker, label=f"{method}, {total:.2g} s"
            )
            axes.scatter(
                [row["seconds"] for row in mine],
                places,
                c=fills,
                edgecolors=mark.colour,
                marker=mark.marker,
                s=20,
                linewidths=1,
            )
        axes.set_xscale("log")
        axes.set_yticks(range(len(cases)), cases)
        axes.invert_yaxis()
        axes.set_xlabel("seconds; open where the method does not see that the statement is true")
        figure.legend(
            loc="outside lower center", ncols=3, title="each method, and its time for all"
        )
        pictures.save(figure, folder, "phase-point")
