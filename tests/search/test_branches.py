"""Polynomial equations by cases: no solution is lost, and what a case says solves them."""

import pytest
from flint import Ordering, fmpq, fmpq_mpoly_ctx
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.search.branches import branches

CONTEXT = fmpq_mpoly_ctx.get(("x", "y", "z"), Ordering.lex)
X, Y, Z = CONTEXT.gens()
ONE = CONTEXT.constant(1)


def cases(*equations, nonzero=()):
    """The equations of each case, as they are printed."""
    found = branches(equations, (0, 1, 2), nonzero)
    return {tuple(sorted(map(str, branch.equations))) for branch in found}


@pytest.mark.parametrize(
    ("equations", "expected"),
    [
        ((X * Y,), {("x",), ("y",)}),
        ((X * Y, X * Z), {("x",), ("y", "z")}),
        ((X * Y - ONE,), {("x*y - 1",)}),
        ((X * X + Y * Y,), {("x^2 + y^2",)}),
        ((X * X - Y * Y, X - Y), {("x - y",)}),
        ((X * (Y - 1), Y * X - Z), {("x", "z"), ("x - z", "y - 1")}),
        ((X, X - ONE), set()),
        ((), {()}),
    ],
)
def test_cases(equations, expected):
    assert cases(*equations) == expected


def test_what_does_not_vanish_is_divided_by():
    assert cases(X * Y - X * Z, nonzero=[X]) == {("y - z",)}
    assert cases(X * Y, nonzero=[X, Y]) == set()


numbers = st.integers(-2, 2)
points = st.tuples(numbers, numbers, numbers)
linear = st.tuples(numbers, numbers, numbers).map(lambda c: c[0] * X + c[1] * Y + c[2] * Z)
forms = st.builds(lambda a, b, c: a * b + c, linear, linear, linear)


@given(points, st.lists(st.tuples(forms, forms), min_size=1, max_size=3))
def test_each_solution_is_in_a_case(point, pairs):
    """Products one factor of which vanishes at a point: it is found again."""
    equations = [(a - a(*point)) * b for a, b in pairs]
    found = [*branches(equations, (0, 1, 2))]
    assert any(all(one(*point) == 0 for one in branch.equations) for branch in found)


@given(st.lists(st.tuples(forms, forms), min_size=1, max_size=3), points)
def test_what_a_case_says_solves_the_equations(pairs, values):
    equations = [a * b for a, b in pairs]
    for branch in branches(equations, (0, 1, 2)):
        if branch.rest:
            continue
        point = [fmpq(value) for value in values]
        defined = True
        for place, equation in branch.solved:  # no unknown stands in two of them
            own = CONTEXT.gens()[place]
            slope = equation.derivative(place)
            below = slope(*values)
            defined = defined and below != 0
            if defined:
                point[place] = (slope * own - equation)(*values) / below
        if defined:
            assert all(equation(*point) == 0 for equation in equations)
