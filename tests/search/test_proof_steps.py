"""Equations that follow one after another, each known from there on."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import Name, Number
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.problem.space import Space
from kowalevski_cas.search.proof_steps import in_turn
from tests.problem.test_accept import accepted, rejected

NAMES = ("x", "y", "p", "q")
SPACE = Space(NAMES)
AT = Evaluation(SPACE, load("flint"))
X, Y, P, Q = (AT.scalar(Name(name)) for name in NAMES)


def vanish(*elements):
    return tuple((formula_in(one), Number(0)) for one in elements)


def vanishing(known, conditions=()):
    """The goal that p = q = 0 wherever what is known vanishes, and a proof of it, if one is found."""
    goal = Follows(SPACE, (vanish(P, Q),), vanish(*known))
    return goal, in_turn(goal, AT, conditions)


small = st.integers(-2, 2).map(AT.ring.number)
coefficients = st.builds(lambda a, b, c: a + b * X + c * Y, small, small, small)


@settings(max_examples=settings.default.max_examples // 5)
@given(coefficients, coefficients, coefficients, coefficients)
def test_linear_equations_have_one_solution_where_the_determinant_is_not_zero(a, b, c, d):
    """And this is proved away from it, or not at all."""
    determinant = a * d - b * c
    goal, shown = vanishing((a * P + b * Q, c * P + d * Q), [determinant] * bool(determinant.parts))
    assert (shown is None) == determinant.is_zero
    if shown is not None:
        accepted(goal, shown)
        (step,) = shown.proof.cases
        for wrong in (step, shown.proof._replace(product=step.product or ((Number(1),),))):
            rejected(goal, shown._replace(proof=wrong))


def test_what_was_shown_is_known_from_there_on():
    """q to the sixth power is combined, and no smaller one: but q^3 is where p vanishes."""
    goal, shown = vanishing((P * P, Q**3 + P))
    accepted(goal, shown)
    assert shown.proof.power == 2 and shown.proof.cases[0].power == 3


@pytest.mark.parametrize("known", [(X * P, Y * Q), (P * Q, X * Q), (P, P * P), (X * P, X * Y * Q)])
def test_nothing_is_shown_that_needs_another_condition(known):
    assert vanishing(known, (X,))[1] is None
