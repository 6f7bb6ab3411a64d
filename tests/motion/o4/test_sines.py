"""Sums of sines by Taylor polynomials."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.motion.o4.sines import SumsOfSines


@given(st.integers(1, 400), st.floats(0.05, 3), st.integers(0, 2**32 - 1))
def test_they_are_the_sums_and_their_derivatives_however_many_terms_there_are(terms, width, seed):
    """Coefficients that fall as those of a function analytic in a strip; any angle, of any turn."""
    chance = np.random.default_rng(seed)
    orders = np.arange(1, terms + 1)
    coefficients = chance.uniform(-1, 1, (2, terms)) * np.exp(-width * orders)
    angles = chance.uniform(-20, 20, 50)
    values, slopes = SumsOfSines(coefficients)(angles)
    multiples = np.outer(orders, angles)
    size = np.sum(np.abs(coefficients * orders))
    assert np.max(np.abs(values - coefficients @ np.sin(multiples))) < 1e-14 * (1 + size)
    steepest = np.sum(np.abs(coefficients * orders**2))
    assert np.max(np.abs(slopes - (coefficients * orders) @ np.cos(multiples))) < 1e-13 * (
        1 + steepest
    )


def test_of_the_angle_zero_and_its_turns_the_sums_vanish():
    values, _ = SumsOfSines(np.ones((1, 5)))(2 * np.pi * np.arange(-3, 4))
    assert np.max(np.abs(values)) < 1e-13
