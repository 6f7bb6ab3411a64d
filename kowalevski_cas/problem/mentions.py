"""What a formula of a space mentions: names, printed roots, and the motion."""

from __future__ import annotations

from kowalevski_cas.notation import Derivative, Formula, Name, Number, Root
from kowalevski_cas.problem.trees import MARK

MOTION = Derivative(Number(0), MARK)
"""Stands for the vector field among what a formula mentions."""

Mentions = tuple[Formula, ...]


def mentions(formula: Formula) -> Mentions:
    """The names and printed roots in a formula, from left to right, and whether it moves."""
    found: dict[Formula, None] = {}
    for one in formula.nodes():
        if type(one) is Name or type(one) is Root:
            found[one] = None
        elif type(one) is Derivative:
            found[MOTION] = None
    return tuple(found)
