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
    for node in formula.nodes():
        kind = type(node)
        if kind in (Name, Root):
            found[node] = node
        elif isinstance(node, Partial):
            found.setdefault((Partial, node.by), node)
        elif kind is Derivative:
            found.setdefault(Derivative, node)
    return tuple(found.values())
