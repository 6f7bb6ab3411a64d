"""The motion through a point of O⁴: there at t = 0, and with the same constants."""

import re

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from kowalevski_cas.motion import General, Inadmissible, MotionO4, load, through
from kowalevski_cas.motion.frame import rotate
from kowalevski_cas.motion.o4.start import on_O4
from kowalevski_cas.motion.result import Trajectory
from tests.motion.o4.levels import KNOWN, motion, point, points
from tests.motion.o4.test_closed import angles, on_a_torus, relative, signs

closed, balls = load("closed"), load("ball")
T = np.linspace(-4.0, 4.0, 5)


@pytest.mark.slow
@given(st.sampled_from(KNOWN), angles, angles, signs)
@example(KNOWN[0], 0, 0, (1, 1, 1, 1, 1))  # |u1 + τ| = r² = |u2 + τ|
def test_a_state_of_a_motion_leads_to_that_motion(known, first, second, chosen):
    states = closed(on_a_torus(known, first, second, chosen), T)
    found = through(states[2].tolist())
    assert isinstance(found, MotionO4)
    assert relative(closed(found, T), states) < 1e-10


@pytest.mark.slow
@given(st.sampled_from(KNOWN), st.floats(-3, 3), st.floats(-140, 140))
def test_in_turned_fields_and_another_unit_of_time_it_is_the_same_motion(known, angle, power):
    states = closed(motion(known), T)
    unit = 10.0**power
    scales = np.repeat([unit, unit**2], [3, 6])
    turned = np.array(rotate(states.T, np.cos(angle), np.sin(angle))).T
    found = on_O4((turned * scales)[2].tolist())
    assert found.off < 1e-13
    assert relative(closed(found, T / unit) / scales, turned) < 1e-10
    assert relative(balls(found, T / unit) / scales, turned) < 1e-10


@given(st.integers(-3, 3).filter(bool), st.integers(-3, 3).filter(bool))
@example(3, 1)  # τ3 = 0, but for the rounding of an angle
def test_where_u2_is_infinite_the_motion_is_found_as_elsewhere(half_s, eta):
    state = point((1, 0, 1, 1, 0, eta, half_s / 2))  # x1x2 = τ3
    try:
        found = on_O4(state.tolist())
    except Inadmissible as error:
        assume("degenerate" not in str(error))
        raise
    assert found.off < 1e-14


@given(points, st.integers(0, 8), st.floats(1e-3, 1))
def test_a_state_off_O4_is_not_followed_on_it(state, place, by):
    state[place] += by * np.max(np.abs(state))
    try:
        found = on_O4(state.tolist())
    except Inadmissible:
        assert not isinstance(through(state.tolist()), MotionO4)
    else:  # the change may lead along O⁴
        assert found.off <= 1e-8


def test_what_is_on_neither_set_says_so_of_both():
    motion = through([0.1, 0.2, 0.3, 1, 0, 0, 0, 0.4, 0])
    assert isinstance(motion, General)
    assert re.match("the state is not on N⁴.*; the state is not on O⁴", motion.why)


@pytest.mark.parametrize("known", KNOWN, ids=str)
def test_what_is_told_of_a_motion(known):
    moving = motion(known)
    result = Trajectory(moving, T, closed(moving, T))
    assert result.critical_sets["on"] == ["O4"]
    assert result.invariants["s"] == float(known[2])
    assert result.invariants["tau"] == float(known[3])
    assert result.regime["tori"] == moving.regime.tori


@pytest.mark.parametrize(
    "constants",
    [
        (1, 1, 1, 1),
        (1, 2, 1, 1),
        (1, 0, 1, 1),
        (2, 1, 0, 1),
        (2, 1, 1, 0),
        (2, 1, 1, 1),
        (2, 1, 1, 9),
    ],
)
def test_constants_at_which_the_tori_degenerate_are_refused(constants):
    with pytest.raises(Inadmissible, match=r"needed|degenerate"):
        motion(constants)


def test_signs_for_which_E_is_not_real_are_refused():
    with pytest.raises(Inadmissible, match="opposite signs"):
        motion(KNOWN[0], signs=(1, 1, 1, 1, 1))
