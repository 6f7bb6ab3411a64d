"""The motion through a point: there at t = 0, and with the same constants."""

import re
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from kowalevski_cas.motion import Inadmissible, MethodError, Motion, load, through
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.frame import rotate
from kowalevski_cas.motion.methods.closed import Closed
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.point import on_N4
from kowalevski_cas.motion.units import unit_of
from tests.motion.exact import apart
from tests.motion.regions import motion
from tests.motion.test_closed import ALL, ORIGINS, motions, relative
from tests.motion.test_frequencies import near_edges
from tests.sample import sampled

closed, balls, dop853 = load("closed"), load("ball"), load("dop853")
START, LATER = np.zeros(1), np.array([-1.0, 0.5, 2.0])


@pytest.mark.parametrize("region", sampled([(region,) for region in ALL], 4))
@pytest.mark.parametrize("signs", [(1, -1), (-1, 1)])
def test_it_is_there_and_stays_with_the_motion(region, signs):
    first = motion(*region, origins=ORIGINS, signs=signs)
    state = closed(first, START)
    second = on_N4(state[0].tolist())
    assert relative(closed(second, START), state) < 1e-14
    assert relative(closed(second, LATER), closed(first, LATER)) < 1e-11


@pytest.mark.parametrize("region", sampled([(region,) for region in ALL], 4))
@pytest.mark.parametrize("signs", [(1, -1), (-1, 1)])
def test_it_is_run_through_backwards_where_the_body_turns_the_other_way(region, signs):
    first = motion(*region, origins=ORIGINS, signs=signs)
    back = np.repeat([-1, 1], (3, 6))
    second = on_N4((closed(first, START)[0] * back).tolist())
    assert relative(closed(second, -LATER) * back, closed(first, LATER)) < 1e-11


@pytest.mark.parametrize("region", sampled([(region,) for region in ALL], 4))
def test_a_turning_point_costs_no_accuracy(region):
    # There s has half the digits only of the phase; S or f has them all.
    for origins in (0, 0), (0, 1e-9), (1e-9, 0):
        started = motion(*region, origins=tuple(map(Fraction, origins)))
        if started.oscillations()[0].kind != "exponential":  # s1 is infinite there
            state = closed(started, START)
            assert relative(closed(on_N4(state[0].tolist()), START), state) < 1e-14


@given(motions(), st.floats(-3, 3))
def test_the_fields_may_have_any_angle(motion, angle):
    # A turn of the fields with the body leaves the equations alone.
    straight = closed(motion, LATER)
    if min(np.hypot(straight[:, 3] - straight[:, 7], straight[:, 4] + straight[:, 6])) < 1e-3:
        return  # close to x1x2 = 0 the state hardly tells the constants
    oblique = np.array(rotate(list(straight.T), np.cos(angle), np.sin(angle))).T
    moved = on_N4(oblique[0].tolist())
    assert relative(closed(moved, START), oblique[:1]) < 1e-12
    values = np.array(values_of_offer("integrals")(*closed(moved, LATER).T))
    assert np.ptp(values[2:5], axis=1).max() < 1e-13 * (1 + np.max(np.abs(oblique)) ** 2)


def scaled(state, unit):
    """The same motion in another unit of time: ω has weight 1, the fields have weight 2."""
    return np.asarray(state) * np.repeat([unit, unit**2], (3, 6))


units = st.floats(-140, 140).map(lambda power: 10**power)


@given(st.lists(st.floats(-1, 1), min_size=9, max_size=9), units, st.floats(0, 12))
def test_a_state_off_the_manifold_is_refused_in_every_unit(state, unit, weaker):
    # However small the state, and the fields beside ω².
    state = scaled(state, 1) * np.repeat([1, 10**-weaker], (3, 6))
    xi_1, xi_2 = state[3] - state[7], state[4] + state[6]
    should = 2 * (
        xi_1 * state[:2] @ state[[5, 8]] + xi_2 * (state[0] * state[8] - state[1] * state[5])
    )
    size = (xi_1**2 + xi_2**2) * np.max(np.abs(state[:3]))
    assume(abs((xi_1**2 + xi_2**2) * state[2] - should) > 1e-3 * size > 0)
    fields = np.max(np.abs(state[3:]))  # what is tiny beside the rest may come from rounding
    assume(np.max(np.abs(state[:3])) ** 2 > 1e-6 * fields < np.hypot(xi_1, xi_2) * 1e-3)
    with pytest.raises(Inadmissible):
        on_N4(scaled(state, unit).tolist())


@pytest.mark.slow
@given(motions(), units)
def test_a_state_on_the_manifold_is_returned_to_in_every_unit(motion, unit):
    state = closed(motion, LATER)[1]
    assume(np.hypot(state[3] - state[7], state[4] + state[6]) > 1e-3)
    found = on_N4(scaled(state, unit).tolist())
    assert relative(scaled(closed(found, START)[0], 1 / unit)[None], state[None]) < 1e-12
    assert found.off < 1e-11
    for method in closed, balls:
        later = scaled(method(found, np.array([0.5 / unit]))[0], 1 / unit)
        assert relative(later[None], closed(motion, LATER[1:2] + 0.5)) < 1e-6


