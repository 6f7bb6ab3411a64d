"""Frequencies and actions: against a Fourier analysis of motions, and against the energy."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, Motion, MotionO4, frequencies, load
from kowalevski_cas.motion.frequencies import shift_basis
from tests.motion.o4.levels import KNOWN
from tests.motion.o4.levels import motion as on_O4
from tests.motion.o4.test_edges import edges as edges_on_O4
from tests.motion.regions import EVERY_REGIME, SEPARATING
from tests.motion.regions import motion as on_N4
from tests.motion.test_limits import edges as edges_on_N4
from tests.sample import sampled

closed = load("closed")

TORI = [on_N4(*region) for region in EVERY_REGIME] + [on_O4(known) for known in KNOWN]

POINTS, STEP = 1 << 15, 0.11
LARGEST = 60


def of_constants(known):
    """The motion on O⁴ with these constants, if there is one."""
    try:
        return MotionO4.of(*known)
    except Inadmissible:
        assume(False)
        raise


near_edges = st.one_of(edges_on_N4(), edges_on_O4().map(of_constants))


def peaks(signal, step, count):
    """The frequencies of the largest peaks of a signal, to a small part of the resolution."""
    window = np.hanning(len(signal))
    spectrum = np.abs(np.fft.rfft(signal * window))
    scale = 2 * np.pi / (len(signal) * step)
    found = []
    for _ in range(count):
        place = int(np.argmax(spectrum))
        if place in (0, len(spectrum) - 1) or not spectrum[place - 1 : place + 2].all():
            spectrum[place] = 0
            continue
        low, here, high = np.log(spectrum[place - 1 : place + 2])
        found.append((place + (low - high) / (2 * (low - 2 * here + high))) * scale)
        spectrum[max(place - 4, 0) : place + 5] = 0
    return np.array(found)


@pytest.mark.parametrize("moving", sampled([(one,) for one in TORI], 1))
def test_each_peak_of_a_motion_is_a_whole_combination(moving):
    (one, two) = found = frequencies(moving).frequencies
    step = STEP / max(found)
    states = closed(moving, step * np.arange(POINTS))
    orders = np.arange(-LARGEST, LARGEST + 1)
    combinations = np.abs(orders[:, None] * one + orders * two).ravel()
    resolution = 2 * np.pi / (POINTS * step)
    for signal in states.T:
        for peak in peaks(signal - np.mean(signal), step, 4):
            assert np.min(np.abs(combinations - peak)) < 0.05 * resolution


def energy(motion):
    return motion.constants["h"]


def check_energy(make, at):
    """The derivative of H by a constant is that of the actions times the frequencies."""
    rates = np.array(frequencies(make(*at)).frequencies)
    for k in (0, 1):
        step = 1e-5 * np.eye(2)[k]
        after, before = make(*(at + step)), make(*(at - step))
        change = np.array(frequencies(after).actions) - np.array(frequencies(before).actions)
        np.testing.assert_allclose(
            rates @ change, energy(after) - energy(before), rtol=1e-6, atol=1e-12
        )


@pytest.mark.parametrize("region", sampled([(region,) for region in EVERY_REGIME], 2))
def test_on_N4_the_energy_changes_as_the_actions_do(region):
    known = on_N4(*region).parameters
    at = np.array([float(known.m), float(known.ell)])
    check_energy(lambda m, ell: Motion.of(known.a, known.b, m, ell=ell), at)


@pytest.mark.parametrize("known", sampled([(known,) for known in KNOWN], 1))
def test_on_O4_the_energy_changes_as_the_actions_do(known):
    a, b, s, tau = known
    check_energy(lambda s, tau: MotionO4.of(a, b, s, tau), np.array([float(s), float(tau)]))


@settings(max_examples=5, deadline=None)
@given(st.sampled_from(TORI), st.floats(0.1, 10))
def test_in_another_unit_of_time_frequencies_and_actions_are_multiplied(moving, unit):
    if isinstance(moving, MotionO4):
        known = moving.parameters
        given = known.a * unit**2, known.b * unit**2, known.s * unit**2, known.tau * unit**4
        after = MotionO4.of(*map(float, given))
    else:
        known = moving.parameters
        a, b, m = (float(x) for x in (known.a, known.b, known.m))
        after = Motion.of(a * unit**2, b * unit**2, m / unit**2, ell=float(known.ell))
    first, second = frequencies(moving), frequencies(after)
    np.testing.assert_allclose(second.frequencies, unit * np.array(first.frequencies), rtol=1e-9)
    np.testing.assert_allclose(second.actions, unit * np.array(first.actions), rtol=1e-8)


BASES = {str(one.regime): shift_basis(one) for one in TORI}


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(near_edges)
def test_towards_every_edge_the_lattice_is_that_of_the_regime_and_frequencies_are_given(moving):
    """However small the circle of one variable is there, or the fields are beside ω²."""
    try:
        found = frequencies(moving)
    except Inadmissible as error:
        assert "fills no torus" in str(error)
        assume(False)
    assert all(0 < rate < np.inf for rate in found.frequencies)
    unit = moving.parameters.unit
    np.testing.assert_array_equal(shift_basis(moving.in_unit(unit)), BASES[str(moving.regime)])


def test_a_motion_that_tends_to_rest_has_none():
    with pytest.raises(Inadmissible, match="fills no torus"):
        frequencies(on_N4(*SEPARATING["s2 is asymptotic"]))
