r"""Roots with names in a factored polynomial: :math:`P(u)=c(u-a)(b-u)` gives a and b."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.reading.coefficients import coefficients
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.vieta import NamedRoots, polynomial_of


def roots_in_factors(
    item: SourceStatement, given: Sequence[SourceStatement], paper: SourcePaper
) -> NamedRoots | None:
    """The roots that stand in the linear factors of a member, of the polynomial of another one.

    Where the square of a rate stands there, it is one by an equation that is ``given`` before.
    """
    for member in reversed(item.members[1:]):
        letter, names = _factored(member)
        if len({*names}) < len(names) or len(names) < 2:
            continue
        beside = (one for one in item.members if one is not member)
        for other in (one for one in beside if one.names().isdisjoint(names)):
            for polynomial in _without_rates(other, given):
                found = polynomial_of(polynomial, letter, names, item, paper)
                if len(found) == len(names) + 1:
                    return NamedRoots(item, names, letter, found)
    return None


def _without_rates(formula: Formula, given: Sequence[SourceStatement]) -> Iterator[Formula]:
    """A formula with what equations give for the square of the rate in it, the last one first."""
    rates = {node for node in formula.nodes() if isinstance(node, Derivative)}
    if not rates:
        yield formula
    squares = {node for node in formula.nodes() if _is_square_of_rate(node)}
    if len(rates) != 1 or len(squares) != 1:
        return
    (square,) = squares
    for one in reversed(given):
        if len(one.members) == 2 and square in (node for m in one.members for node in m.nodes()):
            with suppress(ValueError):
                constant, slope = coefficients(minus((one.members[0], one.members[1])), square)
                yield _put(formula, square, Quotient(Negative(constant), slope))


def _is_square_of_rate(node: Formula) -> bool:
    match node:
        case Power(Derivative(), Number(2)):
            return True
    return False


def _put(formula: Formula, node: Formula, value: Formula) -> Formula:
    """A formula with a value in the place of a part."""
    if formula == node:
        return value
    return formula.map_children(lambda child: _put(child, node, value))


def _factored(formula: Formula) -> tuple[str, tuple[str, ...]]:
    """The letter of a product of linear factors, and the names that are subtracted from it."""
    while isinstance(formula, Negative | Quotient):
        formula = formula.argument if isinstance(formula, Negative) else formula.numerator
    factors = formula.factors if isinstance(formula, Product) else ()
    pairs = [pair for factor in factors if (pair := _difference(factor))]
    common = set.intersection(*map(set, pairs)) if len(pairs) > 1 else set()
    if len(common) != 1:
        return "", ()
    (letter,) = common
    return letter, tuple(name for pair in pairs for name in pair if name != letter)


def _difference(factor: Formula) -> tuple[str, ...]:
    """The names of which a factor is the difference."""
    match factor:
        case Sum((Name(one), Negative(Name(other)))):
            return one, other
    return ()
