"""Which methods take part: all arithmetics that are registered, all programs that are installed."""

from __future__ import annotations

from kowalevski_cas.arithmetic import EXACT, POINTS
from kowalevski_cas.export import FORMATS, load
from kowalevski_cas.study.methods.arithmetics import ExactArithmetic
from kowalevski_cas.study.methods.by_hand import CALLS, ByHand
from kowalevski_cas.study.methods.certificates import Checker, Program
from kowalevski_cas.study.methods.method import Method
from kowalevski_cas.study.methods.points import PointArithmetic
from kowalevski_cas.systems import MissingSystem

SHARES = {"rocq": 24, "by hand": 80}
"""How many statements those methods are put to that take long."""


def methods() -> list[Method]:
    """The methods, those that prove first."""
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
