"""Exponents as they are printed: integers, halves, and sums of names."""

from __future__ import annotations

from fractions import Fraction

from kowalevski_cas.notation import Formula, Name, Negative, Number, Quotient, Sum, to_latex
from kowalevski_cas.problem.space import Meaningless


def linear_exponent(formula: Formula) -> dict[str, int]:
    """A symbolic exponent as integer multiples of names; the key ``""`` is the constant."""
    match formula:
        case Number(value):
            return {"": value}
        case Name(name):
            return {name: 1}
        case Negative(argument):
            return {k: -v for k, v in linear_exponent(argument).items()}
        case Sum(terms):
            found: dict[str, int] = {}
            for term in terms:
                for key, value in linear_exponent(term).items():
                    found[key] = found.get(key, 0) + value
            return found
    raise Meaningless(f"{to_latex(formula)} is no exponent that can be used here")


def half_power(exponent: Formula) -> int | None:
    """The odd number of halves in an exponent, as 3 in 3/2; ``None`` for any other exponent."""
    match exponent:
        case Quotient(Number(above), Number(2)) if above % 2:
            return above
        case Negative(argument) if (halves := half_power(argument)) is not None:
            return -halves
    return None


def fraction(exponent: Formula) -> Fraction | None:
    """An exponent that is printed as a fraction of whole numbers; ``None`` for any other one."""
    match exponent:
        case Quotient(Number(above), Number(below)) if below:
            return Fraction(above, below)
        case Quotient(Negative(Number(above)), Number(below)) if below:
            return Fraction(-above, below)
        case Negative(argument) if (found := fraction(argument)) is not None:
            return -found
    return None


def is_whole(exponent: Formula) -> bool:
    """Whether an exponent is an integer."""
    return isinstance(exponent.argument if isinstance(exponent, Negative) else exponent, Number)
