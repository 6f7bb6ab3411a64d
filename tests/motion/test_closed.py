"""The closed form against balls, against integration, and against its own laws."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, Motion, Parameters, all_regimes, load
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.methods.ball import enclosures
from kowalevski_cas.motion.point import on_N4
from tests.motion.regions import EVERY_REGIME, SEPARATING, motion
from tests.sample import sampled

closed, ball, dop853 = load("closed"), load("ball"), load("dop853")
ORIGINS = (Fraction(1, 3), Fraction(-1, 7))
ALL = [*EVERY_REGIME, *SEPARATING.values()]

times = st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=4).map(np.array)
lengths = st.tuples(st.fractions(0, 2, max_denominator=50), st.fractions(0, 2, max_denominator=50))
constants = st.fractions(-3, 3, max_denominator=60)
signs = st.sampled_from([(1, 1), (1, -1), (-1, 1), (-1, -1)])


def relative(found, expected):
    difference = np.linalg.norm(found - expected, axis=1)
    return np.max(difference / np.linalg.norm(expected, axis=1))


@st.composite
def motions(draw):
    """A motion with random constants, phases and signs."""
    (b, a), m, ell = sorted(draw(lengths)), draw(constants), draw(constants)
    try:
        make = draw(st.sampled_from([Parameters.of, Parameters.at_energy]))
        parameters = make(a, b, m, ell)
        return Motion(parameters, (draw(constants), draw(constants)), draw(signs))
    except Inadmissible:
        assume(False)


def test_the_regions_are_all_regimes():
    assert {motion(*region).regime for region in EVERY_REGIME} == set(all_regimes())


@given(motions(), times)
def test_it_agrees_with_balls_at_any_time(motion, t):
    assert relative(closed(motion, t), ball(motion, t)) < 1e-13


@pytest.mark.parametrize("region", ALL)
def test_it_agrees_with_balls_in_every_regime(region):
    moved = motion(*region, origins=ORIGINS)
    t = np.array([0, 0.1, 1, -7, 55.5, 1e6, -1e15, 1e100, 3e250])
    assert relative(closed(moved, t), ball(moved, t)) < 1e-14


@pytest.mark.parametrize("region", ALL)
def test_it_solves_the_nine_equations(region):
    moved = motion(*region, origins=ORIGINS, signs=(-1, 1))
    t = np.linspace(-3, 3, 7)
    assert relative(closed(moved, t), dop853(moved, t)) < 1e-9


@given(motions(), times)
def test_its_derivative_is_the_right_hand_side(motion, t):
    # Five points of balls: an error of h⁴, far below what rounding leaves of floats.
    h = Fraction(1, 2**40)
    for start in t.tolist():
        points = [Fraction(start) + k * h for k in (-2, -1, 0, 1, 2)]
        a, b, c, d, e = (
            [float(x.mid() - y.mid()) for x, y in zip(state, middle, strict=True)]
            for states in [enclosures(motion, points, 300)]
            for middle in [states[2]]
            for state in states
        )
        slope = [
            (w - 8 * x + 8 * y - z) / float(12 * h) for w, x, y, z in zip(a, b, d, e, strict=True)
        ]
        expected = values_of_offer("equations")(*closed(motion, np.array([start]))[0])
        scale = 1 + np.linalg.norm(expected)
        assert np.linalg.norm(np.array(slope) - expected) < 1e-11 * scale
        assert c == [0.0] * 9


@given(motions(), times)
def test_its_integrals_have_the_values_of_its_constants_to_rounding(motion, t):
    states, known = closed(motion, t), motion.parameters
    expected = (known.h, known.k, known.a**2, known.b**2, 0, known.g, 0, 0)
    size = max(1.0, np.max(np.abs(states))) ** 6
    for values, value in zip(values_of_offer("integrals")(*states.T), expected, strict=True):
        assert np.max(np.abs(values - float(value))) < 1e-13 * size


@given(motions(), times)
def test_backwards_in_time_the_angular_velocity_turns_round(motion, t):
    # t → −t, ω → −ω leaves the equations alone. sn is odd: S or f changes sign with it, and
    # f has to.
    signs = tuple(
        sign * (-1 if 0 in oscillation.field_roots else 1)
        for sign, oscillation in zip(motion.signs, motion.oscillations(), strict=True)
    )
    back = Motion(motion.parameters, tuple(-origin for origin in motion.origins), signs)
    turned = np.array([-1, -1, -1, 1, 1, 1, 1, 1, 1])
    assert relative(closed(back, -t), closed(motion, t) * turned) < 1e-13


@pytest.mark.parametrize("region", [region for region in EVERY_REGIME if region[1] > "0"])
@pytest.mark.parametrize("signs", [(1, 1), (1, -1), (-1, 1), (-1, -1)])
def test_the_signs_are_those_of_the_third_components_just_after_the_origins(region, signs):
    # With s1 > s2 they are those of S1 and S2.
    [state] = closed(motion(*region, signs=signs), np.array([1e-7]))
    assert (np.sign(state[5]), np.sign(state[8])) == signs


@pytest.mark.parametrize("region", sampled([(r,) for r in EVERY_REGIME if r[1] > "0"], 1))
def test_ell_changes_sign_where_s1_passes_through_infinity(region):
    # With the positive root of x1x2, ℓ keeps its sign for m > 0; for m < 0 both signs occur.
    states = closed(motion(*region, origins=ORIGINS), np.linspace(0, 30, 12))
    found = {on_N4(state.tolist()).parameters.ell_sign for state in states}
    assert found == ({1, -1} if region[0].startswith("-") else {1})
