"""The motion through a point: there at t = 0, and with the same constants."""

import re
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, load, through
from kowalevski_cas.motion.formulas import integrals
from kowalevski_cas.motion.frame import turned
from tests.motion.regions import motion
from tests.motion.test_closed import ALL, ORIGINS, motions, relative

closed, dop853 = load("closed"), load("dop853")
START, LATER = np.zeros(1), np.array([-1.0, 0.5, 2.0])


@pytest.mark.parametrize("region", ALL)
@pytest.mark.parametrize("signs", [(1, -1), (-1, 1)])
def test_it_is_there_and_stays_with_the_motion(region, signs):
    first = motion(*region, origins=ORIGINS, signs=signs)
    state = closed(first, START)
    second = through(state[0].tolist())
    assert relative(closed(second, START), state) < 1e-14
    assert relative(closed(second, LATER), closed(first, LATER)) < 1e-11


@pytest.mark.parametrize("region", ALL)
def test_a_turning_point_costs_no_accuracy(region):
    # There s has half the digits only of the phase; S or f has them all.
    for origins in (0, 0), (0, 1e-9), (1e-9, 0):
        started = motion(*region, origins=tuple(map(Fraction, origins)))
        if started.oscillations()[0].kind != "exponential":  # s1 is infinite there
            state = closed(started, START)
            assert relative(closed(through(state[0].tolist()), START), state) < 1e-14


@given(motions(), st.floats(-3, 3))
def test_the_fields_may_have_any_angle(motion, angle):
    # A turn of the fields with the body leaves the equations alone.
    straight = closed(motion, LATER)
    if min(np.hypot(straight[:, 3] - straight[:, 7], straight[:, 4] + straight[:, 6])) < 1e-3:
        return  # close to x1x2 = 0 the state hardly tells the constants
    oblique = np.array(turned(list(straight.T), np.cos(angle), np.sin(angle))).T
    moved = through(oblique[0].tolist())
    assert relative(closed(moved, START), oblique[:1]) < 1e-12
    values = np.array(integrals()(*closed(moved, LATER).T))
    assert np.ptp(values[2:5], axis=1).max() < 1e-13 * (1 + np.max(np.abs(oblique)) ** 2)


def test_integrators_start_from_the_state_itself():
    state = closed(motion("0.8", "0.9", origins=ORIGINS), START)[0] + 1e-10
    assert dop853(through(state.tolist()), START)[0].tolist() == state.tolist()


@pytest.mark.parametrize(
    "state, words",
    [
        ([0, 0, 0, 1, 0, 0, 0, 1, 0], "nothing separates"),
        ([0.3, 0, 0.4, 1, 0, 0, 0, 0, 0.4], "not on N⁴: the left side of (16), equation 1, is 0.4"),
        ([0, 0, 0, 1, 0, 0, 0, 1, 0.5], "x1x2 = 0 at the state"),
        ([1, 2, 3], "nine numbers, ω, α, β; 3 are given"),
        (["x"] * 9, "“x” is no finite number"),
        ([float("nan")] * 9, "“nan” is no finite number"),
    ],
)
def test_states_without_a_motion_are_refused_in_words(state, words):
    with pytest.raises(ValueError, match=re.escape(words)):
        through(state)
    assert issubclass(Inadmissible, ValueError)
