"""What is searched for has the property for which it is searched."""

from fractions import Fraction
from itertools import islice
from math import prod

import pytest
from flint import Ordering, fmpq, fmpq_mpoly_ctx
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.algebra.squares import sum_of_squares
from kowalevski_cas.notation import Name, Negative, Number, Power, Product, Quotient, Sum
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Exists, identity
from kowalevski_cas.problem.space import Space
from kowalevski_cas.search.cofactors import cofactors, pseudo_divide
from kowalevski_cas.search.find import Finder
from kowalevski_cas.search.levels import value
from kowalevski_cas.search.numbers import solve_for_numbers
from kowalevski_cas.search.place import PointFinder
from kowalevski_cas.search.points import constant, points
from kowalevski_cas.system import System
from kowalevski_cas.verify.outcome import in_latex
from tests.algebra.strategies import nonzero, simple, terms, tower
from tests.paper.small import Oscillator
from tests.sample import sampled

RING = tower("flint")
CONTEXT = fmpq_mpoly_ctx.get(("x", "y", "z"), Ordering.lex)


def polynomial(a):
    return CONTEXT.from_dict({e: fmpq(v.numerator, v.denominator) for e, v in a.items()})


@given(simple, simple, simple, simple)
def test_cofactors_of_a_combination_are_cofactors(a, b, g, h):
    a, b, g, h = (RING.from_terms(parts) for parts, _ in (a, b, g, h))
    assume(not g.is_zero and not h.is_zero)
    target = a * g + b * h
    found = cofactors(target, [g, h], [("x",), ("y",)])
    if found is not None:
        assert (target - found[0] * g - found[1] * h).is_zero


@given(simple, terms(2, 1))
def test_a_multiple_of_one_generator_is_recognised(a, g):
    a, g = RING.from_terms(a[0]), RING.from_terms({0: g})
    found = cofactors(a * g, [g], [])
    assert found is not None and (a * g - found[0] * g).is_zero


def test_no_combination_is_none():
    x, y = RING.generator("x"), RING.generator("y")
    assert cofactors(x, [y], [("x",), ("y",)]) is None
    assert cofactors(RING.one, [x, y], []) is None


@given(terms(3), terms(2, 1), terms(2, 1))
def test_pseudo_division_is_an_identity(a, g, h):
    p, q, r = map(polynomial, (a, g, h))
    for main in ((0, 1, 2), (0,), (1, 2)):
        unit, (s, t), rest = pseudo_divide(p, [q, r], main)
        assert unit * p == s * q + t * r + rest
        assert not any(unit.degrees()[k] for k in main)


@given(terms(3, 1), terms(3, 1))
def test_points_lie_on_their_constraints_and_off_what_they_avoid(a, b):
    p, q = polynomial(a), polynomial(b)
    for at in islice(points([p], range(3), [q]), 3):
        assert constant(p, at) == 0 != constant(q, at)


def test_points_of_a_sphere_and_of_nothing():
    x, y, z = CONTEXT.gens()
    found = list(islice(points([x**2 + y**2 + z**2 - 1, x * y - z**2 + z], range(3)), 2))
    assert all(
        constant(x**2 + y**2 + z**2 - 1, p) == 0 == constant(x * y - z**2 + z, p) for p in found
    )
    assert any(True for _ in points([x**2 + y**2 + z**2 - 1], range(3)))
    assert list(islice(points([x**2 + y**2 + z**2 + 1], range(3)), 1)) == []
    assert list(points([x - x + 1], range(3))) == []


rationals = st.fractions(-3, 3, max_denominator=4)


@given(st.sets(rationals, min_size=1, max_size=4), st.sets(rationals, min_size=1, max_size=2))
def test_all_rational_points_of_equations_in_one_unknown_after_another_are_found(roots, shifts):
    x, y, _ = CONTEXT.gens()
    one = CONTEXT.constant(1)
    f = prod((x - fmpq(r.numerator, r.denominator) for r in roots), start=x**2 - 2 * one)
    g = prod((y - x - fmpq(r.numerator, r.denominator) for r in shifts), start=one)
    found = {(at[0], at[1]) for at in points([f, g], range(2))}
    assert found == {(root, root + shift) for root in roots for shift in shifts}


