"""Where methods fail: near the separating curves, equal fields, one field, large times."""

from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, Motion, Parameters, load
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.jacobi import jacobi
from kowalevski_cas.motion.parameters import ball, precision
from kowalevski_cas.motion.phases import Phase, as_fraction, parts_needed
from tests.motion.exact import apart
from tests.motion.regions import SEPARATING, motion
from tests.motion.test_closed import motions, relative

closed, balls = load("closed"), load("ball")
T = np.array([0.3, -4.0, 33.0, 1e4, 1e6])

ASYMPTOTIC = ["s1 is asymptotic", "s2 is asymptotic", "s1 through infinity is asymptotic"]


@pytest.mark.parametrize("words", SEPARATING)
def test_close_to_a_separating_curve(words):
    m, ell = map(Fraction, SEPARATING[words])
    for side, digits in product((1, -1), (3, 8, 15, 30, 300)):
        try:
            near = Motion(Parameters.of(1, "0.4", m, ell + Fraction(side, 10**digits)))
        except ValueError:
            assert "rest" in words  # beyond the boundary there is no motion
        else:
            assert relative(closed(near, T), balls(near, T)) < 1e-13


@st.composite
def edges(draw):
    """A motion as near as 10⁻⁴⁰ to any separating curve, or far off, in fields towards a = b, b = 0."""
    near = Fraction(10.0 ** draw(st.floats(-12, -0.3)))
    b = draw(st.sampled_from([near, 1 - near, Fraction(2, 5)]))
    sign, side, way = (draw(st.sampled_from([-1, 1])) for _ in "123")
    m = sign * Fraction(10.0 ** draw(st.floats(-6, 4)))
    ell = draw(st.sampled_from([2 * m * end + side for end in (1, -1, b, -b)] + [Fraction(0)]))
    ell += way * Fraction(10.0 ** draw(st.floats(-40, 0)))
    origins = draw(st.tuples(*[st.fractions(-6, 6, max_denominator=50)] * 2))
    try:
        return Motion(Parameters.of(1, b, m, ell), origins)
    except Inadmissible:
        assume(False)
        raise


@given(edges(), st.floats(0, 12))
def test_towards_all_edges_at_once_it_agrees_with_balls_at_any_time(motion, late):
    """To 1e-13 of the state's size, and of that of the fields, which are small where m is."""
    times = np.array([0.0, 1.3, -(10.0**late)])
    assert apart(closed(motion, times), balls(motion, times)) < 1e-13


@pytest.mark.parametrize("words", ASYMPTOTIC)
def test_on_a_separating_curve_the_functions_are_the_limits_of_the_elliptic_ones(words):
    m, ell = map(Fraction, SEPARATING[words])
    t = np.array([0.1, 1.0, -2.0])
    limit = Motion(Parameters.of(1, "0.4", m, ell))
    there = closed(limit, t)
    errors = []
    for digits in 4, 6:
        near = Motion(Parameters.of(1, "0.4", m, ell + Fraction(1, 10**digits)))
        # The limit starts from the simple root; a motion nearby may start from the other one.
        origins = [
            Fraction(0) if same.roots[0] in old.roots[0] else as_fraction(-same.quarter / same.rate)
            for old, same in zip(limit.oscillations(), near.oscillations(), strict=True)
        ]
        errors.append(
            min(
                relative(closed(Motion(near.parameters, tuple(origins), (x, y)), t), there)
                for x in (1, -1)
                for y in (1, -1)
            )
        )
    assert errors[0] < 1e-2 and errors[1] < errors[0] / 50


@pytest.mark.parametrize("words", ASYMPTOTIC)
def test_the_asymptotic_motion_comes_to_rest_in_one_variable(words):
    # In the far future and past the variable is at the double root: S and f vanish there.
    early, late = closed(motion(*SEPARATING[words]), np.array([-80.0, 80.0]))
    component = 8 if words.startswith("s2") else 5
    assert abs(early[component]) < 1e-12 and abs(late[component]) < 1e-12


@given(st.integers(1, 14), st.sampled_from(["0.8", "0.2", "-0.8"]))
def test_fields_of_nearly_equal_size_cost_no_accuracy(digits, m):
    b = 1 - Fraction(1, 10**digits)
    least = max(2 * Fraction(m) - 1, 1 - 2 * b * Fraction(m)) if Fraction(m) > 0 else Fraction(0)
    near = Motion(Parameters.of(1, b, m, least + Fraction(1, 100)))
    assert relative(closed(near, T), balls(near, T)) < 1e-13


