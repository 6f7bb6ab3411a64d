"""Cofactors by Gröbner bases that are linear in some unknowns."""

from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.ideals import vanish_on
from kowalevski_cas.notation import Name
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Space
from kowalevski_cas.search.combinations import Combinations
from kowalevski_cas.search.follows import rows_of

NAMES = ("x", "y", "p", "q")
AT = Evaluation(Space(NAMES), load("flint"))
X, Y, P, Q = (AT.scalar(Name(name)) for name in NAMES)


def combined(target, generators, **more):
    """The row of a target, which is checked to combine it."""
    rows = Combinations([target], generators, **({"unknowns": ("p", "q")} | more)).rows([target])
    if rows is None:
        return None
    (row,) = rows
    total = sum((a * b for a, b in zip(row, generators, strict=True)), AT.ring.zero)
    assert (total - target).is_zero
    return row


def test_what_is_a_combination_only_through_an_s_polynomial():
    one = AT.ring.one
    assert combined(P, [X * P, (one - X) * P]) is not None
    assert combined(P, [X * Y - one, X * P]) is not None
    assert combined(P, [X * P + Q, Y * P, X * Y - one]) is not None
    assert combined(P, [X * P, Y * P]) is None


def test_a_condition_is_divided_by_where_nothing_else_helps():
    generators = [X * P, Y * P]
    row = combined(P, generators, conditions=[X * X + Y * Y])
    assert row is not None and any(entry.denominator for entry in row)
    row = combined(P, [X * P, (AT.ring.one - X) * P], conditions=[X * X + Y * Y])
    assert row is not None and not any(entry.denominator for entry in row)


def test_a_unit_may_be_divided_by():
    assert combined(P, [X * X * P], units=[X]) is not None
    assert combined(P, [X * X * P], units=[Y]) is None


def test_nothing_is_a_combination_of_nothing():
    assert combined(P, [AT.ring.zero]) is None


def divided(target, generators):
    """The row with the least condition, which is checked to combine the target."""
    row = Combinations([target], generators).division_row(target)
    if row is not None:
        total = sum((a * b for a, b in zip(row, generators, strict=True)), AT.ring.zero)
        assert (total - target).is_zero
    return row


def test_the_least_condition_is_found():
    (entry, _) = divided(P, [X * P + Q, Q])
    assert entry.denominator and (entry * X - AT.ring.one).is_zero
    assert divided(P, [X * Y * P]) is not None
    assert divided(P, [X * Y * Q * P]) is None  # its degree would be 3


def test_what_vanishes_with_the_generators_is_no_condition():
    assert divided(P, [X, Y]) is None
    assert divided(AT.ring.one, [X]) is None


small = st.integers(-2, 2).map(AT.ring.number)
coefficients = st.builds(lambda a, b, c: a + b * X + c * Y, small, small, small)


@given(st.lists(st.tuples(coefficients, coefficients), min_size=1, max_size=3), st.data())
def test_each_combination_is_found_again(pairs, data):
    """Whatever is combined from generators, with any coefficients, is recognised."""
    generators = [a * P + b * Q for a, b in pairs]
    factors = [data.draw(coefficients) for _ in generators]
    target = sum((f * g for f, g in zip(factors, generators, strict=True)), AT.ring.zero)
    assert target.is_zero or combined(target, generators) is not None


@given(coefficients, coefficients, st.data())
def test_what_is_divided_by_is_found(unit, factor, data):
    """If u t is combined from generators of which u is none, t is with a denominator."""
    other, target = data.draw(coefficients) * Q, P + Q
    generators = [unit * target + factor * other, other]
    assume(not unit.is_zero and all(not one.is_zero for one in generators))
    assert divided(target, generators) is not None


ONE = AT.ring.one


def follows(target, generators):
    """The power of a target that is combined from generators; the rows are checked to combine it."""
    found = rows_of([target], generators)
    if found is None:
        return None
    ((row,), power) = found
    total = sum((a * b for a, b in zip(row, generators, strict=True)), AT.ring.zero)
    assert (total - target**power).is_zero
    assert not any(entry.denominator for entry in row)
    return power


def test_what_no_division_shows():
    """On the circle (1 − t²)/(1 + t²), 2t/(1 + t²), which is never divided by zero."""
    two = AT.ring.number(2)
    circle = [X * (ONE + P * P) - (ONE - P * P), Y * (ONE + P * P) - two * P]
    assert follows(X * X + Y * Y - ONE, circle) == 1


def test_what_vanishes_where_others_do_without_being_combined_from_them():
    assert follows(X + Y, [X * X, Y * Y, X * Y]) == 2
    assert follows(P * X, [P * P * P * X, X * X * X * P]) == 3
    assert follows(X, [X * Y, X * X - Y]) == 3


general = st.builds(lambda a, b, c: a * P * Q + b * P + c, coefficients, coefficients, coefficients)


@given(st.lists(general, min_size=2, max_size=3), st.data())
def test_each_combination_follows(generators, data):
    """Whatever is combined from polynomials, of any degrees, is shown to be without a condition."""
    factors = [data.draw(coefficients) for _ in generators]
    target = sum((f * g for f, g in zip(factors, generators, strict=True)), AT.ring.zero)
    assert target.is_zero or follows(target, generators) == 1


@given(st.lists(general, min_size=1, max_size=2), st.data())
def test_what_vanishes_with_others_is_told_from_what_does_not(generators, data):
    """Where x does, so does each combination of multiples of x, and one more than that does not."""
    known = [X * generator for generator in generators]
    factors = [data.draw(coefficients) for _ in known]
    target = sum((f * g for f, g in zip(factors, known, strict=True)), AT.ring.zero)
    assert vanish_on([target, target + ONE, target], known) == [True, False, True]
