"""How far states are from M⁴, N⁴, O⁴: homogeneous residuals."""

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from kowalevski_cas.motion import load
from kowalevski_cas.motion.critical import SETS, on, residuals
from tests.motion.test_closed import motions

small = st.floats(-3, 3).map(lambda x: round(x, 3))
states = arrays(float, 9, elements=small)
units = st.floats(-30, 30).map(lambda power: 10**power)
WEIGHTS = np.repeat([1, 2], (3, 6))


def at(state):
    return {name: float(values[0]) for name, values in residuals(np.array([state])).items()}


def state_of(x1, y1, z1, w1, omega3):
    """The state with these complex variables, the others being their conjugates."""
    alpha = ((x1 + y1).real / 2, (x1 + y1).imag / 2, z1.real)
    beta = ((x1 - y1).imag / 2, (y1 - x1).real / 2, z1.imag)
    return np.array([w1.real, w1.imag, omega3, *alpha, *beta])


numbers = st.builds(complex, small, small)


@given(numbers, numbers, numbers, small)
def test_on_M4(w1, y1, z1, omega3):
    state = state_of(-(w1**2), y1, z1, w1, omega3)
    assert at(state)["M4"] < 1e-12


@given(numbers, numbers, small, small, small)
def test_on_O4(w1, z1, omega3, eta, s):
    assume(abs(w1) > 0.1 < abs(z1))
    w2, z2 = w1.conjugate(), z1.conjugate()
    both, product = omega3 * z1 * z2 / 2, omega3 * s * w1 * w2
    x1 = (1j * eta - both + product) / (w2 * z2)
    y1 = (1j * eta - both - product) / (w2 * z1) - 2 * s
    assert at(state_of(x1, y1, z1, w1, omega3))["O4"] < 1e-10


@given(st.floats(0.1, 3), st.floats(0.1, 3), st.floats(0, 6), st.floats(-3, 3), st.booleans())
def test_rotations_about_the_third_axis_are_on_O4_where_they_have_to_be(a, b, angle, spin, left):
    # The fields are orthogonal, in the plane of the first two axes; the double roots s are real
    # where h² ≥ y1y2 − x1x2 = ±4ab.
    sign = 1 if left else -1
    turn, across = (
        np.array([np.cos(angle), np.sin(angle)]),
        np.array([-np.sin(angle), np.cos(angle)]),
    )
    state = np.array([0, 0, spin, *a * turn, 0, *sign * b * across, 0])
    h = spin**2 / 2 - state[3] - state[7]
    gap = h**2 - sign * 4 * a * b
    assume(abs(gap) > 1e-3)
    assert ("O4" in on(at(state))) == (gap > 0)


@pytest.mark.slow
@given(motions(), st.lists(st.floats(-100, 100), min_size=1, max_size=5))
def test_on_N4(motion, times):
    there = load("closed")(motion, np.array(times))
    assert np.nanmax([0.0, *residuals(there)["N4"]]) < 1e-8


@given(states, units)
def test_the_unit_of_time_does_not_matter(state, unit):
    here, scaled = at(state), at(state * unit**WEIGHTS)
    for name in SETS:
        assert scaled[name] == pytest.approx(here[name], rel=1e-6, abs=1e-12, nan_ok=True)


@given(
    arrays(float, 9, elements=st.sampled_from([-1.0, 0, 1])),
    arrays(float, 9, elements=st.floats(-150, 100)),
)
@example(
    np.array([0, -1, 0, 1, 1, 0, 0, -1, 1.0]), np.array([0, 80, 0, -61, -125, 0, 0, 114, -160.0])
)
def test_no_size_of_any_number_makes_a_residual_overflow(signs, powers):
    with np.errstate(all="raise", under="ignore"):
        found = residuals((signs * 10**powers)[None])
    assert np.isfinite([*found["M4"], *found["O4"]]).all() and not np.isinf(found["N4"]).any()


@given(states, st.integers(0, 8), st.floats(-6, -1))
def test_a_state_near_a_set_has_a_small_residual(state, place, power):
    # M⁴ through the state: x1 = −w1² by α1, α2.
    omega, beta = state[:3], state[6:]
    assume(np.max(np.abs(state)) > 0.5)
    state[3] = beta[1] - omega[0] ** 2 + omega[1] ** 2
    state[4] = -beta[0] - 2 * omega[0] * omega[1]
    state[place] += 10**power
    assert at(state)["M4"] < 100 * 10**power


def test_states_in_general_are_on_none():
    random = np.random.default_rng(5).normal(size=(200, 9))
    for values in residuals(random).values():
        assert np.min(values) > 1e-4


def test_without_fields_and_at_rest_the_residuals_are_finite_or_not_defined():
    state = np.zeros(9)
    assert on(at(state)) == ["M4", "O4"]
    state[0] = 1.0
    assert "M4" not in on(at(state))
