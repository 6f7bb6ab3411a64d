"""The meaning of a formula on a stage: a fold over the tree."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.notation import (
    Application,
    Conjugate,
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    ImaginaryPart,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    RealPart,
    Root,
    ScalarProduct,
    Sum,
    Vector,
    to_latex,
)

if TYPE_CHECKING:
    from kowalevski_cas.stage.stage import Stage


class StageError(ValueError):
    """A formula without meaning on its scene.

    ``name`` is the name to blame, where there is one.
    """

    def __init__(self, message: str, name: str | None = None) -> None:
        super().__init__(message)
        self.name = name


class Triple(tuple[Element, ...]):
    """The components of a vector, or the diagonal of a matrix."""

    __slots__ = ()


Value = Element | Triple


def evaluate(formula: Formula, stage: Stage, conjugated: bool = False) -> Value:
    """The value of a formula, or of its complex conjugate.

    Raises :class:`StageError` if a name has no meaning on the scene, if vectors
    and scalars are mixed up, or if a denominator vanishes identically.
    """
    memory = stage.memory
    if memory is not None and (known := memory.get((id(formula), conjugated))) is not None:
        return known[1]
    rule = _RULES.get(type(formula))
    if rule is None:
        raise StageError(f"{to_latex(formula)} has no value of its own")
    value = rule(formula, stage, conjugated)
    if memory is not None:
        memory[id(formula), conjugated] = (formula, value)
    return value


def scalar(formula: Formula, stage: Stage, conjugated: bool = False) -> Element:
    """The value of a formula that has to be a scalar."""
    value = evaluate(formula, stage, conjugated)
    if isinstance(value, Triple):
        raise StageError(f"{to_latex(formula)} is a vector where a scalar is expected")
    return value


def vector(formula: Formula, stage: Stage, conjugated: bool = False) -> Triple:
    """The value of a formula that has to be a vector."""
    value = evaluate(formula, stage, conjugated)
    if not isinstance(value, Triple):
        raise StageError(f"{to_latex(formula)} is a scalar where a vector is expected")
    return value


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
            total: dict[str, int] = {}
            for term in terms:
                for key, value in linear_exponent(term).items():
                    total[key] = total.get(key, 0) + value
            return total
    raise StageError(f"{to_latex(formula)} is no exponent that can be used here")


def _add(left: Value, right: Value) -> Value:
    if isinstance(left, Triple) and isinstance(right, Triple):
        return Triple(a + b for a, b in zip(left, right, strict=True))
    if isinstance(left, Triple) or isinstance(right, Triple):
        raise StageError("a vector is added to a scalar")
    return left + right


def multiply(left: Value, right: Value) -> Value:
    """The product of scalars, of a scalar and a vector, or of a diagonal matrix and a vector."""
    if isinstance(left, Triple) and isinstance(right, Triple):
        return Triple(a * b for a, b in zip(left, right, strict=True))
    if isinstance(left, Triple):
        assert isinstance(right, Element)
        return Triple(a * right for a in left)
    if isinstance(right, Triple):
        return Triple(left * b for b in right)
    return left * right


def _sum(formula: Sum, stage: Stage, conjugated: bool) -> Value:
    first, *rest = (evaluate(term, stage, conjugated) for term in formula.terms)
    for value in rest:
        first = _add(first, value)
    return first


def _product(formula: Product, stage: Stage, conjugated: bool) -> Value:
    first, *rest = (evaluate(factor, stage, conjugated) for factor in formula.factors)
    for value in rest:
        first = multiply(first, value)
    return first


def _negative(formula: Negative, stage: Stage, conjugated: bool) -> Value:
    value = evaluate(formula.argument, stage, conjugated)
    return Triple(-a for a in value) if isinstance(value, Triple) else -value


def _inverse(element: Element, formula: Formula) -> Element:
    try:
        return element.inverse()
    except ZeroDivisionError:
        raise StageError(f"division by {to_latex(formula)}, which vanishes identically") from None


def _quotient(formula: Quotient, stage: Stage, conjugated: bool) -> Value:
    value = evaluate(formula.numerator, stage, conjugated)
    for divisor, exponent in _divisors(formula.denominator):
        below = _inverse(scalar(divisor, stage, conjugated), divisor)
        value = multiply(value, below**exponent)
    return value


def _divisors(formula: Formula) -> Iterator[tuple[Formula, int]]:
    """The factors of a denominator as it is printed, with exponents."""
    match formula:
        case Product(factors):
            for factor in factors:
                yield from _divisors(factor)
        case Power(base, Number(exponent)):
            yield base, exponent
        case _:
            yield formula, 1


def _power(formula: Power, stage: Stage, conjugated: bool) -> Value:
    exponents = linear_exponent(formula.exponent)
    base = scalar(formula.base, stage, conjugated)
    result = stage.ring.one
    for name, multiple in exponents.items():
        factor = base if name == "" else stage.symbolic_power(formula.base, name)
        if multiple < 0:
            factor, multiple = _inverse(factor, formula.base), -multiple
        result = result * factor**multiple
    return result


def _derivative(formula: Derivative, stage: Stage, conjugated: bool) -> Value:
    value = evaluate(formula.argument, stage, conjugated)
    factor = stage.time_factor(formula.mark, conjugated)
    if isinstance(value, Triple):
        return Triple(stage.derivative(a) * factor for a in value)
    return stage.derivative(value) * factor


def _real_part(formula: RealPart, stage: Stage, conjugated: bool) -> Value:
    argument = formula.argument
    return (scalar(argument, stage) + scalar(argument, stage, True)) * stage.half


def _imaginary_part(formula: ImaginaryPart, stage: Stage, conjugated: bool) -> Value:
    argument = formula.argument
    difference = scalar(argument, stage) - scalar(argument, stage, True)
    return difference * stage.half * scalar(Name("i"), stage).inverse()


def _scalar_product(formula: ScalarProduct, stage: Stage, conjugated: bool) -> Value:
    left, right = (vector(f, stage, conjugated) for f in (formula.left, formula.right))
    total = stage.ring.zero
    for a, b in zip(left, right, strict=True):
        total = total + a * b
    return total


def _cross_product(formula: CrossProduct, stage: Stage, conjugated: bool) -> Value:
    (a1, a2, a3), (b1, b2, b3) = (
        vector(f, stage, conjugated) for f in (formula.left, formula.right)
    )
    return Triple((a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1))


def _poisson_bracket(formula: PoissonBracket, stage: Stage, conjugated: bool) -> Value:
    left, right = (evaluate(f, stage, conjugated) for f in (formula.left, formula.right))
    if isinstance(left, Triple) and isinstance(right, Triple):
        raise StageError("the Poisson bracket of two vectors is no vector")
    if isinstance(left, Triple):
        return Triple(stage.bracket(a, right) for a in left)  # type: ignore[arg-type]
    if isinstance(right, Triple):
        return Triple(stage.bracket(left, b) for b in right)
    return stage.bracket(left, right)


_RULES: dict[type[Formula], Callable[[Any, Stage, bool], Value]] = {
    Number: lambda f, stage, _: stage.ring.number(f.value),
    Name: lambda f, stage, conjugated: stage.value(f.name, conjugated),
    Sum: _sum,
    Negative: _negative,
    Product: _product,
    Quotient: _quotient,
    Power: _power,
    Root: lambda f, stage, conjugated: stage.root(f.argument, conjugated),
    Application: lambda f, stage, conjugated: evaluate(stage.applied(f), stage, conjugated),
    Derivative: _derivative,
    Conjugate: lambda f, stage, conjugated: evaluate(f.argument, stage, not conjugated),
    RealPart: _real_part,
    ImaginaryPart: _imaginary_part,
    Vector: lambda f, s, c: Triple(scalar(component, s, c) for component in f.components),
    Diagonal: lambda f, s, c: Triple(scalar(entry, s, c) for entry in f.entries),
    ScalarProduct: _scalar_product,
    CrossProduct: _cross_product,
    PoissonBracket: _poisson_bracket,
}
