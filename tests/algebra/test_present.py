"""Elements as formulas: they have the value of the element, and polynomials stand in factors."""

from fractions import Fraction
from functools import reduce
from operator import add, mul

import pytest
from hypothesis import given

from kowalevski_cas.algebra.present import formula_of, product_of
from kowalevski_cas.notation import (
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Vocabulary,
    to_plain,
)
from tests.algebra.strategies import NAMES, build, neutrals, terms, tower

RING = tower("flint")
WORDS = Vocabulary(scalars=frozenset(RING.names))


def value(formula):
    """The element that a formula means."""
    match formula:
        case Name(name):
            if name in NAMES:
                return RING.generator(name)
            return RING.from_terms({1 << RING.roots.index(name): {(0, 0, 0): Fraction(1)}})
        case Number(number):
            return RING.number(number)
        case Negative(argument):
            return -value(argument)
        case Sum(parts):
            return reduce(add, map(value, parts))
        case Product(parts):
            return reduce(mul, map(value, parts))
        case Quotient(above, below):
            return value(above) / value(below)
        case Power(base, Number(exponent)):
            return value(base) ** exponent
    raise AssertionError(formula)


@given(neutrals())
@pytest.mark.parametrize("shown", [formula_of, product_of])
def test_a_formula_has_the_value_of_its_element(shown, neutral):
    element = build(RING, neutral)
    assert (value(shown(element, WORDS)) - element).is_zero


@given(terms(3, 2), terms(3, 2))
def test_a_product_is_shown_as_one(first, second):
    element = RING.from_terms({0: first}) * RING.from_terms({0: second})
    shown = product_of(element, WORDS)
    inner = shown.argument if isinstance(shown, Negative) else shown
    inner = inner.numerator if isinstance(inner, Quotient) else inner
    assert not isinstance(inner, Sum)


@pytest.mark.parametrize(
    ("parts", "shown"),
    [
        ({(1, 0, 0): -1, (0, 1, 0): 1}, "y − x"),
        ({(1, 0, 0): -1, (0, 1, 0): -1}, "−(x + y)"),
        ({(2, 1, 0): 4, (1, 1, 1): -6}, "2xy(2x − 3z)"),
        ({(2, 0, 0): -1, (1, 1, 0): 2, (0, 2, 0): -1}, "−(x − y)²"),
    ],
)
def test_signs_and_numbers_stand_before_the_factors(parts, shown):
    assert to_plain(product_of(RING.from_terms({0: parts}), WORDS)) == shown
