"""Printed formulas as functions: the same values in every arithmetic."""

from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.tower import Ring
from kowalevski_cas.library import LibraryError
from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.compile import function

states = st.lists(st.fractions(-3, 3, max_denominator=8), min_size=9, max_size=9)


@pytest.mark.parametrize("name", ["equations", "integrals", "constants"])
@given(states)
def test_fractions_floats_arrays_and_balls_agree(name, state):
    compiled = formulas.values_of_offer(name)
    exact = compiled(*state)
    floats = compiled(*map(float, state))
    arrays = compiled(*(np.array([float(x), 0.0]) for x in state))
    balls = compiled(*(arb(float(x)) for x in state))
    for value, number, array, enclosed in zip(exact, floats, arrays, balls, strict=True):
        assert isinstance(value, Fraction)
        assert number == pytest.approx(float(value), rel=1e-9, abs=1e-9)
        assert array[0] == pytest.approx(number, rel=1e-12, abs=1e-12)
        assert abs(float(enclosed.mid()) - float(value)) < 1e-9 * (1 + abs(float(value)))


@given(states)
def test_the_equations_are_those_of_the_paper(state):
    omega, alpha, beta = (np.array(state[k : k + 3], dtype=object) for k in (0, 3, 6))
    w1, w2, w3 = omega
    euler = [(w2 * w3 + beta[2]) / 2, -(w1 * w3 + alpha[2]) / 2, alpha[1] - beta[0]]
    poisson = [*np.cross(alpha, omega), *np.cross(beta, omega)]
    assert list(formulas.values_of_offer("equations")(*state)) == euler + poisson


def test_roots_quotients_and_repeated_products_are_written():
    ring = Ring(load("flint")(("x", "y")))
    x, y = ring.generator("x"), ring.generator("y")
    root = ring.adjoin("s", x * y)
    half = ring.number(Fraction(2, 3))
    compiled = function([half * root * x * y / (x + y), x * y * y, ring.zero], ["x", "y", "s"])
    value, product, zero = compiled(Fraction(2), Fraction(8), Fraction(4))
    assert (value, product, zero) == (Fraction(2, 3) * 4 * 16 / 10, 128, 0)


def test_a_library_that_offers_no_closed_form_says_so(monkeypatch):
    monkeypatch.setattr(formulas, "available", lambda: ["kharlamov2002"])
    formulas.source.cache_clear()
    try:
        with pytest.raises(LibraryError, match="no derivation in the library offers motions"):
            formulas.source()
    finally:
        formulas.source.cache_clear()
