"""What a formula of a space mentions: names, printed roots, and the motion."""

from __future__ import annotations

from kowalevski_cas.notation import Derivative, Formula, Name, Root, once

Mentions = tuple[Formula, ...]


@once
def mentions(formula: Formula) -> Mentions:
    """The names and printed roots in a formula, from left to right, and its first derivative."""
    found: dict[object, Formula] = {}
    for one in formula.nodes():
        kind = type(one)
        if kind in (Name, Root):
            found[one] = one
        elif kind is Derivative:
            found.setdefault(Derivative, one)
    return tuple(found.values())
