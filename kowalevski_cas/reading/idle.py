r"""What a family says of some values of its indices: nothing, or nothing new.

So it is with :math:`L_{ij}=x_ip_j-x_jp_i` where i is j, and with :math:`a_{ij}=-a_{ji}`, of which
one half is the other.
"""

from __future__ import annotations

from collections import Counter

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    to_latex,
)
from kowalevski_cas.notation.misprints import factors_of
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.known import DEFINITION, NOTATION, OTHER, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement, is_closing

ZERO = "zero for these values of its indices"
SAME = "says the same as for other values of its indices"


def idle(item: SourceStatement, known: Known) -> StatementRole | None:
    """What says for other values of its indices more than for these, or the same."""
    family = [one for one in known.paper.items if one.typed is item.typed and one.span == item.span]
    if name := _closed(item, known.paper.period):
        why = f"indices are taken modulo {known.paper.period}"
        return StatementRole(DEFINITION, why, "", (name,))
    if _runs_on(item, known):
        return StatementRole(NOTATION, "says how indices go on")
    turned = _turned(item.formula)
    if turned is not None and any(o.formula == turned for o in family if o.order < item.order):
        return StatementRole(OTHER, SAME)
    if not _is_idle(item.formula) or all(_is_idle(one.formula) for one in family):
        return None
    named = isinstance(item.formula, Relation)
    role = DEFINITION if named else OTHER
    return StatementRole(role, ZERO, "", item.bare[:1] if named else ())


def _closed(item: SourceStatement, period: int) -> str:
    """The name beside a chain that an equation gives by one of its links, or nothing."""
    if not period or not is_closing(item, period):
        return ""
    indices = [symbol(name).index for name in item.bare]
    if not all(index.isdecimal() for index in indices):
        return ""
    beside = [
        name
        for name, index in zip(item.bare, indices, strict=True)
        if not 1 <= int(index) <= period
    ]
    return beside[0] if len(beside) == 1 else ""


def _runs_on(item: SourceStatement, known: Known) -> bool:
    """Whether an equation says of any link of a chain which one it is again: no map has it."""
    letters = [symbol(name).index for name in item.bare]
    steps = {index.strip("0123456789+-") for index in letters}
    chained = is_closing(item) and len(steps) == 1 and steps != {""}
    return chained and not any(law.images for law in known.laws)


def _turned(formula: Formula | None) -> Formula | None:
    """An equation between a name and another one, perhaps with a sign, for the other one."""
    match formula:
        case Relation((Name() as one, Name() as other), ("=",)):
            return Relation((other, one), ("=",))
        case Relation((Name() as one, Negative(Name() as other)), ("=",)):
            return Relation((other, Negative(one)), ("=",))
    return None


def _is_idle(formula: Formula | None) -> bool:
    """Whether an expression, or the one that gives a name, is zero as it is printed."""
    match formula:
        case Relation((Name(), given), ("=",)):
            return given != Number(0) and vanishes(given)
        case Relation() | None:
            return False
    return vanishes(formula)


def vanishes(formula: Formula) -> bool:
    """Whether all terms of a formula cancel as they are printed.

    >>> from kowalevski_cas.notation import Vocabulary, read
    >>> words = Vocabulary(frozenset("xp"))
    >>> vanishes(read("xp-px", words)), vanishes(read("xp-x^2", words))
    (True, False)
    """
    match formula:
        case Number(value):
            return value == 0
        case Negative(inner) | Power(inner, Number()) | Quotient(inner, _):
            return vanishes(inner)
        case Product(factors):
            return any(map(vanishes, factors))
        case Sum(terms):
            counts = Counter[tuple[str, ...]]()
            for term in terms:
                sign, inner = (-1, term.argument) if isinstance(term, Negative) else (1, term)
                if not vanishes(inner):
                    counts[tuple(sorted(map(to_latex, factors_of(inner))))] += sign
            return not any(counts.values())
    return False