@given(st.fractions(Fraction(1, 10), 2), st.fractions(Fraction(1, 10), 2))
def test_one_field_is_the_classical_top(m, beyond):
    # b = 0: the second field vanishes for good, and the fourth integral of Appelrot's classes
    # holds; the same motion is the limit of b → 0.
    ell = max(2 * m - 1, Fraction(1)) + beyond
    states = closed(Motion(Parameters.of(1, 0, m, ell)), T)
    assert np.max(np.abs(states[:, 6:])) == 0
    near = closed(Motion(Parameters.of(1, Fraction(1, 10**12), m, ell)), T[:3])
    assert relative(near[:, :6], states[:3, :6]) < 1e-6
    # With one field the area integral joins the others: it is constant.
    omega, alpha = states[:, :3], states[:, 3:6]
    area = np.sum(np.array([2, 2, 1]) * omega * alpha, axis=1)
    assert np.ptp(area) < 1e-13 * (1 + np.max(np.abs(states)) ** 2)


@given(st.integers(-400, 400), st.sampled_from([0, Fraction(2, 5)]), st.booleans(), st.booleans())
@example(-200, Fraction(2, 5), False, False)
def test_fields_of_any_size_are_followed_or_refused(power, ratio, positive, in_units):
    a = Fraction(10) ** power
    m = Fraction(4, 5) if positive else Fraction(-3, 5)
    if in_units:
        m /= a
    ell = 2 * a * m + 1 if positive else Fraction(1, 2)
    if not -307 < power < 308:
        with pytest.raises(ValueError, match="take other units"):
            Motion.of(a, a * ratio, m, ell=ell)
    elif abs(power) > 50 and not in_units:
        with pytest.raises(Inadmissible, match=r"almost 0|is too large"):
            Motion.of(a, a * ratio, m, ell=ell)
    else:
        found = Motion.of(a, a * ratio, m, ell=ell)
        t = np.array([0.0, 1.0]) / float(a) ** 0.5
        assert apart(closed(found, t), balls(found, t)) < 1e-12


def test_through_infinity_the_state_is_as_regular_as_elsewhere():
    # s1 passes through ∞ with x1x2 = 0; there the derivative still is that of the equations.
    h = 1e-3
    a, b, c, d, e = closed(motion("-0.5", "0"), h * np.array([-2.0, -1, 0, 1, 2]))
    slope = (a - 8 * b + 8 * d - e) / (12 * h)
    assert abs(c[3] - c[7]) + abs(c[4] + c[6]) < 1e-15
    assert np.max(np.abs(slope - np.array(values_of_offer("equations")(*c)))) < 1e-9


@given(motions(), st.floats(-1e280, 1e280))
def test_the_phase_is_right_to_the_last_bit_at_any_time(motion, t):
    with precision(1300):
        for oscillation in motion.oscillations():
            if oscillation.kind != "elliptic":
                continue
            rate = oscillation.rate / oscillation.quarter
            phase = Phase(rate, ball(Fraction(1, 3)), parts_needed(float(rate), abs(t)))
            quarter, rest = phase(np.array([t]))
            exact = as_fraction(rate) * Fraction(t) + Fraction(1, 3)
            error = exact - Fraction(float(quarter[0])) - Fraction(float(rest[0]))
            assert abs(error - 4 * round(error / 4)) < 1e-15
            assert abs(rest[0]) <= 0.5 + 1e-15


def test_times_that_are_not_finite_are_refused():
    with pytest.raises(ValueError, match="times have to be finite"):
        closed(motion("0.8", "0.9"), np.array([np.inf]))


@pytest.mark.slow
@given(motions())
def test_the_quadruple_satisfies_the_identities_of_jacobi(motion):
    t = np.linspace(-5, 5, 40)
    with precision(128):
        for oscillation in motion.oscillations():
            t1, t2, t3, t4 = jacobi(oscillation, ball(Fraction(0)), 5.0)(t)
            k = float(oscillation.modulus_square)
            if oscillation.kind == "elliptic":
                assert np.max(np.abs((t1 / t4) ** 2 + (t2 / t4) ** 2 - 1)) < 1e-14
                assert np.max(np.abs(k * (t1 / t4) ** 2 + (t3 / t4) ** 2 - 1)) < 1e-14
