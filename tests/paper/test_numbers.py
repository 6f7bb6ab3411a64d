"""Formulas that are numbers, by what their names stand for."""

from fractions import Fraction

import pytest

from kowalevski_cas.notation import Vocabulary, read
from kowalevski_cas.paper.numbers import number_of

WORDS = Vocabulary(scalars=frozenset("abcd"))
GIVEN = {"a": "1", "b": "2a", "c": "d"}


def value(tex):
    return number_of(
        read(tex, WORDS), lambda name: read(GIVEN[name], WORDS) if name in GIVEN else None
    )


@pytest.mark.parametrize(
    "tex, number",
    [
        ("a+b", 3),
        ("b-2a", 0),
        (r"-\frac{a}{b}", Fraction(-1, 2)),
        ("3ab", 6),
        ("a+d", None),
        ("c", None),
    ],
)
def test_names_stand_for_numbers(tex, number):
    assert value(tex) == number


def test_nothing_is_divided_by_zero():
    assert value(r"\frac{a}{b-2a}") is None
