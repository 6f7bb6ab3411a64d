"""What a formula of a space mentions: names, printed roots, and the motion."""

from __future__ import annotations

from kowalevski_cas.notation import Derivative, Formula, Name, Partial, Root, once

Mentions = tuple[Formula, ...]


@once
def mentions(formula: Formula) -> Mentions:
    """The names and printed roots in a formula, from left to right, and its first derivatives.

    Of those along the motion the first, and the first by each variable.
    """
    found: dict[object, Formula] = {}
    for one in formula.nodes():
        kind = type(one)
        if kind in (Name, Root):
            found[one] = one
        elif isinstance(one, Partial):
            found.setdefault((Partial, one.by), one)
        elif kind is Derivative:
            found.setdefault(Derivative, one)
    return tuple(found.values())
