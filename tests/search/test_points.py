"""Rational points of constraints: the same whoever asks, and found where some can be."""

from fractions import Fraction
from itertools import islice

import pytest
from flint import Ordering, fmpq_mpoly_ctx

from kowalevski_cas.search import points as room
from kowalevski_cas.search.points import constant, points

CONTEXT = fmpq_mpoly_ctx.get(("x", "y", "z", "u"), Ordering.lex)
X, Y, Z, U = CONTEXT.gens()
ALL = range(4)


@pytest.fixture(autouse=True)
def nothing_is_kept():
    room._kept.clear()


def first(constraints, size=12, avoid=()):
    return [*islice(points(constraints, ALL, avoid), size)]


SYSTEMS = [
    ("a sphere", [X**2 + Y**2 + Z**2 - 1]),
    ("two quadrics", [X**2 - Y * Z, U**2 - X * Z - Y**2]),
    ("a linear one beside a quadric", [X - 2 * Y, X * Z + U**2 - 1]),
]


@pytest.mark.parametrize("constraints", [s[1] for s in SYSTEMS], ids=[s[0] for s in SYSTEMS])
def test_constraints_vanish_at_each_point(constraints):
    found = first(constraints)
    assert found
    for point in found:
        assert all(constant(c, point) == 0 for c in constraints)


@pytest.mark.parametrize("constraints", [s[1] for s in SYSTEMS], ids=[s[0] for s in SYSTEMS])
def test_who_asks_again_or_meanwhile_gets_the_same_points(constraints):
    alone = first(constraints)
    room._kept.clear()
    one, other = points(constraints, ALL), points(constraints, ALL)
    pairs = [*islice(zip(one, other, strict=False), len(alone))]
    assert pairs == [(point, point) for point in alone] and first(constraints) == alone


def test_what_is_avoided_by_one_is_no_loss_of_another():
    sphere = [X**2 + Y**2 + Z**2 - 1]
    some = first(sphere, avoid=[X - Y])
    assert all(point[0] != point[1] for point in some)
    assert {str(p) for p in some} < {str(p) for p in first(sphere, 40)}


def test_points_of_few_constraints_are_kept():
    for number in range(2 * room.KEPT):
        first([X**2 - Y * Z - number], 1)
    assert len(room._kept) == room.KEPT


def test_unknowns_that_no_equation_gives_are_not_solved_for():
    # for x and y one would have to solve two quadratic equations at once
    both = [X**2 + X * Y + Y**2 + Z - 1, X**2 - 3 * X * Y + Y**2 + U * Z**2]
    assert not room._is_solvable(both, (0, 1))
    assert room._is_solvable(both, (2, 3)) and room._is_solvable(both, (0, 3))
    assert first(both)


def test_a_quadratic_equation_has_the_roots_of_its_formula():
    assert [*room._solve_one(X**2 - 2)] == []
    assert [*room._solve_one(4 * X**2 - 9)] == [{0: Fraction(3, 2)}, {0: Fraction(-3, 2)}]
    assert [*room._solve_one(X**2 - 2 * X + 1)] == [{0: Fraction(1)}]


def test_who_is_interrupted_loses_no_points(monkeypatch):
    x, y = fmpq_mpoly_ctx.get(("g0", "g1"), Ordering.lex).gens()
    circle = [x**2 + y**2 - 7 * x * y - 1]
    room._kept.clear()
    whole = [*islice(points(circle, [0, 1]), 5)]
    room._kept.clear()
    complete, calls = room._complete, []

    def interrupted(*arguments):
        calls.append(arguments)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return complete(*arguments)

    monkeypatch.setattr(room, "_complete", interrupted)
    with pytest.raises(KeyboardInterrupt):
        [*islice(points(circle, [0, 1]), 5)]
    assert [*islice(points(circle, [0, 1]), 5)] == whole
