"""Which methods take part: all arithmetics that are registered, all programs that are installed."""

from __future__ import annotations

from kowalevski_cas.arithmetic import EXACT, POINTS
from kowalevski_cas.export import FORMATS, load
from kowalevski_cas.export.witness import MissingProgram
from study.methods.arithmetics import ExactArithmetic
from study.methods.by_hand import CALLS, ByHand
from study.methods.certificates import Checker, Program
from study.methods.method import Method
from study.methods.points import PointArithmetic

SHARES = {"rocq": 24, "by hand": 80}
"""How many statements those methods are put to that take long."""


def methods() -> list[Method]:
    """The methods, those that prove first."""
    found: list[Method] = [ExactArithmetic(name) for name in EXACT]
    found.append(Checker("checker"))
    for name in FORMATS:
        try:
            found.append(Program(name, load(name), SHARES.get(name)))
        except MissingProgram:
            continue
    found += [PointArithmetic(name) for name in POINTS]
    found += [ByHand(call, SHARES["by hand"]) for call in CALLS]
    return found
