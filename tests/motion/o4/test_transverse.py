"""Which tori of O⁴ are hyperbolic: the law, at points of the tori, and by motions beside them."""

from contextlib import suppress
from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, MotionO4, ParametersO4, load
from kowalevski_cas.motion.critical import residuals
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.methods.integrators import integrate
from kowalevski_cas.motion.o4.ball import state_by_angles
from kowalevski_cas.motion.o4.transverse import kind, kind_at
from kowalevski_cas.motion.parameters import ball, precision
from tests.motion.o4.levels import EVERY_REGIME, KNOWN, motion
from tests.motion.o4.test_edges import edges

closed = load("closed")


def integral(state, s):
    """2QQ″ − Q′² at s, with the integrals of a state: it vanishes to the second order on O⁴."""
    h, k, a_square, b_square, c, g, *_ = values_of_offer("integrals")(*state)
    p_square, product = a_square + b_square, a_square * b_square - c * c
    quadratic = h * h + p_square - k
    Q = s**4 - 2 * h * s**3 + quadratic * s**2 - 2 * g * s + product
    first = 4 * s**3 - 6 * h * s**2 + 2 * quadratic * s - 2 * g
    return 2 * Q * (12 * s**2 - 12 * h * s + 2 * quadratic) - first**2


@given(edges(), st.tuples(*[st.fractions(-3, 3, max_denominator=20)] * 2), st.integers(0, 99))
def test_a_torus_is_hyperbolic_where_the_integral_has_both_signs_beside_it(known, angles, seed):
    try:
        moving = MotionO4.of(*known, angles=angles)
    except Inadmissible:
        assume(False)
        raise
    directions = np.random.default_rng(seed).integers(-9, 10, (2, 9)).tolist()
    with precision(1200):
        state, s = state_by_angles(moving), ball(moving.parameters.s)
        step = arb(2) ** -300

        def form(one, two):
            there = [
                x + step * (one * y + two * z) for x, y, z in zip(state, *directions, strict=True)
            ]
            return integral(there, s) / step**2

        first, second = form(1, 0), form(0, 1)
        mixed = (form(1, 1) - first - second) / 2
        determinant = first * second - mixed * mixed
    assume(abs(float(determinant)) > 1e-60)
    assert kind(moving.parameters) == ("hyperbolic" if determinant < 0 else "elliptic")


@given(edges(), st.tuples(*[st.fractions(-3, 3, max_denominator=20)] * 2), st.sampled_from("sτ"))
def test_where_the_determinant_vanishes_the_type_is_degenerate_to_the_last_digit(known, angles, by):
    a, b, s, _ = known
    tau = -(s**2 - a**2) * (s**2 - b**2) / s**2  # where Q″(s) = 0
    assume(tau)
    assert kind(ParametersO4(a, b, s, tau)) == "degenerate"
    beside = [Fraction(float(tau)), Fraction(f"{float(tau):.17g}")]
    beside += [Fraction(float(np.nextafter(float(tau), way))) for way in (np.inf, -np.inf)]
    if by == "s":
        s = Fraction(float(np.nextafter(float(s), np.inf)))
    assert {kind(ParametersO4(a, b, s, one)) for one in beside} == {"degenerate"}
    assert kind(ParametersO4(a, b, s, tau * Fraction("1.0001"))) != "degenerate"
    with suppress(Inadmissible):
        (state,) = closed(MotionO4.of(a, b, s, tau, angles=angles), np.zeros(1))
        assert kind_at(state.tolist()) == "degenerate"


@settings(deadline=None, max_examples=30)
@given(st.sampled_from(KNOWN))
@pytest.mark.slow
def test_motions_beside_hyperbolic_tori_leave_them_and_others_do_not(known):
    moving = motion(known)
    start = closed(moving, np.zeros(1))[0]
    rate = np.max(np.abs(start[:3])) + 1
    times = np.linspace(0, 400 / rate, 800)
    beside = start + 1e-9 * np.linalg.norm(start) * np.linspace(-1, 1, 9)
    far = residuals(integrate("DOP853", beside, times, 1e-13))["O4"]
    leaves = np.max(far[400:]) > 30 * np.max(far[:40])
    assert leaves == (kind(moving.parameters) == "hyperbolic")


def test_both_types_occur():
    found = {kind(motion(known).parameters) for known in KNOWN}
    assert found == {"elliptic", "hyperbolic"} and len(EVERY_REGIME) == len(KNOWN)
