"""Formulas and expressions of SymPy: each is the other."""

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import Vocabulary, read, to_latex
from kowalevski_cas.notation.sympy import from_sympy, to_sympy

x, y = SYMBOLS = sympy.symbols("x y")
WORDS = Vocabulary(frozenset({"x", "y"}))

leaves = st.one_of(
    st.sampled_from(SYMBOLS), st.fractions(-9, 9, max_denominator=9).map(sympy.Rational)
)


def combined(below):
    pairs = st.tuples(below, below)
    return st.one_of(
        pairs.map(sum),
        pairs.map(lambda pair: pair[0] * pair[1]),
        st.tuples(below, st.integers(1, 3)).map(lambda pair: pair[0] ** pair[1]),
        below.filter(lambda one: not one.is_zero).map(lambda one: 1 / one),
    )


expressions = st.recursive(leaves, combined, max_leaves=8)


@given(expressions)
def test_an_expression_comes_back_from_its_formula_and_from_print(expression):
    formula = from_sympy(expression, str)
    assert to_sympy(formula, {}) - expression == 0
    assert sympy.simplify(to_sympy(read(to_latex(formula), WORDS), {}) - expression) == 0


def test_what_is_divided_by_stays_where_sympy_would_cancel_it():
    for sign in (1, -1):
        written = sympy.Mul(sign, x, sympy.Pow(x, -1), evaluate=False)
        assert r"\frac{x}{x}" in to_latex(from_sympy(written, str))


def test_roots_and_equations_come_back():
    for expression in (sympy.sqrt(x + y), (x + y) ** sympy.Rational(-3, 2), sympy.Eq(x, y**2)):
        assert to_sympy(from_sympy(expression, str), {}) == expression


@pytest.mark.parametrize(
    "expression", [x**y, sympy.sin(x), sympy.pi * x, x ** sympy.Rational(1, 3)]
)
def test_what_has_no_formula_is_refused(expression):
    with pytest.raises(TypeError, match="write LaTeX"):
        from_sympy(expression, str)


@pytest.mark.parametrize("tex", [r"\dot x", "x=y=1", r"x\ne y"])
def test_what_sympy_has_no_word_for_is_refused(tex):
    with pytest.raises(TypeError, match="SymPy is not told"):
        to_sympy(read(tex, WORDS), {})
