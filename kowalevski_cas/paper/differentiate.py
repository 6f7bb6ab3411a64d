"""Derivatives written out by the rules of calculus, so that nothing more is divided by."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    power,
    times,
    to_latex,
    total,
)
from kowalevski_cas.problem.space import Adjoined, Let, Meaningless, Raised, Step

ZERO, TWO = Number(0), Number(2)


def derivative(
    formula: Formula,
    rates: Mapping[str, Formula],
    step: Callable[[str], Step | None],
    inside: frozenset[str] = frozenset(),
) -> Formula:
    """The derivative of a formula, in which names have ``rates``; all others stay as they are.

    ``step`` tells what defines a name. Raises :class:`Meaningless` for an operation that is not
    one of arithmetic, and for a name that is defined by itself: it stands ``inside`` of its own.
    """

    def of(part: Formula) -> Formula:
        return derivative(part, rates, step, inside)

    match formula:
        case Number():
            return ZERO
        case Name(name):
            return rates[name] if name in rates else _of_defined(formula, rates, step, inside)
        case Negative(argument):
            return _negative(of(argument))
        case Sum(terms):
            return _total(map(of, terms))
        case Product(factors):
            each = [(k, of(factor)) for k, factor in enumerate(factors)]
            return _total(
                times(*factors[:k], rate, *factors[k + 1 :]) for k, rate in each if rate != ZERO
            )
        case Power(base, Number(exponent)) if exponent:
            raised = times(Number(exponent), *_rate_of_power(base, exponent - 1))
            return _times(raised, of(base))
        case Quotient() | Power(_, Negative(Number())):
            return _of_quotient(*_over_and_below(formula), of)
        case Root(argument):
            return _over(of(argument), times(TWO, formula))
    raise Meaningless(f"print the derivative of {to_latex(formula)}")


def _over_and_below(formula: Formula) -> tuple[Formula, Formula]:
    """What stands over and below the line, of a power with a negative exponent too."""
    match formula:
        case Power(base, Negative(exponent)):
            return Number(1), Power(base, exponent)
        case _:
            above, below = formula.children()
            return above, below


def _of_quotient(above: Formula, below: Formula, of: Callable[[Formula], Formula]) -> Formula:
    rate = of(below)
    if rate == ZERO:
        return _over(of(above), below)
    turned = _total([_times(below, of(above)), _negative(times(above, rate))])
    return Quotient(turned, Power(below, TWO))


def _of_defined(
    name: Name,
    rates: Mapping[str, Formula],
    step: Callable[[str], Step | None],
    inside: frozenset[str],
) -> Formula:
    """The derivative of a name by its definition."""
    if name.name in inside:
        raise Meaningless(f"{name.name} is defined by itself", name.name)
    within = inside | {name.name}
    return _by_definition(name, step(name.name), lambda part: derivative(part, rates, step, within))


def _by_definition(name: Name, step: Step | None, of: Callable[[Formula], Formula]) -> Formula:
    match step:
        case Let(_, body):
            return of(body)
        case Adjoined(_, square):
            return _over(of(square), times(TWO, name))
        case Raised(_, base, exponent):
            return _over(_times(times(Name(exponent), name), of(base)), base)
    return ZERO


def _times(factor: Formula, rate: Formula) -> Formula:
    return rate if rate == ZERO else times(factor, rate)


def _over(rate: Formula, below: Formula) -> Formula:
    return rate if rate == ZERO else Quotient(rate, below)


def _rate_of_power(base: Formula, exponent: int) -> tuple[Formula, ...]:
    return () if exponent == 0 else (power(base, exponent),)


def _negative(formula: Formula) -> Formula:
    return formula if formula == ZERO else Negative(formula)


def _total(terms: Iterable[Formula]) -> Formula:
    return total(term for term in terms if term != ZERO)
