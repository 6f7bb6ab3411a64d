r"""To which order an approximation holds, as :math:`\ddot x=-x+\frac16x^3` for small x.

It is the highest degree of what is printed, or the one before that which words leave out.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Set
from typing import NamedTuple

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
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.numerals import ORDINALS
from kowalevski_cas.reading.sets import SetOfEquations
from kowalevski_cas.reading.statements import SourceStatement

HIGHEST = 6
"""Up to which order derivatives are taken."""

_NUMBERS = {word: number for number, words in enumerate(ORDINALS, 1) for word in words} | {
    "linear": 1, "quadratic": 2, "квадратичн": 2, "cubic": 3, "кубическ": 3,
}  # fmt: skip
_ORDER = re.compile(
    rf"\b(?P<order>{'|'.join(_NUMBERS)})\w*(?:\s+(?:and|и)\s+(?:higher|высш\w+))?[\s-]+"
    r"(?:order|degree|power|term|quantit|порядк|степен|член)\w*",
    re.IGNORECASE,
)
_LEFT_OUT = re.compile(
    r"\b(?:neglect|omit|drop|ignor|discard|error|(?:terms|quantities|smalls?)\s+of\b|пренебре|отбр"
    r"|ошибк|погрешност|с\s+точностью\s+до)[^.;§]{0,30}$",
    re.IGNORECASE,
)
_KEPT = re.compile(
    r"\b(?:keep|kept|retain|includ|tak|consider|сохран|оставл|удерж|включ|учит)\w*[^.;§]{0,40}$",
    re.IGNORECASE,
)
"""How words end before an order: that it is left out; that it is not."""


class Orders(NamedTuple):
    """The orders to which both sides are equal, and whether words may mean fewer of them."""

    all: tuple[int, ...]
    is_stronger: bool


def orders_of(item: SourceStatement, near: SetOfEquations, known: Known) -> Orders | None:
    """The orders to which an approximation holds near a place; ``None`` if they are not known."""
    scalars = known.names.scalars(name for one in near for name in one.names)
    small = {*filter(known.moves, scalars)}
    fixed = {name for one in near for name in one.names} - small  # the values there
    sides = [one for one in item.members[1:] if not isinstance(one, Name)]
    degrees = [_degree(member, small, fixed, known) for member in sides]
    if None in degrees:
        return None
    left = _degree(item.members[0], small, fixed, known)
    printed = max([1, left or 0, *filter(None, degrees)])
    told = [(printed, True), *map(_last, _ORDER.finditer(item.words))]
    highest = max(number for number, _ in told)
    if highest > HIGHEST:
        return None
    return Orders((*range(1, highest + 1),), (highest, True) not in told)


def _last(found: re.Match[str]) -> tuple[int, bool]:
    """The last order that is kept, and whether words say so; “to” it may be with it, or without."""
    before, number = found.string[: found.start()], _NUMBERS[found["order"].lower()]
    if _KEPT.search(before):
        return number, True
    return (number - 1, True) if _LEFT_OUT.search(before) else (number, False)


def _degree(formula: Formula, small: Collection[str], fixed: Set[str], known: Known) -> int | None:
    """The degree of a formula in what is small; ``None`` if it is no polynomial in this."""
    names = formula.names() - fixed
    moving = {n for n in names if n in small or (known.is_defined(n) and known.varies(n))}
    if not moving:
        return 0
    match formula:
        case Name(name):
            return 1 if name in small else None
        case Derivative(argument) | Negative(argument):
            return _degree(argument, small, fixed, known)
        case Power(base, Number(power)) if power == int(power) > 0:
            below = _degree(base, small, fixed, known)
            return None if below is None else below * int(power)
        case Quotient(numerator, denominator) if _degree(denominator, small, fixed, known) == 0:
            return _degree(numerator, small, fixed, known)
        case Sum(parts) | Product(parts):
            found = [_degree(one, small, fixed, known) for one in parts]
            if None in found:
                return None
            every = [one for one in found if one is not None]
            return max(every) if isinstance(formula, Sum) else sum(every)
    return None
