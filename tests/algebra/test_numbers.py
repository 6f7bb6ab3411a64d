"""Exact points: numbers in towers of roots over the rationals, and ranks."""

from fractions import Fraction

import pytest
import sympy
from flint import fmpq, fmpq_mat
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra import EXACT, load
from kowalevski_cas.algebra.numbers import Substitution, number_ring, rank, rational, square_root
from tests.algebra.strategies import build, fractions, neutrals, tower

RINGS = {name: number_ring(load(name)) for name in EXACT}
every_ring = pytest.mark.parametrize("ring", RINGS.values(), ids=RINGS)
small = st.integers(-2, 2).map(Fraction)
matrices = st.tuples(st.integers(1, 4), st.integers(1, 4)).flatmap(
    lambda size: st.lists(
        st.lists(small, min_size=size[1], max_size=size[1]), min_size=size[0], max_size=size[0]
    )
)


@given(fractions)
def test_the_root_of_a_square_is_rational(value):
    assert square_root(value * value) == abs(value)
    root = square_root(abs(value))
    assert root is None or root * root == abs(value)


def test_no_rational_root():
    assert square_root(Fraction(2)) is None
    assert square_root(Fraction(-4)) is None
    assert square_root(Fraction(8, 2)) == 2


@every_ring
@given(matrices)
def test_ranks_are_those_of_flint_and_sympy(ring, matrix):
    found = rank([[ring.number(entry) for entry in row] for row in matrix])
    entries = [[fmpq(entry.numerator, entry.denominator) for entry in row] for row in matrix]
    assert found == fmpq_mat(entries).rank()
    assert found == sympy.Matrix(matrix).rank()


@every_ring
@given(st.lists(st.lists(st.tuples(small, small), min_size=3, max_size=3), min_size=3, max_size=3))
def test_ranks_of_complex_matrices_are_those_of_sympy(ring, matrix):
    i = ring.generator("i")
    found = rank([[ring.number(re) + ring.number(im) * i for re, im in row] for row in matrix])
    numbers = [
        [sympy.Rational(re) + sympy.I * sympy.Rational(im) for re, im in row] for row in matrix
    ]
    assert found == sympy.Matrix(numbers).rank(simplify=True)


@every_ring
def test_a_matrix_without_entries_has_rank_zero(ring):
    assert rank([]) == 0
    assert rank([[ring.zero, ring.zero]]) == 0


@pytest.mark.parametrize("name", EXACT)
@given(neutrals(), neutrals(), st.tuples(fractions, fractions, fractions))
def test_the_value_at_a_point_is_a_homomorphism(name, a, b, at):
    ring, numbers = tower(name), number_ring(load(name))
    values = {n: numbers.number(v) for n, v in zip("xyz", at, strict=True)}
    value = Substitution(ring, values, numbers)
    p, q = build(ring, a), build(ring, b)
    try:
        left, right = value(p), value(q)
    except ZeroDivisionError:  # the point is a zero of a denominator
        return
    assert (value(p * q) - left * right).is_zero
    assert (value(p + q) - left - right).is_zero


def test_roots_become_rational_where_their_squares_are_squares(name):
    ring, numbers = tower(name), number_ring(load(name))
    at = Substitution(
        ring, {"x": numbers.number(2), "y": numbers.number(8), "z": numbers.number(5)}, numbers
    )
    assert rational(at(ring.generator("s"))) == 4
    assert rational(at(ring.generator("r"))) == 3
    assert rational(at(ring.generator("i"))) is None


def test_an_irrational_root_is_adjoined_once(name):
    ring, numbers = tower(name), number_ring(load(name))
    at = Substitution(ring, {"x": numbers.number(2), "y": numbers.one, "z": numbers.zero}, numbers)
    s, r = at(ring.generator("s")), at(ring.generator("r"))
    assert rational(s) is None and rational(s * s) == 2
    assert (r**4 - numbers.number(2)).is_zero
    assert r"\sqrt{2}" in numbers.roots


def test_a_zero_of_a_denominator_is_refused(name):
    ring, numbers = tower(name), number_ring(load(name))
    at = Substitution(ring, {"x": numbers.zero, "y": numbers.one, "z": numbers.one}, numbers)
    with pytest.raises(ZeroDivisionError):
        at(ring.one / ring.generator("x"))
