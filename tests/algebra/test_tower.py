r"""The tower: polynomials with i, with s = \sqrt{xy} and r = \sqrt{z+s}, and fractions of them."""

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.algebra import EXACT, load
from kowalevski_cas.algebra.derivation import along, gradient
from kowalevski_cas.algebra.tower import Ring
from tests.algebra.strategies import build, fractions, neutrals, simple, terms, tower

TOWERS = {name: tower(name) for name in EXACT}
every_tower = pytest.mark.parametrize("ring", TOWERS.values(), ids=TOWERS)


def same(a, b):
    return (a - b).is_zero


@every_tower
def test_the_roots_have_their_squares(ring):
    i, s, r = map(ring.generator, "isr")
    x, y, z = map(ring.generator, "xyz")
    assert same(i * i, ring.number(-1))
    assert same(s * s, x * y)
    assert same(r * r, z + s)
    assert same(r**4, z * z + ring.number(2) * z * s + x * y)
    assert not same(s, x) and not (s + i).is_zero


@every_tower
@given(neutrals(), neutrals(), neutrals())
def test_elements_form_a_commutative_ring(ring, a, b, c):
    p, q, r = (build(ring, n) for n in (a, b, c))
    assert same(p + q, q + p)
    assert same(p * q, q * p)
    assert same((p + q) + r, p + (q + r))
    assert same((p * q) * r, p * (q * r))
    assert same(p * (q + r), p * q + p * r)
    assert same(p + ring.zero, p) and same(p * ring.one, p)
    assert (p - p).is_zero
    assert (p - q).terms() == (p + (-q)).terms()


@every_tower
@given(simple)
def test_what_is_not_zero_has_an_inverse(ring, a):
    p = build(ring, a)
    assume(not p.is_zero)
    assert same(p * p.inverse(), ring.one)
    assert same(p.inverse().inverse(), p)
    assert same(p**-2, (p * p).inverse())


@every_tower
@given(neutrals(), st.integers(0, 3))
def test_powers_are_repeated_products(ring, a, exponent):
    p, product = build(ring, a), ring.one
    for _ in range(exponent):
        product = product * build(ring, a)  # not p itself: squares are computed in another way
    assert same(p**exponent, product)


@every_tower
def test_nothing_is_divided_by_zero(ring):
    x, s, i = map(ring.generator, "xsi")
    with pytest.raises(ZeroDivisionError, match="vanishes identically"):
        x / (s * s - x * ring.generator("y"))
    assert same(ring.one / i, -i)


def test_a_unit_of_square_one_has_divisors_of_zero(name):
    ring = Ring(load(name)(("x",)))
    unit = ring.adjoin("i", ring.one)
    assert ((unit + ring.one) * (unit - ring.one)).is_zero
    with pytest.raises(ZeroDivisionError, match="divisor of zero"):
        (unit + ring.one).inverse()


@every_tower
@given(neutrals())
def test_the_sign_of_a_root_may_be_changed_throughout(ring, a):
    p = build(ring, a)
    bit = ring.roots.index("r")
    barred = p.conjugate_root(bit)
    assert same(barred.conjugate_root(bit), p)
    norm = p * barred
    assert same(norm.conjugate_root(bit), norm)


@every_tower
def test_fractions_remember_their_denominators(ring):
    x, y = ring.generator("x"), ring.generator("y")
    quotient = (x * x) / x
    assert same(quotient, x)
    assert [ring.polynomials.terms(ring.divisors[k]) for k in quotient.denominator] == [
        {(1, 0, 0): 1}
    ]
    total = ring.one / x + ring.one / (x + y)
    below = {frozenset(ring.polynomials.terms(ring.divisors[k])) for k in total.denominator}
    assert below == {frozenset({(1, 0, 0)}), frozenset({(1, 0, 0), (0, 1, 0)})}
    assert (quotient - x).is_zero


@every_tower
def test_a_monomial_is_divided_by_generator_by_generator(ring):
    x, y, s = map(ring.generator, "xys")
    inverse = ring.one / (ring.number(6) * x * x * y)
    found = {
        tuple(ring.polynomials.terms(ring.divisors[k])): e for k, e in inverse.denominator.items()
    }
    assert found == {((1, 0, 0),): 2, ((0, 1, 0),): 1}
    assert same(ring.one / s, s / (x * y))


