r"""Roots with names in a factored polynomial: :math:`P(u)=c(u-a)(b-u)` gives a and b."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    times,
    to_latex,
)
from kowalevski_cas.reading.known import DEFINITION, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

ROOTS = "roots"
"""The kind of a definition that gives names by the roots of a polynomial."""


def roots(item: SourceStatement, known: Known) -> StatementRole | None:
    """A polynomial that is known already, with factors which have new names in them."""
    _, names = _factored(item)
    rest = item.members[0].names() if names else set[str]()
    new = len({*names}) == len(names) > 1 and not any(
        name in rest or known.moves(name) or known.is_defined(name) or _is_used(name, known)
        for name in names
    )
    defined = all(map(known.is_known, rest)) and any(
        name in known.definitions for name in _functions(item)
    )
    if not (new and defined):
        return None
    return StatementRole(DEFINITION, f"gives the roots {', '.join(names)}", ROOTS)


def values_at_numbers(item: SourceStatement, known: Known) -> Iterator[SourceStatement]:
    """What says that names are roots: the equation at as many numbers as there are names.

    Both sides are divided by what stands before the factors. Where they begin alike then, they
    differ by a polynomial of lower degree, which vanishes.
    """
    variable, names = _factored(item)
    left, right = item.members
    product = right.argument if isinstance(right, Negative) else right
    assert isinstance(product, Product)
    before = times(*(factor for factor in product.factors if not _difference(factor)))
    linear = times(*(factor for factor in product.factors if _difference(factor)))
    quotient = left if before == Number(1) else Quotient(left, before)
    sides = (quotient, Negative(linear) if isinstance(right, Negative) else linear)
    for number in range(len(names)):
        tex = "=".join(to_latex(_put(side, variable, number)) for side in sides)
        yield unprinted(known.paper, f"{item.printed.display.id}-at-{number}", tex, item)


def root_names(item: SourceStatement) -> tuple[str, ...]:
    """The names of the roots in a statement."""
    return _factored(item)[1]


def _factored(item: SourceStatement) -> tuple[str, tuple[str, ...]]:
    """The variable and the roots of a statement with a product of linear factors on its right."""
    if len(item.members) != 2:
        return "", ()
    right = item.members[1]
    product = right.argument if isinstance(right, Negative) else right
    factors = product.factors if isinstance(product, Product) else ()
    pairs = [pair for factor in factors if (pair := _difference(factor))]
    common = set.intersection(*map(set, pairs)) & item.members[0].names() if pairs else set()
    if len(common) != 1:
        return "", ()
    (variable,) = common
    others = [factor for factor in factors if not _difference(factor)]
    if any(variable in factor.names() for factor in others):
        return "", ()
    return variable, tuple(name for pair in pairs for name in pair if name != variable)


def _difference(factor: Formula) -> tuple[str, ...]:
    """The names of which a factor is the difference."""
    match factor:
        case Sum((Name(one), Negative(Name(other)))):
            return one, other
    return ()


def _functions(item: SourceStatement) -> list[str]:
    """The functions that stand on the left of a statement."""
    nodes = item.members[0].nodes()
    return [function for node in nodes if (function := getattr(node, "function", ""))]


def _is_used(name: str, known: Known) -> bool:
    """Whether a name stands in an equation, or in a law, and not only in an inequality."""
    first = known.seen.get(name)
    return first is not None and known.roles[first].kind != "inequality"


def _put(formula: Formula, name: str, number: int) -> Formula:
    """A formula with a number in the place of a name."""
    if formula == Name(name):
        return Number(number)
    return formula.map_children(lambda child: _put(child, name, number))
