"""How long methods are right, and the top off integrability."""

import math

import numpy as np
import pytest

from kowalevski_cas.motion import critical, formulas, load
from kowalevski_cas.motion.general import General
from study import lasting, perturbed, splitting
from study.motions import MOTIONS
from tests.sample import sampled

STATE = np.random.default_rng(1).normal(size=9)


@pytest.mark.parametrize("change", perturbed.CHANGES)
def test_the_changed_top_is_the_printed_one_where_nothing_changes(change):
    printed = np.array(formulas.values_of_offer("equations")(*STATE))
    np.testing.assert_allclose(perturbed.rates(change, 0.0)(*STATE), printed, atol=1e-15)
    assert np.max(np.abs(np.array(perturbed.rates(change, 0.1)(*STATE)) - printed)) > 1e-3


def test_a_third_field_and_other_moments_keep_the_lengths_of_the_fields():
    for change in perturbed.CHANGES:
        rates = np.array(perturbed.rates(change, 0.1)(*STATE))
        for field in (slice(3, 6), slice(6, 9)):
            assert abs(STATE[field] @ rates[field]) < 1e-14


def test_a_step_of_the_splitting_is_one_of_the_printed_equations_and_keeps_the_fields():
    """Of order two: the error of a step is eight times smaller for half of it."""
    off = []
    for step in (1e-2, 5e-3):
        state = np.array(splitting.advance(list(STATE), step, math.cos, math.sin))
        back = np.array(splitting.advance(list(state), -step, math.cos, math.sin))
        np.testing.assert_allclose(back, STATE, atol=1e-14)
        fine = STATE
        for _ in range(64):
            fine = np.array(splitting.advance(list(fine), step / 64, math.cos, math.sin))
        off.append(np.max(np.abs(state - fine)))
        for field in (slice(3, 6), slice(6, 9)):
            assert np.linalg.norm(state[field]) == pytest.approx(np.linalg.norm(STATE[field]))
    assert 7 < off[0] / off[1] < 9
    rates = np.array(formulas.values_of_offer("equations")(*STATE))
    tiny = np.array(splitting.advance(list(STATE), 1e-7, math.cos, math.sin))
    np.testing.assert_allclose((tiny - STATE) / 1e-7, rates, atol=1e-5)


@pytest.mark.parametrize("name", sampled(lasting.cases(), 3))
def test_the_closed_form_is_right_at_all_times_on_each_class_of_state(name):
    motion = lasting.cases()[name]
    if motion.point is None:
        assert max(lasting.errors(motion, load("closed"), lasting.LAST)["errors"]) < 1e-12
    elif not isinstance(motion, General):
        pytest.importorskip("heyoka")
        assert max(lasting.errors(motion, load("closed"), 2)["errors"]) > 1e-9, "a neighbour's"


def test_the_state_on_M4_is_on_it_exactly_and_nowhere_else():
    first, second = critical.residuals(
        np.array([lasting.ON_M4, lasting.cases()["10⁻¹⁰ off M⁴"].point])
    )["M4"]
    assert first == 0 < second < 1e-9
    assert lasting.cases()["M⁴"].why.startswith("the state is not on N⁴")


def test_an_integrator_is_right_for_a_short_time_and_loses_digits_in_a_long_one():
    run, tolerance, _ = lasting.INTEGRATED["dop853"]

    def states(motion, times):
        return lasting._from_start(run, tolerance, motion, times)

    short, *_, long = lasting.errors(MOTIONS["m < 0"], states, 2)["errors"]
    assert short < 1e-11 < 1e-7 < long


def test_two_motions_come_apart_in_the_changed_top_only_where_the_torus_is_hyperbolic():
    pytest.importorskip("heyoka")
    found = {n: perturbed.exponents("moments", n, [0.03], 40)["exponents"][0] for n in MOTIONS}
    assert found["m < 0"] > 0.05 > 2 * abs(found["m > 0"])


@pytest.mark.slow
@pytest.mark.parametrize("step", [lasting, perturbed])
def test_a_chart_is_drawn_of_what_was_measured(step):
    assert len(step.draw([task.row() for task in step.measure(quick=True)]).axes) in (6, 15)