@pytest.mark.slow
@settings(max_examples=settings.default.max_examples // 2)
@given(st.fractions(0, 5, max_denominator=6).filter(bool), st.booleans())
def test_a_constant_that_is_given_by_its_square_may_be_negative(value, rational):
    system = System(r"\dot x=bx")
    number = rf"\frac{{{value.numerator}}}{{{value.denominator}}}"
    square, root = (f"({number})^2", number) if rational else (number, rf"\sqrt{{{number}}}")
    special = system.where(f"b^2={square}")
    assert special.identity(f"b^2={square}").verdict == "proved"
    assert special.identity(f"b={root}").verdict == "refuted"


@given(st.lists(st.tuples(nonzero.map(abs), terms(3, 1)), min_size=1, max_size=3))
def test_a_sum_of_squares_is_one(squares):
    total = sum(
        (fmpq(f.numerator, f.denominator) * polynomial(base) ** 2 for f, base in squares),
        CONTEXT.constant(0),
    )
    sum_terms = {e: Fraction(int(v.p), int(v.q)) for e, v in total.to_dict().items()}
    found = sum_of_squares({tuple(map(int, e)): v for e, v in sum_terms.items()})
    if found is not None:
        assert all(factor > 0 for factor, _ in found)
        again = sum(
            (fmpq(f.numerator, f.denominator) * polynomial(b) ** 2 for f, b in found),
            CONTEXT.constant(0),
        )
        assert again == total


def test_what_is_negative_somewhere_is_no_sum_of_squares():
    one = Fraction(1)
    assert sum_of_squares({(2, 0): one, (0, 2): -one}) is None
    assert sum_of_squares({(2, 0): one, (1, 1): 3 * one, (0, 2): one}) is None
    assert sum_of_squares({(2, 0): one, (0, 1): one}) is None
    assert sum_of_squares({(1, 0): one}) is None


@given(st.fractions(-3, 3, max_denominator=4), st.fractions(-3, 3, max_denominator=4))
def test_numbers_for_which_an_identity_holds_are_found(a, b):
    """(p x + q y)² is (a x + b y)² for p, q = a, b, and for their negatives, only."""
    p, q, x, y = map(Name, "pqxy")
    p_x, q_y = (Quotient(Product(pair), Power(y, Number(2))) for pair in ((p, x), (q, y)))
    a_x, b_y = (
        Quotient(Product((fraction_formula(n), v)), Power(y, Number(2)))
        for n, v in ((a, x), (b, y))
    )
    sides = Power(Sum((p_x, q_y)), Number(2)), Power(Sum((a_x, b_y)), Number(2))
    space = Space(("x", "y"))
    finder = PointFinder(lambda space: Evaluation(space, load("flint")))
    found = solve_for_numbers(Exists((identity(space, sides),), numbers=("p", "q")), finder)
    shown = tuple(map(fraction_formula, (a, b))), tuple(map(fraction_formula, (-a, -b)))
    assert found is not None and tuple(found.values()) in shown
    other = Product((Number(2), sides[1]))
    none = solve_for_numbers(
        Exists((identity(space, (sides[0], other)),), numbers=("p", "q")), finder
    )
    assert (none is None) == (a != 0 or b != 0)  # 2 is no square


@given(st.integers(1, 3), st.sampled_from(["", "A", "AB", "ABC"]))
def test_a_point_where_something_fails_is_small_and_its_constants_are_positive(many, constants):
    """So a reader evaluates both sides by himself, and no body has a negative moment of inertia."""
    variables = tuple("xyz"[:many])
    space = Space(variables, tuple(constants))
    one, other = Product((*map(Name, (*variables, *constants)), Number(2))), Name(variables[0])
    evidence = Finder(finder_of).refutation(identity(space, (one, other)))
    found = evidence.point.values
    whole = [v for v in found.values() if isinstance(v, Number | Negative)]
    assert len(whole) == len(found)
    assert all(node.value <= 4 for v in whole for node in v.nodes() if isinstance(node, Number))
    assert all(isinstance(found[name], Number) for name in constants)


@pytest.mark.slow
def test_it_is_whole_where_something_may_vanish_also_on_a_sphere():
    """Of x² + y² + z² = 1 the points in general position are fractions."""
    system = System(r"\dot x=wy, \dot y=-wx, \dot z=0")
    claim = system.implication("x+y+2z=3", given="x^2+y^2+z^2=1")
    found = claim.outcome.counterexample.point.values.values()
    assert not any(isinstance(node, Quotient) for value in found for node in value.nodes())


def test_of_what_has_many_terms_one_point_is_enough(monkeypatch):
    monkeypatch.setattr("kowalevski_cas.search.follows.LARGE", 0)
    monkeypatch.setattr("kowalevski_cas.search.real.LARGE", 0)
    x, y = Name("x"), Name("y")
    sides = (Quotient(Sum((x, y)), Sum((x, Negative(y)))), Number(1))
    found = Finder(finder_of).refutation(identity(Space(("x", "y")), sides)).point.values
    assert found["y"] != Number(0) and found["x"] != found["y"]


def test_the_value_of_a_polynomial():
    assert value({(2, 1): Fraction(3), (0, 0): Fraction(1)}, (Fraction(1, 2), 4)) == 4


@pytest.mark.parametrize(
    ("wrong", "right"),
    sampled(
        [
            (r"\dot x = -v", r"\dot{x} = v"),
            (r"\dot x = x", r"\dot{x} = v"),
            (r"2E = x^2 - v^2", "2E = x^2 + v^2"),
            (r"2E = x^2 + v", "2E = x^2 + v^2"),
            (r"2E = x^3 + v^2", "2E = x^2 + v^2"),
            (r"3E = x^2 + v^2", "2E = x^2 + v^2"),
            (r"E = x^2 + v^2", None),
            (r"\frac{d}{dt}(xv) = v^2 - x", r"\frac{d}{dt}(xv) = v^2 - x^2"),
        ],
        2,
    ),
)
def test_a_single_slip_is_mended(wrong, right):
    outcome = Oscillator().outcome(Identity, wrong)
    assert outcome.verdict == "refuted"
    assert outcome.correction is not None and outcome.correction.verdict.green
    if right is not None:
        assert in_latex(outcome.correction.formulas).replace(" ", "") == right.replace(" ", "")


@pytest.mark.slow
def test_real_points_on_circles_that_hang_together():
    """As those of elliptic functions do: s = 4/5, c = 3/5, k = 3/4, w = 4/5 is one."""
    system = System(r"\dot s=cw,\quad\dot c=-sw,\quad\dot w=-k^2sc")
    circles = ("s^2+c^2=1", "w^2+k^2s^2=1")
    claim = system.implication(r"\frac{1}{scwk}=\frac{1}{kwcs}", given=circles)
    assert str(claim.verdict) == "conditional"