@pytest.mark.slow
@given(st.sampled_from(ALL[:15]), units, st.floats(-13, -10), st.integers(0, 8))
def test_how_far_the_closed_form_is_from_a_state_is_said(region, unit, power, place):
    state = closed(motion(*region, origins=ORIGINS), START)[0]
    state[place] += 10**power
    found = on_N4(scaled(state, unit).tolist())
    fields = np.max(np.abs(state[3:]))
    sizes = np.repeat([np.sqrt(np.max(state[:3] ** 2) + fields), fields], (3, 6))
    moved = (scaled(closed(found, START)[0], 1 / unit) - state) / sizes
    assert found.off == pytest.approx(np.max(np.abs(moved)), rel=1e-2, abs=1e-15)


def test_integrators_start_from_the_state_itself():
    state = closed(motion("0.8", "0.9", origins=ORIGINS), START)[0] + 1e-10
    assert dop853(on_N4(state.tolist()), START)[0].tolist() == state.tolist()


@pytest.mark.parametrize(
    "state, words",
    [
        ([0, 0, 0, 1, 0, 0, 0, 1, 0], "nothing separates"),
        ([0.3, 0, 0.4, 1, 0, 0, 0, 0, 0.4], "not on N⁴: the left side of (16), equation 1, is 0."),
        ([0, 0, 0, 1, 0, 0, 0, 1, 0.5], "m = 0: the roots (ℓ±1)/2m are at infinity"),
        ([1, 0, 0, 1, 0, 0.5, 0, 1, 0], "is not on N⁴, or so close to x1x2 = 0"),
        ([1, 2, 3], "nine numbers, ω, α, β; 3 are given"),
        (["x"] * 9, "“x” is not a finite number"),
        ([float("nan")] * 9, "“nan” is not a finite number"),
    ],
)
def test_states_without_a_motion_are_refused_in_words(state, words):
    with pytest.raises(ValueError, match=re.escape(words)):
        on_N4(state)
    assert issubclass(Inadmissible, ValueError)


@pytest.mark.slow
@given(
    st.floats(-2, -0.05),
    st.sampled_from([0.0, *(10.0**-power for power in (2, 4, 8, 12))]),
    st.sampled_from([0.0, *(10.0**-power for power in range(3, 10))]),
    st.sampled_from([-1, 1]),
)
def test_a_state_near_infinity_and_near_ell_zero_keeps_its_digits(m, ell, aside, side):
    # There x1x2 and ℓ vanish, by which the printed formulas divide; the state is as regular as
    # elsewhere.
    first = Motion.of(1, "0.4", m, ell=ell)
    oscillation = first.oscillations()[0]
    assume(oscillation.kind == "elliptic" and oscillation.complement_square > 1e-3)
    assume(first.oscillations()[1].complement_square > 1e-3)
    times = np.linspace(0, float(2 * oscillation.quarter / oscillation.rate), 50)

    def weight(t):
        at = np.array([t])
        return float(Closed(first, 100.0).variables(at, at)[0].weight[0])

    low, high = next(pair for pair in pairwise(times) if weight(pair[0]) * weight(pair[1]) <= 0)
    now = brentq(weight, low, high, xtol=1e-16) + side * aside
    state = closed(first, np.array([now]))
    second = on_N4(state[0].tolist())
    assert second.off < 1e-14
    assert relative(closed(second, LATER), closed(first, LATER + now)) < 1e-12


def check_return(moving, time, power, k):
    """Of a state on N⁴ or O⁴ or so little off: what begins elsewhere than it says is not given."""
    try:
        unit = unit_of(initial_state(moving))
        state = closed(moving, np.ldexp([time], -unit))
        if power is not None:
            state[0, k] += np.ldexp(10.0**power, unit * (1 if k < 3 else 2))
        found = through(state[0].tolist())
        begun = closed(found, START)
    except (Inadmissible, MethodError):
        return
    assert apart(begun, state) < 2e-13 + 1.5 * found.off


@settings(max_examples=10, deadline=None)
@given(near_edges, st.floats(-1, 4), st.none() | st.floats(-12.9, -8), st.integers(0, 8))
def test_towards_every_edge_a_closed_form_says_how_far_it_is_from_the_state(moving, time, power, k):
    check_return(moving, time, power, k)


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(near_edges, st.floats(-1, 4), st.none() | st.floats(-12.9, -8), st.integers(0, 8))
def test_towards_every_edge_many_closed_forms_say_how_far_they_are_from_the_state(
    moving, time, power, k
):
    check_return(moving, time, power, k)
