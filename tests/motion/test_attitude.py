"""The body in space: a unit quaternion that moves with the angular velocity."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from kowalevski_cas.cli import main
from kowalevski_cas.motion import METHODS, Inadmissible, MethodError, Motion, load, through
from kowalevski_cas.motion.attitude import quaternions
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.units import in_unit, unit_of
from tests.motion.o4.levels import KNOWN
from tests.motion.o4.levels import motion as on_O4
from tests.motion.test_frequencies import near_edges

STEP = 1e-4


def rotations(quaternion):
    return Rotation.from_quat(quaternion, scalar_first=True)


@given(st.sampled_from(KNOWN), st.floats(-10, 10))
def test_the_body_turns_with_the_angular_velocity(known, time):
    states = load("closed")(on_O4(known), time + STEP * np.array([-1.0, 0.0, 1.0]))
    before, _, after = rotations(quaternions(states))
    turned = (before.inv() * after).as_rotvec() / (2 * STEP)
    size = np.linalg.norm(states[1, :3])
    np.testing.assert_allclose(turned, states[1, :3], atol=1e-5 * (1 + size) ** 3)


def check_turning(motion, late):
    """However fast the top is, or small one of its fields, in units in which its size is 1."""
    try:
        unit = unit_of(initial_state(motion))
        times = 10.0**late + STEP * np.array([-1.0, 0.0, 1.0])
        states = in_unit(load("closed")(motion, np.ldexp(times, -unit)), unit)
    except (Inadmissible, MethodError):
        assume(False)
    found = quaternions(states)
    np.testing.assert_allclose(np.sum(found**2, axis=1), 1, rtol=0, atol=1e-15)
    before, _, after = rotations(found)
    turned = (before.inv() * after).as_rotvec() / float(times[2] - times[0])
    np.testing.assert_allclose(turned, states[1, :3], atol=1e-6)


@settings(max_examples=10, deadline=None)
@given(near_edges, st.floats(-3, 9))
def test_towards_every_edge_too_and_at_any_time(motion, late):
    check_turning(motion, late)


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(near_edges, st.floats(-3, 9))
def test_towards_every_edge_too_and_at_any_time_of_many(motion, late):
    check_turning(motion, late)


STATE = [0.1, 0.2, 0.3, 1.0, 0.0, 0.0, 0.0, 0.4, 0.2]
MOTIONS = {
    "N⁴": Motion.of(1, "0.4", "0.8", ell="0.9"),
    "N⁴, fields at an angle": Motion.of(1, 1, "-0.5", ell="0.1", c="0.4"),
    "O⁴": on_O4(KNOWN[0]),
    "off all sets": through(STATE),
}


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", MOTIONS)
def test_by_every_method_the_quaternion_is_a_unit_without_jumps(name, method):
    motion = MOTIONS[name]
    if method == "taylor":
        pytest.importorskip("heyoka")
    if method in ("closed", "ball") and motion.point is not None:
        return
    times = np.linspace(0, 5, 400 if method != "ball" else 40)
    states = load(method)(motion, times)
    found = quaternions(states)
    np.testing.assert_allclose(np.sum(found**2, axis=1), 1, rtol=0, atol=1e-15)
    assert np.all(np.sum(found[1:] * found[:-1], axis=1) > 0.9)
    in_space = rotations(found).apply(states[:, 6:])
    np.testing.assert_allclose(in_space, np.tile(in_space[0], (len(times), 1)), atol=1e-9)


@pytest.mark.parametrize("power", [-300, -160, 150])
def test_fields_of_any_size_tell_the_attitude(power):
    states = np.array([STATE, [*STATE[:3], 0.6, 0.8, 0.0, -0.32, 0.24, 0.2]])
    scaled = states.copy()
    scaled[:, 3:6] *= 10.0**power
    scaled[:, 6:] *= 10.0 ** (power + 7)
    np.testing.assert_allclose(quaternions(scaled), quaternions(states), atol=1e-15)


@given(st.sampled_from(KNOWN))
def test_in_space_the_fields_rest_and_the_quaternion_is_a_unit_without_jumps(known):
    states = load("closed")(on_O4(known), np.linspace(0, 20, 2000))
    found = quaternions(states)
    np.testing.assert_allclose(np.sum(found**2, axis=1), 1, rtol=0, atol=1e-15)
    assert np.all(np.sum(found[1:] * found[:-1], axis=1) > 0)
    a, b, *_ = map(float, known)
    for field, fixed in ((states[:, 3:6], [a, 0, 0]), (states[:, 6:], [0, b, 0])):
        np.testing.assert_allclose(rotations(found).apply(field) - fixed, 0, atol=1e-13 * a)


def test_parallel_fields_do_not_tell_the_attitude(capsys):
    with pytest.raises(Inadmissible, match="parallel"):
        quaternions(np.array([[0, 0, 1.0, 1, 0, 0, 2, 0, 0]]))
    point = "0 0 1 1 0 0 2 0 0".split()
    assert main(["motion", "--point", *point, "--attitude", "--samples", "2"]) == 2
    assert "parallel" in capsys.readouterr().err
