"""The ways of deciding whether a statement is true, all behind one small interface."""

from __future__ import annotations

from kowalevski_cas.algebra import EXACT, POINTS
from kowalevski_cas.export import load
from kowalevski_cas.tools import TOOLS, MissingTool
from study.methods.arithmetics import ExactArithmetic, PointArithmetic
from study.methods.certificates import STARTED, Checker, ExportProgram
from study.methods.method import ACCEPTED, NONE, REJECTED, Method
from study.methods.typed import CALLS, ByHand

SHARES = {"rocq": 24, "by hand": 80}
"""How many statements those methods are put to that take long."""


def methods() -> list[Method]:
    """All arithmetics and all programs that are installed, those that prove first."""
    found: list[Method] = [*map(ExactArithmetic, EXACT), Checker("checker")]
    for name in TOOLS:
        try:
            found.append(ExportProgram(name, load(name), SHARES.get(name)))
        except MissingTool:
            continue
    return [*found, *map(PointArithmetic, POINTS), *(ByHand(c, SHARES["by hand"]) for c in CALLS)]


__all__ = ["ACCEPTED", "NONE", "REJECTED", "STARTED", "ExportProgram", "Method", "methods"]
