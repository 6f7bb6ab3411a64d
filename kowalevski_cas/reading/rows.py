"""Equations of motion by their form: which rates they give, and of what order."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Negative,
    Partial,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    Relation,
)
from kowalevski_cas.notation.layout import EITHER_SIGN
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourceStatement

_OF_SOME_MOTIONS = re.compile(
    r"\b(?:motions?|trajector(?:y|ies)|orbits?|solutions?)\s+"
    r"(?:with|(?:for|along|on)\s+which|such\s+that|that\s+satisfy|satisfying)[\s:~]*$"
    r"|\b(?:движени|решени|траектори)\w+,?\s+(?:(?:для|при|на)\s+котор\w+|с)[\s:~]*$",
    re.IGNORECASE,
)
"""How words end behind which stands what holds for some motions only."""


def is_row(item: SourceStatement) -> bool:
    r"""Whether a statement may be an equation of motion: an equality, linear in highest rates.

    What is a name on the left is a definition, unless it gives a multiple of one rate, as
    :math:`p=m\dot q`. With either sign of a term it is no law: with both, nothing might move. What
    is said of some motions is none.
    """
    if not item.rates or EITHER_SIGN.search(item.printed.tex):
        return False
    if _OF_SOME_MOTIONS.search(item.before):
        return False
    if len(item.members) != 2 and not _is_chain(item.members):
        return False
    highest = max(item.rates.values())
    nodes = [node for member in item.members for node in member.nodes()]
    if any(isinstance(node, Power) and highest_order(node.base) >= highest for node in nodes):
        return False
    first, *others = item.members
    rates = (m.argument if isinstance(m, Negative) else m for m in others)
    if isinstance(first, Partial) and not any(isinstance(m, Derivative) for m in rates):
        return False  # it is a gradient that is computed
    return not isinstance(first, Name | Application) or _is_multiple(others[0])


def is_by_own_bracket(item: SourceStatement) -> bool:
    r"""Whether a rate is given by a bracket of the same letter, as in :math:`\dot f=\{f,H\}`.

    So any function moves: beside equations of motion it is none.
    """
    match item.members:
        case (Derivative(Name(name)), right):
            inner = right.argument if isinstance(right, Negative) else right
            return isinstance(inner, PoissonBracket) and Name(name) in inner.children()
    return False


def _is_chain(members: Sequence[Formula]) -> bool:
    r"""Whether equalities begin with their only rate, :math:`\dot q=\partial H/\partial p=p`."""
    rates = [member for member in members if highest_order(member)]
    return len(members) > 2 and rates == [*members[:1]] and isinstance(members[0], Derivative)


def _is_multiple(formula: Formula) -> bool:
    r"""Whether a formula is a rate with a factor, or over one, as in :math:`\dot a/a`."""
    formula = formula.argument if isinstance(formula, Negative) else formula
    if isinstance(formula, Quotient) and not highest_order(formula.denominator):
        formula = formula.numerator
    formula = formula.argument if isinstance(formula, Negative) else formula
    factors = formula.factors if isinstance(formula, Product) else (formula,)
    return sum(isinstance(factor, Derivative) for factor in factors) == 1


def highest_order(formula: Formula) -> int:
    """The highest order of a derivative in a formula; 0 if there is none."""
    below = max(map(highest_order, formula.children()), default=0)
    return below + isinstance(formula, Derivative)


BINDING = ("constraint", "no slip")
"""Cues of the words for a constraint."""


def binds_velocities(row: SourceStatement, rows: Sequence[SourceStatement]) -> bool:
    r"""Whether words call a row a constraint, as :math:`\dot x\sin\varphi=\dot y\cos\varphi`.

    Other rows derive once more all that is derived in it, which are several velocities. What is
    said of a case, or by others, binds nothing.
    """
    others = [other for other in rows if other.typed is not row.typed]
    said = any(cue(name, row.lead) for name in BINDING)
    said = said and not (cue("quoted", row.before) or cue("another case", row.before))
    return (
        said
        and len(row.rates) > 1
        and all(
            any(other.rates.get(name, 0) > order for other in others)
            for name, order in row.rates.items()
        )
    )


def linear_rates(formula: Formula) -> Iterator[tuple[str, int]]:
    """The names of which a derivative stands under no power, with its order."""
    inner, order = formula, 0
    while isinstance(inner, Derivative):
        inner, order = inner.argument, order + 1
    if order and isinstance(inner, Name):
        yield inner.name, order
    for child in () if isinstance(inner, Power) else inner.children():
        yield from linear_rates(child)


def only_squared(rows: Sequence[SourceStatement]) -> set[str]:
    r"""The names of which the highest rates stand under powers only, as :math:`r\dot\varphi^2`.

    No row gives such a rate.
    """
    formulas = [row.formula for row in rows if row.formula is not None]
    if any(isinstance(node, Partial) for one in formulas for node in one.nodes()):
        return set()  # they are derived by rates
    highest: dict[str, int] = {}
    for row in rows:
        highest |= {n: order for n, order in row.rates.items() if order > highest.get(n, 0)}
    return {*highest} - {
        name for one in formulas for name, order in linear_rates(one) if order == highest.get(name)
    }


def rates_given(rows: Sequence[SourceStatement], names: Names) -> int:
    """How many rates some rows give, each one or those of a vector."""
    return sum(len(names.vectors.get(_left(row), "1")) for row in rows)


def _left(row: SourceStatement) -> str:
    """The name of which a row gives the rate, or the one that it begins with."""
    formula = row.formula
    assert isinstance(formula, Relation)
    for member in formula.members:
        for node in member.nodes():
            if isinstance(node, Derivative):
                return next(iter(node.argument.names()), "")
    return ""


_OF_MOTION = re.compile(
    r"\bequations?\s+of\s+(?:motion|Hamilton|Lagrange|Newton)\b"
    r"|\b(?:Hamilton|Newton|Lagrange)\S*\s+equations?\b|\bуравнени\w+\s+(?:движени|Ньютона|Гамильтона|Лагранжа)",
    re.IGNORECASE,
)
_OTHERWISE = ("another case", "ideal case", "linear", "approximate", "force", "small")


def is_of_motion(row: SourceStatement) -> bool:
    """Whether words call a row an equation of motion, or derive it, and speak of no other case."""
    said = _OF_MOTION.search(row.before) or cue("deduced", row.before)
    return bool(said) and not any(cue(name, row.words) for name in _OTHERWISE)
