r"""Another time than t: a multiple of it, as :math:`\tau=it`, or as differentials give it."""

from __future__ import annotations

from typing import NamedTuple

from kowalevski_cas.notation import Derivative, Formula, Name, Negative, Number, Product, Quotient
from kowalevski_cas.notation import times as product

TIME = "t"
D = Name("d")


class TimeChange(NamedTuple):
    r"""Another time, with its rate by t, :math:`d\tau/dt`."""

    time: str
    rate: Formula
    varies: bool
    """Whether it is given by differentials, so that the rate need not be a constant."""


def time_change(left: Formula, right: Formula) -> TimeChange | None:
    r"""What an equation says of another time: by :math:`\tau=\kappa t`, t=κτ, :math:`dt=f\,d\tau`.

    Its rate stands below a line where t is given by it, so that its zeros are conditions.
    """
    match left:
        case Name(time) if time != TIME and (scale := _scale(right)) is not None:
            return TimeChange(time, scale, varies=False)
        case Name("t") if isinstance(right, Product) and isinstance(right.factors[-1], Name):
            return TimeChange(right.factors[-1].name, _inverse(product(*right.factors[:-1])), False)
        case Derivative(Name("t"), mark) if mark not in ("dot", "prime", TIME):
            return TimeChange(mark, _inverse(right), varies=True)
    first, second = _differential(left), _differential(right)
    if first is None or second is None:
        return None
    (factor, one), (other_factor, other) = first, second
    if one == TIME != other:
        return TimeChange(other, _inverse(Quotient(other_factor, factor)), varies=True)
    if other == TIME != one:
        return TimeChange(one, Quotient(other_factor, factor), varies=True)
    return None


def _inverse(formula: Formula) -> Formula:
    return Quotient(Number(1), formula)


def _scale(formula: Formula) -> Formula | None:
    """The factor before t; ``None`` if the formula is no multiple of it."""
    match formula:
        case Negative(argument):
            scale = _scale(argument)
            return None if scale is None else Negative(scale)
        case Product((*rest, Name("t"))):
            return product(*rest)
        case Quotient(Name("t"), below):
            return _inverse(below)
        case Quotient(above, below):
            scale = _scale(above)
            return None if scale is None else Quotient(scale, below)
    return None


def _differential(formula: Formula) -> tuple[Formula, str] | None:
    """The factor of the differential of a name, and the name; ``None`` if there is none."""
    match formula:
        case Product((*rest, Name("d"), Name(name))) if D not in rest:
            return (product(*rest) if rest else Number(1)), name
        case Negative(argument) if (found := _differential(argument)) is not None:
            return Negative(found[0]), found[1]
        case Quotient(numerator, below) if (found := _differential(numerator)) is not None:
            return Quotient(found[0], below), found[1]
    return None
