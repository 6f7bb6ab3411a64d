"""Motions from any state and by any constants."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from kowalevski_cas.motion import General, Inadmissible, MethodError, Motion, load, through
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.formulas import INTEGRALS, values_of_offer
from kowalevski_cas.motion.frame import rotate
from kowalevski_cas.motion.methods.integrators import integrate
from kowalevski_cas.motion.regimes import tori
from kowalevski_cas.motion.result import Trajectory
from kowalevski_cas.motion.units import in_unit, unit_of
from tests.motion.exact import integrated
from tests.motion.levels_on_M4 import by_chance
from tests.motion.regions import EVERY_REGIME
from tests.motion.test_closed import constants, relative
from tests.motion.test_critical import states

closed, dop853 = load("closed"), load("dop853")
T = np.linspace(0.0, 3.0, 7)

whole = arrays(float, 9, elements=st.integers(-2, 2).map(float))
lengths = st.fractions(0, 2, max_denominator=50)


@given(states | whole)
@example(np.zeros(9))
@example(np.array([0, -1.0, -2, 0, 1, 2, -1, 0, 0]))  # x1x2 = 0, and two roots coincide
@example(np.array([-1.0, 1, 0, -1.5, 0, 1, 0, -1.5, 1]))  # the same, c ≠ 0
@example(np.array([-1.0, 1, 0, -1, 1, -1, 1, -1, 1]))  # parallel fields on M⁴
@example(np.array([0, 0, 0, 1.0, 0, 0, 0, 1, 0]))  # r = 0
@example(np.array([0, 0, 0, 1.0, 0, 0, 0, 1, 0.5]))  # m = 0
@example(np.array([0, 0, 1.0, 1, 0, 0, 2, 0, 0]))  # parallel fields
@example(np.array([1.0, 0, -0.1, 1e-236, -1e-12, 0, 1e-300, 0, 0]))  # one field is hardly a float
def test_every_state_is_followed_and_the_integrals_are_kept(state):
    motion = through(state.tolist())
    found = dop853(motion, T)
    assert found[0].tolist() == state.tolist()
    result = Trajectory(motion, T, found)
    assert max(result.drift.values()) < 1e-10
    assert ("none" in result.regime) == isinstance(motion, General)
    names = [name.strip("_12").lower() for name in INTEGRALS]
    values = dict(zip(names, values_of_offer("integrals")(*state), strict=True))
    for name in "hkg":
        assert result.invariants[name] == pytest.approx(values[name], rel=1e-9, abs=1e-9)


@given(states, st.one_of(st.floats(1e-25, 1e25), st.sampled_from([1e-70, 1e-140, 1e60, 1e70])))
def test_a_motion_is_the_same_in_another_unit_of_time(state, rate):
    r"""(νω, ν²α, ν²β) at t/ν: followed with the same relative error and the same drift."""
    scale = np.array([rate] * 3 + [rate**2] * 6)
    here, there = integrate("DOP853", state, T), integrate("DOP853", state * scale, T / rate)
    size = np.max(np.abs(here)) + 1
    assert np.max(np.abs(there / scale - here)) < 1e-9 * size
    far = General(tuple((state * scale).tolist()), "")
    drift, other = (
        Trajectory(General(tuple(state), ""), T, here).drift,
        Trajectory(far, T, there).drift,
    )
    assert all(abs(drift[name] - other[name]) < 1e-9 for name in drift)


@pytest.mark.slow
@given(states, st.floats(-9, 0), st.floats(-9, 0), st.sampled_from(["DOP853", "LSODA", "Radau"]))
def test_of_a_fast_top_each_field_is_followed_relative_to_its_size(state, weaker, less, method):
    """However small both are beside ω², and one beside the other; the drift says it as well."""
    state = in_unit(state, unit_of(state)) * np.repeat([1, 10**weaker, 10 ** (weaker + less)], 3)
    assume(all(np.max(np.abs(state[part])) > 0 for part in (slice(3, 6), slice(6, 9))))
    tolerance = 1e-9 if method == "Radau" else 1e-12
    (found,), exact = integrate(method, state, np.ones(1), tolerance), integrated(state, 1)
    for part in slice(0, 3), slice(3, 6), slice(6, 9):
        size = 1.0 if part.start == 0 else np.max(np.abs(state[part]))
        assert np.max(np.abs(found - exact)[part]) < 2000 * tolerance * size


@given(st.integers(0, 199), st.floats(-3, 3))
def test_a_motion_on_M4_says_how_many_tori_its_level_has(number, angle):
    # A turn of the fields with the body leaves the equations alone.
    fields = Fields(Fraction(6, 5), Fraction(7, 10))
    states, j, h = (found[number : number + 1] for found in by_chance(fields, 200))
    assume(abs(j[0]) > 1e-3)
    state = np.array(rotate(states.T, np.cos(angle), np.sin(angle)))
    result = Trajectory(through(state[:, 0].tolist()), T[:1], state.T)
    assert result.critical_sets["on"] == ["M4"]
    assert result.regime["tori"] == fields.tori_on_M4(h, j)


def test_what_has_no_closed_form_says_why():
    motion = through([0.1, 0.2, 0.3, 1, 0, 0, 0, 0.4, 0])
    with pytest.raises(Inadmissible, match="integrators follow the motion: the state is not on N⁴"):
        closed(motion, T)


@given(lengths, lengths, st.fractions(-1, 1, max_denominator=20), constants, constants, constants)
def test_the_fields_have_the_lengths_and_the_product_that_are_given(a, b, cosine, m, value, late):
    c = cosine * a * b
    try:
        motion = Motion.of(a, b, m, ell=value, c=c, origins=(late, 0))
    except Inadmissible:
        assume(False)
    start = closed(motion, np.zeros(1))[0]
    found = dict(zip(INTEGRALS, values_of_offer("integrals")(*start), strict=True))
    expected = {"a^2": a**2, "b^2": b**2, "c": c}
    for name, exact in expected.items():
        assert found[name] == pytest.approx(float(exact), abs=1e-12)
    for name, exact in motion.constants.items():
        if name in "hkg":
            assert found[name.upper()] == pytest.approx(exact, rel=1e-9, abs=1e-9)
    assert motion.constants["l"] == pytest.approx(float(value), abs=1e-15)
    assert relative(closed(motion, T), dop853(motion, T)) < 1e-6


@pytest.mark.parametrize("region", EVERY_REGIME)
def test_the_tori_are_different_and_are_all(region):
    m, ell = region
    count = tori(Motion.of(1, "0.4", m, ell=ell).parameters)
    numbered = [Motion.of(1, "0.4", m, ell=ell, torus=n) for n in range(1, count + 1)]
    assert len({motion.signs for motion in numbered}) == count
    with pytest.raises(Inadmissible, match=f"no torus {count + 1}: .*(1 to {count}|one torus)"):
        Motion.of(1, "0.4", m, ell=ell, torus=count + 1)


@given(constants, constants)
def test_the_origins_are_times_at_the_first_roots(t1, t2):
    later = Motion.of(1, "0.4", "0.8", ell="0.9", origins=(t1, t1))
    first = Motion.of(1, "0.4", "0.8", ell="0.9")
    assert relative(closed(later, T + float(t1)), closed(first, T)) < 1e-12
    assert Motion.of(1, "0.4", "0.8", ell="0.9", origins=(t1, t2)).origins == (t1, t2)


@pytest.mark.parametrize(
    ("a", "b", "c", "words"),
    [(1, 2, 3, r"\|c\| ≤ 2 would do"), (-1, 2, 0, "a = -1 is negative"), (1, 1, 0, "equal")],
)
def test_fields_that_there_are_not_are_refused(a, b, c, words):
    with pytest.raises(Inadmissible, match=words):
        Motion.of(a, b, Fraction(1), ell=3, c=c)


def test_a_field_that_is_lost_beside_the_velocities_is_said():
    motion = through([0, -0.3, -5e164, 0, -1, 0, 0.1, 0, 0])
    with pytest.raises(MethodError, match="so small beside ω²"):
        dop853(motion, T / 5e164)
