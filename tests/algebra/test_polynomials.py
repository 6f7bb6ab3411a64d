"""FLINT, SymEngine and SymPy compute in one and the same ring of polynomials."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra import EXACT, load
from tests.algebra.strategies import NAMES, fractions, terms

RINGS = {name: load(name)(NAMES) for name in EXACT}
every_ring = pytest.mark.parametrize("ring", RINGS.values(), ids=RINGS)


def value(polynomial, at):
    """A polynomial in neutral form at a point, by Python's fractions."""
    total = Fraction(0)
    for exponents, coefficient in polynomial.items():
        for x, exponent in zip(at, exponents, strict=True):
            coefficient *= x**exponent
        total += coefficient
    return total


@every_ring
@given(terms(), terms(), terms())
def test_addition_and_multiplication_obey_the_axioms_of_a_commutative_ring(ring, a, b, c):
    p, q, r = map(ring.from_terms, (a, b, c))
    assert p + q == q + p
    assert (p + q) + r == p + (q + r)
    assert p * q == q * p
    assert (p * q) * r == p * (q * r)
    assert p * (q + r) == p * q + p * r
    assert p + ring.zero == p
    assert p * ring.one == p
    assert p - q == p + (-q) == -(q - p)
    assert not p + (-p)
    assert not p * ring.zero


@every_ring
@given(terms(), terms(), terms())
def test_polynomials_are_equal_if_they_have_the_same_neutral_form(ring, a, b, c):
    p, q, r = map(ring.from_terms, (a, b, c))
    made = [p, q, -p, p + q, p - q, p * q - r, (p - q) * r, p * r - q * r, p + q - q]
    made += [ring.derivative(p * p, 0), p * ring.derivative(p, 0) + ring.derivative(p, 0) * p]
    for one in made:
        assert bool(one) == bool(ring.terms(one))
        assert one == ring.from_terms(ring.terms(one))
        assert all((one == other) == (ring.terms(one) == ring.terms(other)) for other in made)


@every_ring
@given(terms(least=1))
def test_the_generators_in_a_polynomial_and_whether_it_has_one_term(ring, a):
    polynomial = ring.from_terms(a)
    assert {*ring.occurring_places(polynomial)} == {k for e in a for k in range(3) if e[k]}
    assert ring.is_monomial(polynomial) == (len(a) == 1)


@every_ring
@given(terms())
def test_the_neutral_form_is_the_polynomial(ring, a):
    assert ring.terms(ring.from_terms(a)) == a


@every_ring
def test_the_neutral_form_of_numbers_and_generators(ring):
    assert ring.terms(ring.zero) == {}
    assert ring.terms(ring.one) == {(0, 0, 0): 1}
    assert ring.terms(ring.constant(Fraction(-2, 3))) == {(0, 0, 0): Fraction(-2, 3)}
    assert ring.terms(ring.generator(1)) == {(0, 1, 0): 1}


@every_ring
@given(terms(), terms())
def test_only_zero_is_zero(ring, a, b):
    assert (not ring.from_terms(a)) == (not a)
    assert (not ring.from_terms(a) - ring.from_terms(b)) == (a == b)


@every_ring
@given(terms(), terms(), fractions, st.integers(0, 2))
def test_a_partial_derivative_is_a_derivation(ring, a, b, number, k):
    p, q = ring.from_terms(a), ring.from_terms(b)
    d = ring.derivative
    assert d(p * q, k) == d(p, k) * q + p * d(q, k)
    factor = ring.constant(number)
    assert d(p + factor * q, k) == d(p, k) + factor * d(q, k)


@every_ring
def test_partial_derivatives_of_generators_are_the_unit_matrix(ring):
    for j in range(3):
        for k in range(3):
            assert ring.terms(ring.derivative(ring.generator(j), k)) == (
                {(0, 0, 0): 1} if j == k else {}
            )


@given(terms(), terms(), st.integers(0, 2))
def test_the_three_agree(a, b, k):
    results = []
    for ring in RINGS.values():
        p, q = ring.from_terms(a), ring.from_terms(b)
        made = (p + q, p * q, -p, p - q, ring.derivative(p * p, k))
        results.append([ring.terms(polynomial) for polynomial in made])
    assert results[0] == results[1] == results[2]


@every_ring
@given(terms(), terms(), st.tuples(fractions, fractions, fractions))
def test_evaluation_at_a_point_is_a_homomorphism(ring, a, b, at):
    p, q = ring.from_terms(a), ring.from_terms(b)
    assert value(ring.terms(p * q), at) == value(a, at) * value(b, at)
    assert value(ring.terms(p - q), at) == value(a, at) - value(b, at)


@every_ring
@given(terms(), st.tuples(fractions, fractions, fractions))
def test_numbers_in_place_of_generators_give_the_value_there(ring, a, at):
    put_in = ring.substitution([ring.constant(x) for x in at], ring)
    assert put_in(ring.from_terms(a)) == ring.constant(value(a, at))


@every_ring
@given(terms(), terms(), st.tuples(terms(2), terms(2), terms(2)))
def test_polynomials_in_place_of_generators_are_a_homomorphism(ring, a, b, images):
    p, q = ring.from_terms(a), ring.from_terms(b)
    values = [ring.from_terms(image) for image in images]

    image = ring.substitution(values, ring)
    assert [image(ring.generator(k)) for k in range(3)] == values
    assert image(ring.one) == ring.one
    assert image(p * q) == image(p) * image(q)
    assert image(p - q) == image(p) - image(q)


@pytest.mark.parametrize("name", EXACT)
@given(fractions)
def test_a_number_without_generators_is_the_same_among_others(name, number):
    plain, target = load(name)(()), RINGS[name]
    assert plain.substitution([], target)(plain.constant(number)) == target.constant(number)


@every_ring
def test_a_power_of_a_sum_has_binomial_coefficients(ring):
    power = ring.one
    for _ in range(6):
        power = power * (ring.generator(0) + ring.one)
    assert [ring.terms(power)[k, 0, 0] for k in range(7)] == [1, 6, 15, 20, 15, 6, 1]


def test_an_unknown_arithmetic_is_refused_with_the_known_ones():
    with pytest.raises(
        ValueError, match="unknown arithmetic “maple”; there are flint, symengine, sympy"
    ):
        load("maple")
