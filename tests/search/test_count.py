"""How many solutions a system has, by the roots of an eliminant that is found."""

import pytest

from kowalevski_cas.algebra import load
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Count
from kowalevski_cas.problem.space import Space
from kowalevski_cas.problem.trees import decode
from kowalevski_cas.search.find import Finder

SQUARE, LEVEL = ["^", "x", 2], ["^", "a", 2]
PRODUCT = [(["+", SQUARE, ["^", "y", 2]], LEVEL), (["*", "x", "y"], 0)]
PARABOLA = [(["+", SQUARE, "y"], ["*", 2, LEVEL]), ("y", SQUARE)]


def asked(names, equations, number):
    """The number of solutions as a goal, with what finds evidence and what judges it."""
    space = Space(tuple(names), ("a",), nonzero=(decode("a"),))
    at = Evaluation(space, load("flint"))
    sides = tuple((decode(left), decode(right)) for left, right in equations)
    goal = Count(space, sides, tuple(names), number)
    return goal, Finder(lambda _: at), Judge(lambda _: at)


def found(names, equations, number):
    """The evidence for a number of solutions, which is accepted if there is any."""
    goal, finder, judge = asked(names, equations, number)
    evidence = finder.proof(goal)
    if evidence is not None:
        judge.holds(goal, evidence)
    return evidence


@pytest.mark.parametrize(
    "left", [SQUARE, ["+", SQUARE, ["*", 3, "x"]], ["+", ["*", 2, SQUARE], "x"]]
)
def test_a_quadratic_equation_has_two_solutions(left):
    assert found("x", [(left, LEVEL)], 2)
    assert not found("x", [(left, LEVEL)], 3)


def test_an_unknown_may_be_a_polynomial_in_another():
    assert found("xy", PARABOLA, 2)


def test_where_no_form_tells_all_unknowns_nothing_is_found():
    assert found("xy", PRODUCT, 4) is None


@pytest.mark.parametrize(
    ("names", "equations", "number"),
    [("x", [(SQUARE, LEVEL)], 1), ("x", [(SQUARE, LEVEL)], 3), ("xy", PRODUCT, 3)],
)
def test_another_number_of_solutions_is_denied(names, equations, number):
    goal, finder, judge = asked(names, equations, number)
    judge.denies(goal, finder.refutation(goal))


def test_one_constant_has_one_value_on_all_levels():
    goal, finder, _ = asked("xy", [(SQUARE, LEVEL), (["^", "y", 2], ["*", 2, LEVEL])], 1)
    assert finder.refutation(goal) is None
