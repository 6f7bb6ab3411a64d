"""Speed against accuracy: each method is put to statements of which the truth is known."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from itertools import zip_longest
from typing import TYPE_CHECKING

from kowalevski_cas.library import available
from study.labelled import TRUE, Disagreement, Labelled, labelled, spread
from study.methods import Method, methods, missing
from study.speed_accuracy_chart import chart
from study.step import DISAGREEMENT, LEFT_OUT, Measured, Row, Task, left_out
from study.summary import COLD, summaries

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "speed against accuracy"

MUTANTS = 3
"""How many mutants are taken of each statement."""

MOST = 300
"""How many statements a method is put to at most."""

REPEATS = 3
"""How often a cold start is measured."""

QUICK = 6
"""How many statements a quick study looks at, at most."""


def measure(quick: bool) -> Iterable[Task]:
    """Each method on each statement of its share, and its start from nothing.

    Methods take turns, so that a noisy moment of the machine touches all of them.
    """
    for name, reason in missing().items():
        yield Task(name, LEFT_OUT, partial(left_out, reason))
    found = methods()
    statements = labelled(1, available()[:1]) if quick else labelled(MUTANTS)
    turns = []
    for method in found:
        size = method.share or MOST
        size = min(QUICK, max(2, size // 10)) if quick else size
        share = spread(statements, size)
        turns.append([Task(method.name, s.id, partial(_decide, method, s)) for s in share])
    yield from (task for turn in zip_longest(*turns) for task in turn if task is not None)
    true = [statement for statement in statements if statement.kind == TRUE]
    for method in found[:1] if quick else found:
        for k in range(REPEATS):
            run = partial(_cold, method, true[(2 * k + 1) * len(true) // (2 * REPEATS)])
            yield Task(method.name, f"{COLD} {k + 1}", run)


def _decide(method: Method, statement: Labelled) -> Measured:
    found = {**method.decide(statement), "kind": statement.kind, "proves": method.proves}
    try:
        return {**found, "truth": statement.truth}
    except Disagreement as error:
        return {**found, "verdict": DISAGREEMENT, "reason": str(error)}


def _cold(method: Method, statement: Labelled) -> Measured:
    return {"seconds": method.cold(statement), "verdict": COLD, "reason": ""}


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """The chart of all methods."""
    return {"speed-accuracy": chart(summaries(rows))}
