"""Where λ = 0: constants and states on these curves are told as degenerate, to the last digit."""

from contextlib import suppress
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.optimize import brentq

from kowalevski_cas.motion import Inadmissible, Motion, Parameters, load, regime_of
from kowalevski_cas.motion.regimes import all_regimes, coincidences, ells
from kowalevski_cas.motion.transverse import degenerate, difference, kind, kind_at

INSIDE = [regime for regime in all_regimes() if next(degenerate(1, "0.4", "-0.4"))[0] == regime]
INSIDE += [regime for regime in all_regimes() if next(degenerate(1, "0.7", "-1.2"))[0] == regime]
"""The regimes inside which there is such a curve."""

closed, balls = load("closed"), load("ball")

sizes = st.floats(-12, -0.3).map(lambda power: 10.0**power)
shorter = st.one_of(sizes, sizes.map(lambda x: 1 - x), st.floats(0.01, 0.99))
slopes = st.floats(-5, 3).map(lambda power: -(10.0**power))
"""The length b of one field, where the other is 1, and m < 0, towards all their edges."""


def neighbours(function, low, high):
    """The floats beside one another between which a function changes its sign."""
    here = brentq(function, low, high, xtol=1e-300, rtol=4 * np.finfo(float).eps)
    start = function(low) > 0
    while (function(here) > 0) == start:
        here = float(np.nextafter(here, high))
    while (function(here) > 0) != start:
        here = float(np.nextafter(here, low))
    return here, float(np.nextafter(here, high))


@st.composite
def curves(draw):
    """The constants a = 1, b, m and the two floats ℓ beside a point of a curve, if it has any."""
    b, m = draw(shorter), draw(slopes)
    for regime in INSIDE:
        low, high = ells(Parameters.of(1, b, m, 0), regime)
        first, last = (low + share * (high - low) for share in (1e-9, 1 - 1e-9))
        if low < first < last < high < np.inf:

            def signed(ell):
                return difference(Parameters.of(1, b, m, ell))

            if signed(first) * signed(last) < 0:
                return b, m, neighbours(signed, first, last)
    assume(False)
    raise AssertionError


@pytest.mark.slow
@given(curves(), st.sampled_from([-9.0, 9.0]))
def test_on_the_curve_constants_are_degenerate_to_the_last_digit(curve, side):
    """All of ℓ, in binary and in 17 digits, the energy, and b or m off by the last digit."""
    b, m, beside = curve
    for ell in beside:
        for one in (ell, f"{ell:.17g}", f"{ell:.16e}"):
            assert kind(Parameters.of(1, b, m, one)) == "degenerate"
        assert kind(Parameters.of(1, np.nextafter(b, side), m, ell)) == "degenerate"
        assert kind(Parameters.of(1, b, np.nextafter(m, side), ell)) == "degenerate"

    def signed(h):
        return difference(Parameters.at_energy(1, b, m, h))

    wide = 1e-9 * (1 + abs(beside[0] / m))
    middle = float(Parameters.of(1, b, m, beside[0]).h)
    try:
        energies = neighbours(signed, middle - wide, middle + wide)
    except (Inadmissible, ValueError):
        return
    for h in energies:
        assert kind(Parameters.at_energy(1, b, m, h)) == "degenerate"
        assert kind(Parameters.at_energy(1, b, m, f"{h:.17g}")) == "degenerate"


@given(curves(), st.integers(6, 12))
def test_beside_the_curve_they_are_hyperbolic(curve, digits):
    b, m, (ell, _) = curve
    known = Parameters.of(1, b, m, ell)
    for side in (1, -1):
        off = ell * (1 + side * 10.0**-digits)
        with suppress(Inadmissible):
            beside = Parameters.of(1, b, m, off)
            if regime_of(beside) == regime_of(known):
                assert kind(beside) == "hyperbolic"


@given(shorter, slopes, st.integers(-20, 20))
def test_where_ell_vanishes_the_energy_is_degenerate_to_the_last_digit(b, m, unit):
    """The energy is the greatest one for such b and m: beyond its last digit there is no motion."""
    fields = 2.0 ** (2 * unit)
    known = Parameters.of(fields, b * fields, m / fields, 0)
    assume(not {*coincidences(known)} - {"ℓ = 0"})
    here = float(known.h)
    told = []
    for h in (here, f"{here:.17g}", np.nextafter(here, -np.inf), np.nextafter(here, np.inf)):
        with suppress(Inadmissible):
            told.append(kind(Parameters.at_energy(known.a, known.b, known.m, h)))
    assert told and {*told} == {"degenerate"}


ORIGINS = st.tuples(*[st.fractions(-9, 9, max_denominator=50)] * 2)


@pytest.mark.slow
@given(curves(), ORIGINS, st.floats(-100, 100), st.integers(-20, 20))
def test_states_on_the_curve_are_degenerate_in_any_unit_of_time(curve, origins, time, unit):
    b, m, (low, high) = curve
    first, last = (difference(Parameters.of(1, b, m, ell)) for ell in (low, high))
    ell = Fraction(low) + Fraction(first / (first - last)) * (Fraction(high) - Fraction(low))
    fields = 2.0 ** (2 * unit)
    moving = Motion(Parameters.of(fields, b * fields, m / fields, ell), origins)
    for follow in (closed, balls):
        (state,) = follow(moving, np.array([time * 2.0**-unit]))
        assert kind_at(state.tolist()) == "degenerate"


@pytest.mark.slow
@given(shorter, slopes, ORIGINS, st.floats(-100, 100), st.integers(-20, 20))
def test_states_where_ell_vanishes_are_degenerate_in_any_unit_of_time(b, m, origins, time, unit):
    fields = 2.0 ** (2 * unit)
    known = Parameters.of(fields, b * fields, m / fields, 0)
    assume(not {*coincidences(known)} - {"ℓ = 0"})
    for follow in (closed, balls):
        (state,) = follow(Motion(known, origins), np.array([time * 2.0**-unit]))
        assert kind_at(state.tolist()) == "degenerate"
