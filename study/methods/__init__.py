"""The ways of deciding whether a statement is true, all behind one small interface."""

from __future__ import annotations

from kowalevski_cas.algebra import EXACT, POINTS
from kowalevski_cas.export import FORMATS, load
from kowalevski_cas.systems import SYSTEMS, MissingSystem
from study.methods.arithmetics import ExactArithmetic, PointArithmetic
from study.methods.certificates import CALLS, ByHand, Checker, Program
from study.methods.method import ACCEPTED, NONE, REJECTED, Method

SHARES = {"rocq": 24, "by hand": 80}
"""How many statements those methods are put to that take long."""


def methods() -> list[Method]:
    """All arithmetics and all programs that are installed, those that prove first."""
    found: list[Method] = [ExactArithmetic(name) for name in EXACT]
    found.append(Checker("checker"))
    for name in FORMATS:
        try:
            found.append(Program(name, load(name), SHARES.get(name)))
        except MissingSystem:
            continue
    found += [PointArithmetic(name) for name in POINTS]
    found += [ByHand(call, SHARES["by hand"]) for call in CALLS]
    return found


def missing() -> dict[str, str]:
    """Why a program is not among the methods, by its name."""
    reasons = {}
    for name in FORMATS:
        try:
            SYSTEMS[name].call()
        except MissingSystem as reason:
            reasons[name] = str(reason)
    return reasons


__all__ = ["ACCEPTED", "NONE", "REJECTED", "Method", "methods", "missing"]
