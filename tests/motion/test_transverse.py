"""Across N⁴: the cofactor matrix along motions, and how fast motions near N⁴ leave it."""

from collections import defaultdict
from dataclasses import replace
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from kowalevski_cas.motion import Inadmissible, Motion, Parameters, coincidences, load, regime_of
from kowalevski_cas.motion.methods.closed import Closed
from kowalevski_cas.motion.methods.integrators import initial_state, integrate
from kowalevski_cas.motion.transverse import degenerate, exponent, kind, mean
from study.leaving import distance, transverse
from tests.motion.regions import EVERY_REGIME, SEPARATING, motion
from tests.motion.test_limits import edges
from tests.sample import sampled

closed = load("closed")
TIMES = np.linspace(0.1, 7.0, 40)


@pytest.mark.parametrize("region", EVERY_REGIME)
def test_motions_on_n4_stay_there(region):
    assert np.max(distance(closed(motion(*region), TIMES))) < 1e-11


def test_a_motion_off_n4_is_off_it():
    state = closed(motion("0.5", "1.45"), TIMES[:1])[0]
    state[2] += 1e-6
    assert distance(state) > 1e-7


@pytest.mark.parametrize("region", EVERY_REGIME)
def test_the_matrix_has_the_exponents_that_the_separated_variables_give(region):
    """The square of the eigenvalues of M is −m(s1−s2)², at every point."""
    here = motion(*region)
    first, second = Closed(here, 10.0).variables(TIMES, TIMES)
    m, regular = float(here.parameters.m), abs(first.weight) > 1e-3
    gap = first.s[regular] / first.weight[regular] - (second.s / second.weight)[regular]
    matrix = transverse(closed(here, TIMES[regular]))[1]
    assert np.all(matrix[:, 0, 0] == 0) and np.all(matrix[:, 1, 1] == 0)
    np.testing.assert_allclose(matrix[:, 0, 1] * matrix[:, 1, 0], -m * gap**2, rtol=1e-9)
    ratio = matrix[:, 1, 0] / matrix[:, 0, 1]
    np.testing.assert_allclose(ratio, 4 * float(here.parameters.r_square) ** 2 * m, rtol=1e-9)


def test_the_matrix_is_the_rate_of_the_functions_off_n4():
    start = initial_state(motion("0.5", "1.45")) + 0.05 * np.arange(9)
    step = 1e-4
    before, here, after = integrate("DOP853", start, np.array([1 - step, 1.0, 1 + step]), 1e-13)
    values, matrix = transverse(here)
    rate = (transverse(after)[0] - transverse(before)[0]) / (2 * step)
    np.testing.assert_allclose(matrix @ values, rate, rtol=1e-6)


@pytest.mark.parametrize("region", EVERY_REGIME)
def test_the_mean_of_a_variable_is_its_mean_over_a_period(region):
    """Simple poles, where s1 passes infinity, are taken away with their principal value, zero."""
    here = motion(*region)
    for index, oscillation in enumerate(here.oscillations()):
        period = float(2 * oscillation.quarter / oscillation.rate)
        t = (np.arange(2000) + 0.5) * period / 2000
        solve = Closed(here, period).variables
        values = solve(t, t)[index].s / solve(t, t)[index].weight
        if oscillation.arc.infinite:
            half = period / 2

            def weight(x, solve=solve, index=index):
                return float(solve(np.array([x]), np.array([x]))[index].weight[0])

            pole = brentq(weight, 0.0, half, xtol=1e-15)
            near = solve(np.array([pole - 1e-6]), np.array([pole - 1e-6]))[index]
            sign = np.sign(near.s[0] * near.weight[0])
            residue = -sign / np.sqrt(-float(here.parameters.m)) * np.pi / period
            for place, size in ((pole, residue), (-pole, -residue)):
                values = values - size / np.tan(np.pi * (t - place) / period)
        assert np.mean(values) == pytest.approx(float(mean(oscillation)), abs=2e-6)


