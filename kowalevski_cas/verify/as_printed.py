"""What a reader is shown of a computation: elements, names and points as the paper prints them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from math import prod

from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.present import fraction_formula, name_formula, power_formula, product_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Root,
)
from kowalevski_cas.notation.formula import times
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.roots import rationals
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import MARK
from kowalevski_cas.verify.outcome import PrintedPoint


def element_formula(element: Element, setting: Elaboration) -> Formula:
    """An element in the names of its setting, in factors."""
    return product_of(element, setting.texts.vocabulary)


def printed_name(name: str, setting: Elaboration) -> Formula:
    """A name as the paper prints it."""
    return name_formula(name, setting.texts.vocabulary)


def point(values: Mapping[str, Formula], setting: Elaboration) -> PrintedPoint:
    """A point of a setting, with the values of exponential functions for those of their roots.

    That a printed root is not negative goes without saying.
    """
    known = {*values, *setting.scene.definitions}
    found = {
        printed_name(name, setting): value
        for name, value in values.items()
        if name not in setting.unprinted
    }
    return PrintedPoint(
        dict(
            _value(name, _one_root(value))
            for name, value in found.items()
            if not (isinstance(name, Root) and name.names() <= known and _is_positive(value))
        )
    )


def _is_positive(value: Formula) -> bool:
    """Whether a number is written without a minus and without i."""
    return not any(isinstance(node, Negative | Name) for node in value.nodes())


def _value(name: Formula, value: Formula) -> tuple[Formula, Formula]:
    """A name and its value; an exponential function and its value for its root and that of it."""
    if not (isinstance(name, Application) and name.function == r"\exp"):
        return name, value
    square: Formula = Power(value, Number(2))
    with suppress(Meaningless):
        number = rational(rationals().scalar(square))
        square = square if number is None else fraction_formula(number)
    return power_formula(name, 2), square


def _one_root(formula: Formula) -> Formula:
    """A formula in which roots of numbers that are multiplied are one root."""
    formula = formula.map_children(_one_root)
    if isinstance(formula, Product):
        inside = [f.argument for f in formula.factors if isinstance(f, Root)]
        numbers = [number.value for number in inside if isinstance(number, Number)]
        if len(numbers) == len(inside) > 1:
            others = (f for f in formula.factors if not isinstance(f, Root))
            return times(*others, Root(Number(prod(numbers))))
    return formula


def flat_product(factors: Sequence[Formula]) -> Formula:
    """A product, without factors that are one, and without a product in it."""
    flat = [part for f in factors for part in (f.factors if isinstance(f, Product) else (f,))]
    return times(*flat)


def signed_product(coefficient: Formula, factor: Formula) -> Formula:
    """A product with the sign before it."""
    if isinstance(coefficient, Negative):
        return Negative(signed_product(coefficient.argument, factor))
    return flat_product([coefficient, factor])


def printed_formula(formula: Formula, setting: Elaboration) -> Formula:
    """A formula of a statement, with its derivatives by the time of its setting.

    A dot stands on a name only, and only for the time t.
    """
    if isinstance(formula, Name):
        return name_formula(formula.name, setting.texts.vocabulary)
    if isinstance(formula, Derivative) and formula.mark == MARK:
        time, argument = setting.scene.time, printed_formula(formula.argument, setting)
        return Derivative(argument, MARK if time == "t" and isinstance(argument, Name) else time)
    match shown := formula.map_children(lambda child: printed_formula(child, setting)):
        case Power(base, Number(exponent)):
            return power_formula(base, exponent)
        case Quotient(above, Number(1)) | Quotient(Number(1), Quotient(Number(1), above)):
            return above
    return shown


def size(elements: Iterable[Element]) -> int:
    """How many terms elements have together."""
    return sum(len(terms) for element in elements for terms in element.terms().values())
