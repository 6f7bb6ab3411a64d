r"""A bracket of any two functions that is printed, as :math:`\{f,g\}`, and those that it gives."""

from __future__ import annotations

from collections.abc import Iterable

from kowalevski_cas.notation import (
    Formula,
    Name,
    Number,
    Partial,
    PoissonBracket,
    Relation,
    substitute,
)

Bracket = tuple[str, str, Formula]
"""Two functions, and their bracket."""


def printed_bracket(formulas: Iterable[Formula]) -> Bracket | None:
    """The last bracket of two functions that is given by their partial derivatives."""
    found = None
    for one in formulas:
        match one:
            case Relation((PoissonBracket(Name(f), Name(g)), given), ("=",)):
                nodes = [node for node in given.nodes() if isinstance(node, Partial)]
                if {Name(f), Name(g)} <= {node.argument for node in nodes}:
                    found = f, g, given
    return found


def with_bracket(formula: Formula, bracket: Bracket) -> Formula:
    """A formula in which brackets are what the printed one is for other functions."""
    f, g, given = bracket
    formula = formula.map_children(lambda child: with_bracket(child, bracket))
    if not isinstance(formula, PoissonBracket) or formula == PoissonBracket(Name(f), Name(g)):
        return formula
    by = {node.by for node in given.nodes() if isinstance(node, Partial)}
    return _derived(substitute(given, {f: formula.left, g: formula.right}), by)


def _derived(formula: Formula, by: set[str]) -> Formula:
    """A formula with the partial derivatives of what others are derived by."""
    match formula:
        case Partial(Name(name), other) if name in by:
            return Number(int(name == other))
    return formula.map_children(lambda child: _derived(child, by))