@pytest.mark.parametrize(
    ("m", "ell"), sampled([("-0.8", "0.5"), ("-0.5", "0.8"), ("-0.3", "0.5")], 1)
)
def test_motions_leave_n4_at_the_predicted_rate(m, ell):
    """A displacement by 1e-12 grows like exp(|λ|t) while it is small."""
    here = motion(m, ell)
    rate = abs(exponent(here.parameters).real)
    state = initial_state(here)
    state[2] += 1e-12
    span = 20 / rate
    times = np.linspace(0, span, 4000)
    far = np.log(distance(integrate("DOP853", state, times, 1e-13)))
    late = times > 0.2 * span
    assert np.polyfit(times[late], far[late], 1)[0] == pytest.approx(rate, rel=0.1)


@pytest.mark.parametrize(
    ("m", "ell"), sampled([("0.8", "0.9"), ("0.5", "1.45"), ("0.3", "1.7")], 1)
)
def test_motions_near_elliptic_tori_stay_near(m, ell):
    here = motion(m, ell)
    assert exponent(here.parameters).real == 0 != exponent(here.parameters).imag
    state = initial_state(here)
    state[2] += 1e-9
    far = distance(integrate("DOP853", state, np.linspace(0, 200, 500), 1e-13))
    np.testing.assert_allclose(far, far[0], rtol=1e-2)


@given(st.fractions(-3, Fraction(-1, 10), max_denominator=30), st.fractions(0, Fraction(9, 10)))
def test_tori_on_which_ell_vanishes_are_not_hyperbolic(m, b):
    # The mirror s1, s2 → −s1, −s2 leads back to the same level: both means are zero.
    parameters = Parameters.of(1, b, m, 0)
    assume(coincidences(parameters) == ["ℓ = 0"])
    assert exponent(parameters) == 0 and kind(parameters) == "degenerate"


@given(st.fractions(-3, Fraction(-1, 10), max_denominator=30), st.fractions(0, Fraction(9, 10)))
def test_the_exponent_vanishes_on_the_curve_that_is_drawn(m, b):
    for regime, ell in degenerate(1, b, m):
        at, aside = Parameters.of(1, b, m, ell), Parameters.of(1, b, m, ell * 0.99)
        assert regime_of(at) == regime
        assert abs(exponent(at)) < 1e-3 * abs(exponent(aside))


@pytest.mark.parametrize("words", SEPARATING)
def test_the_exponent_is_finite_however_close_a_separating_curve(words):
    m, ell = map(Fraction, SEPARATING[words])
    for side, digits in product((-1, 0, 1), (3, 15, 30, 300)):
        try:
            parameters = Parameters.of(1, "0.4", m, ell + Fraction(side, 10**digits))
            regime_of(parameters)
        except Inadmissible:
            continue
        assert np.isfinite(exponent(parameters))
        assert (kind(parameters) == "elliptic") == (m > 0)


@settings(max_examples=10, deadline=None)
@given(edges(), st.integers(-30, 30))
def test_towards_every_edge_the_exponent_is_that_of_the_unit_of_time(moving, power):
    """It is real where m < 0, where it vanishes just if the torus is degenerate."""
    known, unit = moving.parameters, Fraction(2) ** power
    a, b, m = known.a * unit**2, known.b * unit**2, known.m / unit**2
    other = replace(known, a=a, b=b, m=m)
    here, there = exponent(known), exponent(other)
    assert there == pytest.approx(here * float(unit), rel=1e-12)
    assert (here.real, here.imag)[known.m < 0] == 0
    assert kind(known) == kind(other)
    assert (kind(known) == "hyperbolic") <= (here.real > 0)


@pytest.mark.slow
def test_inside_two_regimes_the_exponent_vanishes_on_a_curve_and_in_no_others():
    found = defaultdict(set)
    for m, ell in product(range(-60, 0, 2), range(1, 40, 2)):
        parameters = Parameters.of(1, "0.4", Fraction(m, 20), Fraction(ell, 20))
        try:
            regime = regime_of(parameters)
        except Inadmissible:
            continue
        if not coincidences(parameters):
            first, second = (mean(o) for o in Motion(parameters).oscillations())
            found[regime].add(first > second)
    changing = {" < ".join(regime.order) for regime, signs in found.items() if len(signs) == 2}
    assert len(found) == 6
    assert changing == {"A < -a < -b < b < C < a", "-a < A < -b < C < b < a"}
