"""Poincaré sections: the closed form and two integrators meet the same states, on the same level."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kowalevski_cas.cli import main
from kowalevski_cas.motion import Inadmissible, Motion, MotionO4, section, through
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.units import in_unit, unit_of
from tests.motion.regions import motion
from tests.motion.test_critical import states
from tests.motion.test_frequencies import near_edges
from tests.sample import sampled

HYPERBOLIC = motion("-0.8", "0.5")
SOLVED = {
    "N⁴": Motion.of("1.2", "0.7", "0.6", ell="0.9"),
    "N⁴, hyperbolic": HYPERBOLIC,
    "O⁴": MotionO4.of("1.2", "0.7", "-0.9", "0.6"),
}
STATE = np.array([0.1, 0.2, 0.3, 1, 0, 0, 0, 0.4, 0.2])


@pytest.fixture(params=["heyoka", "SciPy"])
def by(request, monkeypatch):
    """A section by each of the two integrators."""
    if request.param == "heyoka":
        pytest.importorskip("heyoka")
    else:
        monkeypatch.setattr(section, "find_spec", lambda name: None)
    return section.section


@pytest.mark.slow
@pytest.mark.parametrize("name", SOLVED)
def test_the_closed_form_and_an_integrator_meet_the_same_states(name, by):
    exact = section.closed_section(SOLVED[name], 20.0)
    (found,) = by(initial_state(SOLVED[name])[None], 20.0)
    assert len(exact) >= 3
    np.testing.assert_allclose(found, exact, atol=1e-7)


@pytest.mark.slow
@settings(max_examples=20)
@given(st.sampled_from(range(9)), st.integers(-60, 60))
def test_a_section_is_where_the_coordinate_is_largest_in_any_unit_of_time(coordinate, power):
    rates = values_of_offer("equations")
    (usual,) = section.section(STATE[None], 20.0, coordinate)
    assert len(usual)
    assert np.max(np.abs(rates(*usual.T)[coordinate])) < 1e-9
    after = usual + 1e-3 * np.array(rates(*usual.T)).T
    assert np.all(np.array(rates(*after.T))[coordinate] < 0)  # it falls from there on
    unit = 2.0**power
    start = STATE * np.array([unit] * 3 + [unit**2] * 6)
    (scaled,) = section.section(start[None], 20.0 / unit, coordinate)
    np.testing.assert_array_equal(scaled / np.array([unit] * 3 + [unit**2] * 6), usual)


def check_largest(given, coordinate):
    """On its level, to a billionth of the size of the state."""
    try:
        start = given if isinstance(given, np.ndarray) else initial_state(given)
    except Inadmissible:
        assume(False)
    unit = unit_of(start)
    (found,) = section.section(start[None], float(np.ldexp(10.0, -unit)), coordinate)
    found = in_unit(found, unit)
    moved = np.array(values_of_offer("equations")(*found.T))[coordinate]
    assert np.max(np.abs(moved), initial=0) < 1e-9
    values = [values_of_offer("integrals")(*x.T)[:6] for x in (in_unit(start, unit), found)]
    for before, after in zip(*values, strict=True):
        np.testing.assert_allclose(after, np.broadcast_to(before, after.shape), atol=1e-9)


@settings(max_examples=10, deadline=None)
@given(states | near_edges, st.sampled_from(range(9)))
def test_of_every_state_and_towards_every_edge_the_coordinate_is_largest(given, coordinate):
    check_largest(given, coordinate)


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(states | near_edges, st.sampled_from(range(9)))
def test_of_many_states_and_towards_every_edge_the_coordinate_is_largest(given, coordinate):
    check_largest(given, coordinate)


@pytest.mark.parametrize("start", [STATE, *(initial_state(one) for one in SOLVED.values())])
def test_neighbours_are_on_the_level_and_as_far_away_as_is_said(start):
    distances = np.array([1e-6, 1e-3, 0.1])
    found = section.neighbours(start, distances)
    values = np.array(values_of_offer("integrals")(*found.T))
    level = np.array(values_of_offer("integrals")(*start))
    for constant in (0, 2, 3, 4, 5):  # H, a², b², c, G
        np.testing.assert_allclose(values[constant], level[constant], atol=1e-13)
    away = np.linalg.norm(found - start, axis=1)
    assert np.all((away > 0.1 * distances) & (away < 10 * distances))
    assert np.max(np.abs(values[1] - level[1])) > 1e-9, "and K is another one"


@pytest.mark.slow
def test_in_the_whole_top_elliptic_tori_of_N4_have_neighbours_that_stay_and_hyperbolic_ones_do_not():
    from kowalevski_cas.motion.critical import residuals

    def farthest(one):
        (found,) = section.section(section.neighbours(initial_state(one), [1e-6]), 200.0)
        return float(np.nanmax(residuals(found)["N4"]))

    assert farthest(SOLVED["N⁴"]) < 1e-5
    assert farthest(HYPERBOLIC) > 1e-2


@pytest.mark.parametrize(
    "given",
    sampled(
        [
            ["--point", *"0.1 0.2 0.3 1 0 0 0 0.4 0.2".split()],
            "--a 1 --b 0.4 --m 0.8 --l 0.9".split(),
        ],
        1,
    ),
)
def test_the_command_draws_the_section_of_any_state(given, tmp_path, monkeypatch):
    monkeypatch.setattr("kowalevski_cas.motion.pictures.poincare.UNTIL", 30.0)
    assert main(["pictures", "--section", "alpha1", *given, "--output", str(tmp_path)]) == 0
    assert {path.name for path in tmp_path.iterdir()} == {"poincare.png", "figures.json"}


def test_a_section_is_drawn_alone_and_of_a_coordinate(tmp_path, capsys):
    assert main(["pictures", "torus", "--section", "beta2", "--output", str(tmp_path)]) == 2
    assert "--section draws poincare alone" in capsys.readouterr().err
    assert through(STATE.tolist()).why
    with pytest.raises(SystemExit):
        main(["pictures", "--section", "gamma"])
