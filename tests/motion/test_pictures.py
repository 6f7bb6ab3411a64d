"""The pictures of a motion: what they show is what the motion is."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.motion import (
    Inadmissible,
    Motion,
    MotionO4,
    Parameters,
    all_regimes,
    load,
    regime_of,
)
from kowalevski_cas.motion.attitude import quaternions
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.pictures import (
    ON_N4,
    PICTURES,
    animation,
    orbit,
    poincare,
    sections,
    third,
)
from kowalevski_cas.motion.pictures import load as picture
from kowalevski_cas.motion.pictures.atlas import examples
from kowalevski_cas.motion.pictures.bifurcation import separating_curves
from kowalevski_cas.motion.pictures.space import View
from kowalevski_cas.motion.plane import regime_at
from kowalevski_cas.pictures import save, style
from tests.motion.o4.levels import KNOWN
from tests.motion.o4.levels import motion as on_O4
from tests.motion.regions import EVERY_REGIME, SEPARATING, motion
from tests.sample import sampled

THIRD = MotionO4.of("1.2", "0.7", "0.4", "-0.5", c="0.1", torus=2)
UNSTABLE, RESTING, ASYMPTOTIC = (
    motion("-0.8", "0.5"),
    motion(*SEPARATING["both rest"]),
    motion(*SEPARATING["s2 is asymptotic"]),
)


OF_FIELDS = ("bifurcation", "atlas", "subsystems", "resonances", "sections", "surfaces")
"""Pictures that look alike for all motions in the same fields."""


DRAWN = [
    (name, one)
    for one in (UNSTABLE, RESTING, ASYMPTOTIC)
    for name in PICTURES
    if one is UNSTABLE or name not in OF_FIELDS
] + [(name, THIRD) for name in PICTURES if name not in ON_N4]

LONG = ("resonances", "sections", "atlas")
"""Pictures of a whole diagram, or of many motions, which take their time."""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "drawn"),
    sampled([one for one in DRAWN if one[0] not in LONG], 1)
    + sampled([one for one in DRAWN if one[0] in LONG], 0),
)
def test_every_picture_can_be_drawn(name, drawn, tmp_path, monkeypatch):
    monkeypatch.setattr(sections, "representatives", lambda fields: [0.5, 1.0])
    monkeypatch.setattr(poincare, "UNTIL", 40.0)
    with style():
        file = save(picture(name).draw(drawn), tmp_path, name)
    assert file.stat().st_size > 5000
    assert picture(name).caption.count("$") % 2 == 0


@given(st.fractions("1/20", "19/20", max_denominator=1000), st.fractions(1, 100))
def test_there_is_a_motion_on_O4_to_be_drawn_in_all_fields(b, scale):
    drawn = third.example(Motion.of(scale, scale * b, 1, ell=2 * scale + 1))
    assert (drawn.parameters.a, drawn.parameters.b) == (scale, scale * b)


@pytest.mark.parametrize("drawn", [THIRD, Motion.of(1, 1, "-0.5", ell="0.1", c="0.4")])
def test_the_fields_end_on_the_spheres_that_are_drawn(drawn):
    states = orbit.orbit(drawn, 1, 9)
    for name, fields in (("a", states[:, 3:6]), ("b", states[:, 6:])):
        np.testing.assert_allclose(np.linalg.norm(fields, axis=1), drawn.constants[name])


def test_an_unknown_picture_names_those_that_there_are():
    with pytest.raises(ValueError, match="hodographs, traces"):
        picture("portrait")


@given(st.fractions(-3, 3, max_denominator=60), st.fractions(0, 3, max_denominator=60))
def test_the_regions_of_the_diagram_are_the_regimes(m, ell):
    fields = motion(*EVERY_REGIME[0]).parameters
    found = regime_at(fields, np.array([float(m)]), np.array([float(ell)]))[0]
    try:
        regime = regime_of(Parameters.of(fields.a, fields.b, m, ell))
    except Inadmissible:
        assert found == -1
    else:
        assert found == -1 or all_regimes()[found] == regime  # on a separating curve there is none


def test_the_separating_lines_are_those_of_the_paper():
    """ℓ = ±2am±1, ℓ = ±2bm±1 and ℓ = 0, for a = 1, b = 2/5."""
    m = np.array([-1.0, 0.5, 2.0])
    found = [tuple(ell) for _, _, ell in separating_curves(motion(*EVERY_REGIME[0]).parameters, m)]
    lines = [s * 2 * e * m + t for e in (1.0, 0.4) for s in (1, -1) for t in (1, -1)]
    assert sorted(map(tuple, np.round(found, 12))) == sorted(
        map(tuple, np.round([*lines, 0 * m], 12))
    )


def test_the_atlas_has_one_motion_in_each_regime_with_l_not_negative():
    found = examples(UNSTABLE.parameters)
    assert all(example.regime == regime for regime, example in found)
    assert {regime for regime, _ in found} == {
        motion(m, ell).regime for m, ell in EVERY_REGIME if not ell.startswith("-")
    }


@pytest.mark.parametrize("region", EVERY_REGIME)
def test_the_net_lies_on_the_torus_and_its_lines_are_closed(region):
    here = motion(*region)
    level = np.array(values_of_offer("integrals")(*load("closed")(here, np.zeros(1))[0]))
    for loop in orbit.net(here, 2, 7):
        values = np.array(values_of_offer("integrals")(*loop.T))
        assert np.max(np.abs(values - level[:, None])) < 1e-11
        np.testing.assert_allclose(loop[0], loop[-1], atol=1e-9)


def test_half_a_period_is_none():
    for region in EVERY_REGIME:
        here = motion(*region)
        for loop in orbit.net(here, 1, 3):
            assert np.max(np.abs(loop[0] - loop[1])) > 1e-3


def test_in_space_the_kinetic_moment_changes_by_the_moment_of_the_fields_only():
    """A frame that turned would add its own turning: (Iω)˙ = e1×α + e2×β, by fixed axes."""
    step = 1e-5
    around = np.array([1 - step, 1.0, 1 + step])
    states = load("closed")(UNSTABLE, around)
    moment = states.copy()
    moment[:, :3] *= (2, 2, 1)
    before, _, after = orbit.in_space(moment)
    torque = states.copy()
    alpha, beta = states[:, 3:6], states[:, 6:]
    torque[:, :3] = np.cross((1, 0, 0), alpha) + np.cross((0, 1, 0), beta)
    expected = orbit.in_space(torque)[1]
    np.testing.assert_allclose((after - before) / (2 * step), expected, atol=1e-8)


@pytest.mark.parametrize(
    "one", sampled([(one,) for one in (UNSTABLE, ASYMPTOTIC, THIRD, *map(on_O4, KNOWN))], 1)
)
def test_from_frame_to_frame_of_an_animation_the_body_turns_a_little(one):
    """Also where one angle makes many turns in one of the other: by forty degrees at most."""
    found = quaternions(animation._states(one, animation.FRAMES))
    assert np.min(np.sum(found[1:] * found[:-1], axis=1)) > np.cos(np.radians(20))


def test_a_view_keeps_lengths():
    points = np.random.default_rng(1).normal(size=(20, 3))
    flat, near = View(50, 20)(points)
    np.testing.assert_allclose(np.sum(flat**2, axis=1) + near**2, np.sum(points**2, axis=1))
