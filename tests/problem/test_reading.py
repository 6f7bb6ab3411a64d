"""What the checker says of a formula."""

import re
from contextlib import suppress
from fractions import Fraction
from operator import mul, neg, truediv

from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.problem.checker import reading

NUMBERS = st.integers(-9, 9) | st.sampled_from("xyz")
FORMULAS = st.recursive(
    NUMBERS,
    lambda inner: (
        st.tuples(st.sampled_from("+*/"), inner, inner)
        | st.tuples(st.just("+"), inner, inner, inner)
        | st.tuples(st.just("-"), inner)
        | st.tuples(st.just("^"), inner, st.integers(0, 3))
    ).map(list),
    max_leaves=8,
)


@given(FORMULAS)
def test_what_is_said_of_a_formula_is_the_formula(formula):
    at = {"x": Fraction(2, 3), "y": Fraction(-5), "z": Fraction(7)}
    work = {
        "+": lambda *parts: sum(parts), "*": mul, "/": truediv, "-": neg, "^": pow,
    }  # fmt: skip

    def value(tree):
        if type(tree) is list:
            return work[tree[0]](*map(value, tree[1:]))
        return at[tree] if type(tree) is str else Fraction(tree)

    said = re.sub(r"\d+", r"Fraction(\g<0>)", reading.say(formula).replace("^", "**"))
    exponents = re.sub(r"\*\* Fraction\((\d)\)", r"** \1", said)
    with suppress(ZeroDivisionError):
        expected = value(formula)
        assert eval(exponents, {"Fraction": Fraction, **at}) == expected