@every_tower
@given(terms(3, 2), terms(3, 2))
def test_a_divisor_is_entered_once(ring, a, b):
    p, q = ring.from_terms({0: a}), ring.from_terms({0: b})
    first, second = p.inverse(), (q / p).denominator
    assert first.denominator.keys() <= second.keys()
    assert (ring.one / p + ring.one / p).denominator == first.denominator


def test_a_root_of_a_fraction_is_a_root_over_its_denominator(name):
    ring = Ring(load(name)(("x", "y")))
    x, y = ring.generator("x"), ring.generator("y")
    root = ring.adjoin("q", x / (x + y))
    assert same(root * root, x / (x + y))
    assert same(ring.generator("q") ** 2, x * (x + y))
    rate = along(root, {"x": ring.one})
    assert same(ring.number(2) * root * rate, along(x / (x + y), {"x": ring.one}))


@every_tower
def test_a_root_moves_at_half_the_rate_of_its_square_over_itself(ring):
    x, y, z, s, r = map(ring.generator, "xyzsr")
    field = {"x": y, "y": -x, "z": x * z}
    two = ring.number(2)
    assert same(two * s * along(s, field), along(x * y, field))
    assert same(two * r * along(r, field), along(z + s, field))
    assert along(ring.generator("i"), field).is_zero


@every_tower
@given(neutrals(), neutrals(), fractions)
def test_the_derivative_along_a_field_is_a_derivation(ring, a, b, number):
    x, y, z = map(ring.generator, "xyz")
    field = {"x": y, "y": -x, "z": x * z}
    p, q, factor = build(ring, a), build(ring, b), ring.number(number)
    assert same(along(p * q, field), along(p, field) * q + p * along(q, field))
    assert same(along(p + factor * q, field), along(p, field) + factor * along(q, field))


@every_tower
@given(simple, simple)
def test_the_derivative_of_a_quotient(ring, a, b):
    field = {"x": ring.generator("y"), "y": -ring.generator("x")}
    p, q = build(ring, a), build(ring, b)
    assume(not q.is_zero)
    assert same(along(p / q, field), (along(p, field) * q - p * along(q, field)) / (q * q))


@every_tower
@given(neutrals())
def test_the_derivative_along_a_field_is_the_gradient_applied_to_it(ring, a):
    p = build(ring, a)
    x, y, z = map(ring.generator, "xyz")
    total = ring.zero
    for partial, component in zip(gradient(p, ("x", "y", "z")), (y, -x, x * z), strict=True):
        total = total + partial * component
    assert same(total, along(p, {"x": y, "y": -x, "z": x * z}))


@every_tower
def test_an_unknown_name_is_refused(ring):
    with pytest.raises(ValueError):
        ring.generator("w")


@every_tower
def test_fractions_with_other_divisors_are_kept_apart(ring):
    x, y, z, s = map(ring.generator, "xyzs")
    a, b = (x + y).inverse(), (x - y).inverse()
    whole = s * a + z * b + x
    assert len(whole.summands) == 3
    assert same(whole * (x + y) * (x - y), s * (x - y) + z * (x + y) + x * (x * x - y * y))
    assert whole.terms() == (x + (z * b + s * a)).terms()
    assert same(a + b, ring.number(2) * x * a * b) and not (a + b).is_zero
    assert same((a + b) ** 2, a * a + ring.number(2) * a * b + b * b)
    assert same((a + b).inverse() * x * ring.number(2), x * x - y * y)


@every_tower
def test_what_was_divided_by_is_remembered_where_a_fraction_vanishes(ring):
    x, y, z = map(ring.generator, "xyz")
    a, b = (x + y).inverse(), (x - y).inverse()
    gone = a + b - a
    assert same(gone, b) and {*gone.denominator} == {*(a * b).denominator}
    rate = along(gone, {"x": z})
    assert same(rate, -(z * b * b)) and {*rate.denominator} == {*gone.denominator}
