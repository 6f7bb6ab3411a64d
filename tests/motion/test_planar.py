"""Motions of a pendulum that lie on N⁴: one axis of the body and one field stay where they are.

Two of the roots coincide there exactly: one variable rests, on a stable or an unstable place.
"""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, load
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.frame import rotate
from kowalevski_cas.motion.point import on_N4
from tests.motion.test_closed import relative

closed, ball, dop853 = load("closed"), load("ball"), load("dop853")
T = np.array([0.0, 0.7, -3.0, 200.0, 1e5])

lengths = st.fractions(Fraction(1, 10), 3, max_denominator=20)
speeds = st.fractions(-3, 3, max_denominator=20)
slopes = st.fractions(-3, 3, max_denominator=5)
axes, signs = st.sampled_from([0, 1]), st.sampled_from([1, -1])


def circle(slope):
    """A rational point of the unit circle."""
    return (1 - slope**2) / (1 + slope**2), 2 * slope / (1 + slope**2)


def pendulum(axis, still, moving, speed):
    """The state with one field along an axis of the body, and the other across it."""
    state = [Fraction(0)] * 9
    state[axis] = speed
    state[3 + 4 * axis] = still  # α1 or β2
    other = 6 - 3 * axis
    state[other + 1 - axis], state[other + 2] = moving
    return state


@st.composite
def pendulums(draw):
    """A pendulum about either axis, of rational lengths or not, the fields at any angle."""
    x, y = draw(lengths) * draw(signs), draw(st.sampled_from([Fraction(0), draw(lengths)]))
    state = pendulum(draw(axes), draw(lengths) * draw(signs), (x, y), draw(speeds))
    assume(sum(x**2 for x in state[3:6]) != sum(x**2 for x in state[6:]))
    assume(state[3] != state[7])
    return rotate(state, *circle(draw(slopes)))


def at(state):
    return np.array([list(map(float, state))])


@given(pendulums())
def test_a_pendulum_is_followed_and_stays_one(state):
    motion = on_N4(state)
    assert "rest" in [oscillation.kind for oscillation in motion.oscillations()]
    there = closed(motion, T)
    assert relative(there[:1], at(state)) < 1e-14
    assert relative(there, ball(motion, T)) < 1e-13
    assert relative(there[1:3], dop853(motion, T[1:3])) < 1e-8
    assert (
        np.ptp(np.array(values_of_offer("integrals")(*there.T)), axis=1).max()
        < 1e-11 * np.max(abs(there)) ** 6
    )
    # The axis and the field along it stand still, also after a long time on an unstable place.
    cos, sin = (float(x) for x in motion.turn)
    straight = np.array(rotate(list(there.T), cos, sin))
    size = np.max(np.abs(there))
    assert np.max(np.abs(straight[2])) < 1e-14 * size
    across = np.min([np.ptp(straight[k : k + 3], axis=1).max() for k in (3, 6)])
    assert across < 1e-14 * size


@given(lengths, lengths, signs, signs, slopes)
@example(Fraction(1), Fraction(2, 5), -1, 1, Fraction(0))
def test_an_equilibrium_stays_where_it_is(a, b, first, second, slope):
    assume(a != b)
    state = rotate(pendulum(0, first * a, (second * b, Fraction(0)), Fraction(0)), *circle(slope))
    for method in closed, ball:
        assert np.all(np.abs(method(on_N4(state), T) - at(state)) < 1e-15 * float(a + b))


@given(slopes, slopes, slopes)
def test_an_equilibrium_whose_lengths_are_irrational_stays_where_it_is(x, y, z):
    # ω = 0 and e1×α + e2×β = 0: the fields are a symmetric matrix.
    assume(y and x * z != y * y and (x + z) and (x - z, y) != (0, 0))
    state = [*[Fraction(0)] * 3, x, y, Fraction(0), y, z, Fraction(0)]
    assert np.all(np.abs(closed(on_N4(state), T) - at(state)) < 1e-14 * float(abs(x) + abs(z)))


@given(axes, lengths, signs, lengths, slopes, signs, slopes)
def test_a_pendulum_that_comes_to_rest_upside_down_is_elementary(
    axis, still, side, speed, slope, way, turn
):
    # By the energy ω² = length + (its part along the axis) there, with a rational root.
    length = speed**2 * (1 + slope**2) / 2
    assume(still != length)
    along, across = (length * x for x in circle(slope))
    state = rotate(pendulum(axis, side * still, (along, across), way * speed), *circle(turn))
    motion = on_N4(state)
    assert (
        {"rest"} < {o.kind for o in motion.oscillations()} <= {"rest", "separatrix", "exponential"}
    )
    end = rotate(pendulum(axis, side * still, (-length, Fraction(0)), Fraction(0)), *circle(turn))
    t = np.array([0, 1000]) / float(length) ** 0.5
    for method in closed, ball:
        assert np.max(np.abs(method(motion, t) - [*at(state), *at(end)])) < 1e-13 * (
            3 + float(length + still)
        )


@given(lengths, lengths, speeds.filter(bool), signs)
def test_turning_about_the_third_axis_is_not_on_the_manifold(a, b, speed, sign):
    assume(a != b)
    state = [Fraction(0), Fraction(0), speed, a, *[Fraction(0)] * 3, sign * b, Fraction(0)]
    with pytest.raises(Inadmissible, match="not on N⁴"):
        on_N4(state)
