"""Formulas in a ring: what is built at once is what it is term by term."""

from functools import reduce
from operator import add

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra import EXACT, load
from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.notation import Name, Negative, Number, Power, Product, Quotient, Sum
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.fold import rational_number
from kowalevski_cas.problem.space import Adjoined, Let, Space

MINUS_ONE = Negative(Number(1))
SPACE = Space(
    variables=("x", "y"),
    steps=(
        Adjoined("i", MINUS_ONE),
        Adjoined("q", Quotient(Name("x"), Name("y"))),
        Adjoined("r", Name("y")),
        Let("f", Sum((Name("x"), Name("i")))),
    ),
)
SPACES = {name: Evaluation(SPACE, load(name)).adjoin_roots() for name in EXACT}

numbers = st.integers(0, 3).map(Number)
fractions = st.builds(Quotient, numbers, st.integers(1, 3).map(Number))
names = st.sampled_from(["x", "y", "i", "q", "r", "f"]).map(Name)
powers = st.builds(Power, names | numbers | fractions, st.integers(0, 3).map(Number))
factors = numbers | fractions | names | powers
products = st.lists(factors, min_size=2, max_size=4).map(tuple).map(Product)
quotients = st.builds(Quotient, products, names)
terms = st.recursive(factors | products | quotients, lambda t: st.builds(Negative, t), max_leaves=3)


@pytest.mark.parametrize("at", SPACES.values(), ids=SPACES)
@given(st.lists(terms, min_size=2, max_size=5))
def test_a_sum_is_that_of_its_terms(at, summands):
    value = at.scalar(Sum(tuple(summands)))
    assert (value - reduce(add, map(at.scalar, summands))).is_zero
    assert {k for term in summands for k in at.scalar(term).denominator} == {*value.denominator}


@given(st.fractions())
def test_a_printed_number_is_read_at_once(value):
    assert rational_number(fraction_formula(value)) == value


def test_a_quotient_by_zero_is_no_number():
    assert rational_number(Negative(Quotient(Number(1), Number(0)))) is None
