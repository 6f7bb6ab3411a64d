"""Straight-line programs: values at points, derivatives as series, and how large they are at most."""

from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.bounds import Sizes
from kowalevski_cas.algebra.derivation import along
from kowalevski_cas.algebra.modular import SampledPrograms
from kowalevski_cas.algebra.series import Series, inverse, power
from kowalevski_cas.algebra.tower import Ring
from kowalevski_cas.algebra.valuation import Valuation
from tests.sample import sampled

NAMES = ("x", "y")

numbers = st.integers(-3, 3)
recipes = st.recursive(
    numbers | st.sampled_from([*NAMES, "s"]),
    lambda inner: (
        st.tuples(st.sampled_from("+*/"), inner, inner)
        | st.tuples(st.just("^"), inner, st.integers(0, 3))
        | st.tuples(st.just("d"), inner)
    ),
    max_leaves=6,
)
"""Computations with x, y, s = sqrt(x y + 1) and the derivative along x' = y, y' = -x²."""


def programs():
    ring = SampledPrograms(NAMES)
    ring.adjoin("s", ring.generator("x") * ring.generator("y") + ring.one)
    return ring


def tower():
    ring = Ring(load("flint")(NAMES))
    ring.adjoin("s", ring.generator("x") * ring.generator("y") + ring.one)
    return ring


def field(ring):
    x, y = map(ring.generator, NAMES)
    return {"x": y, "y": -(x * x)}


def build(recipe, ring, motion):
    match recipe:
        case int():
            return ring.number(recipe)
        case str():
            return ring.generator(recipe)
        case ("d", f):
            return along(build(f, ring, motion), motion)
        case ("^", f, n):
            return build(f, ring, motion) ** n
        case (op, f, g):
            a, b = build(f, ring, motion), build(g, ring, motion)
            return {"+": a.__add__, "*": a.__mul__, "/": a.__truediv__}[op](b)


def at(element, ring, x, y, s):
    """The exact value of an element of the tower."""
    total = Fraction(0)
    for mask, terms in element.terms().items():
        value = sum((c * x ** e[0] * y ** e[1] for e, c in terms.items()), Fraction(0))
        total += value * s if mask else value
    for index, exponent in element.denominator.items():
        below = ring.polynomials.terms(ring.divisors[index])
        total /= sum(c * x ** e[0] * y ** e[1] for e, c in below.items()) ** exponent
    return total


@given(recipes)
def test_a_program_has_the_value_of_the_expanded_element(recipe):
    one, other = programs(), tower()
    try:
        element = build(recipe, other, field(other))
        program = build(recipe, one, field(one))
        x, y, s = Fraction(3), Fraction(5), Fraction(4)  # 3·5 + 1 = 4²
        expected = at(element, other, x, y, s)
        point = Valuation(lambda value: value, {"x": x, "y": y}, lambda name, square: s)
        assert point(program) == expected
    except ZeroDivisionError:
        assume(False)


@given(recipes)
def test_degree_and_height_are_bounds(recipe):
    one, other = programs(), tower()
    try:
        element = build(recipe, other, field(other))
        program = build(recipe, one, field(one))
    except ZeroDivisionError:
        assume(False)
    size = Sizes()(program)
    # The tower reduces s², which may lower or raise the degree; without s it is the same ring.
    assume("s" not in str(recipe) and not element.denominator and not size.below)
    terms = element.terms().get(0, {})
    assert max(map(sum, terms), default=0) <= size.degree
    assert sum(map(abs, terms.values())) <= 2**size.bits * 1.000001


def test_a_bound_that_is_met():
    ring = programs()
    x, y = map(ring.generator, NAMES)
    assert Sizes()(x**3 * y + x).degree == 4
    assert Sizes()((x + y) ** 5).bits == pytest.approx(5)
    assert Sizes()(ring.one / x + ring.one / y).degree == 1


@given(recipes)
def test_what_vanishes_is_seen_to_and_what_does_not_is_not(recipe):
    ring = programs()
    try:
        program = build(recipe, ring, field(ring))
        assert (program - program).is_zero
        assert not (program - program + ring.number(Fraction(1, 7))).is_zero
    except ZeroDivisionError:
        assume(False)


def test_the_relation_of_a_root_is_known():
    ring = programs()
    x, y, s = map(ring.generator, (*NAMES, "s"))
    assert (s * s - x * y - ring.one).is_zero
    assert not s.is_zero


def test_derivatives_of_any_order_are_those_of_a_known_motion():
    # x' = x: the k-th derivative of x² is 2^k x².
    ring = SampledPrograms(("x",))
    x = ring.generator("x")
    motion, value = {"x": x}, x * x
    for _ in range(12):
        value = along(value, motion)
    assert (value - ring.number(2**12) * x * x).is_zero


def test_partial_derivatives_and_motions_do_not_commute_and_mix_rightly():
    ring = SampledPrograms(NAMES)
    x, y = map(ring.generator, NAMES)
    motion, direction = {"x": x * y, "y": x}, {"x": ring.one}
    f = x * x * y
    # by hand: D f = 2x²y² + x³, ∂D f = 4xy² + 3x²; ∂f = 2xy, D∂f = 2xy² + 2x²
    assert (
        along(along(f, motion), direction) - (ring.number(4) * x * y**2 + ring.number(3) * x**2)
    ).is_zero
    assert (along(along(f, direction), motion) - ring.number(2) * (x * y**2 + x**2)).is_zero


fractions = st.builds(Fraction, st.integers(-5, 5), st.integers(1, 4))
series = st.lists(fractions, min_size=4, max_size=4).map(lambda c: Series(0, c))


@given(series, series)
def test_series_multiply_like_polynomials_and_obey_leibniz(a, b):
    product = [
        sum(a.coefficients[j] * b.coefficients[k - j] for j in range(k + 1)) for k in range(4)
    ]
    assert (a * b).coefficients == product
    left = (a * b).derivative()
    right = a.derivative() * b + a * b.derivative()
    assert left.coefficients == right.coefficients
    assert power(a, 3).coefficients == (a * a * a).coefficients


@given(series)
def test_series_have_inverses_and_roots(a):
    assume(a.coefficients[0] != 0)
    assert (a * inverse(a)).coefficients == [1, 0, 0, 0]
    assert ((a * a).root(a.coefficients[0])).coefficients == a.coefficients


def test_a_series_without_constant_term_has_no_inverse():
    with pytest.raises(ZeroDivisionError):
        inverse(Series(0, [Fraction(0), Fraction(1)]))


@pytest.mark.parametrize("chain", sampled(["+", "*", "both"], 1))
def test_a_program_may_have_more_steps_than_python_calls_within_each_other(chain):
    ring, size = SampledPrograms(NAMES), 20_000
    x, y = map(ring.generator, NAMES)
    program = x
    for k in range(size):
        program = program * y if chain == "*" or (chain == "both" and k % 2) else program + y
    value = Valuation(Fraction, {"x": Fraction(3), "y": Fraction(1)}, lambda name, square: square)
    added = {"+": size, "*": 0, "both": size // 2}[chain]
    assert value(program) == 3 + added
