"""The steps about motions: the closed form where other methods fail, and what is said of those."""

from fractions import Fraction

import numpy as np
import pytest

from study import STEPS, load
from study.motion import leaving, limits, precision
from study.motion import long as long_times
from study.motion.cases import INTEGRATORS, MOTIONS, forecast

STABLE, UNSTABLE = MOTIONS["m > 0"], MOTIONS["m < 0"]


@pytest.mark.parametrize("power", [1, 15, 40])
@pytest.mark.parametrize("name", limits.LIMITS)
def test_the_closed_form_keeps_its_accuracy_in_every_limit(name, power):
    assert limits._closed(limits.LIMITS[name], Fraction(1, 10**power))["error"] < 1e-13


def test_an_integrator_loses_the_motion_close_to_a_double_root():
    lost = limits._run("dop853", limits.LIMITS["asymptotic-1"], Fraction(1, 10**30))
    near = limits._run("dop853", limits.LIMITS["asymptotic-1"], Fraction(1, 10))
    assert near["error"] < 1e-9 < 1e-6 < lost["error"]


@pytest.mark.parametrize("name", MOTIONS)
@pytest.mark.parametrize("power", [0, 12, 30])
def test_the_closed_form_keeps_its_phase_at_very_long_times(name, power):
    assert long_times._closed(MOTIONS[name], power)["error"] < 1e-13


def test_a_phase_that_is_rounded_once_is_lost_like_t():
    early, late = (long_times._rounded(STABLE, power)["error"] for power in (4, 12))
    assert 1e6 < late / early < 1e10


def test_a_displacement_across_n4_grows_at_the_predicted_rate_or_not_at_all():
    unstable = leaving._run("dop853", UNSTABLE, leaving.DISPLACED)
    assert unstable["rate"] == pytest.approx(unstable["predicted"], rel=0.1)
    stable = leaving._run("dop853", STABLE, leaving.DISPLACED)
    assert stable["rate"] is None and stable["predicted"] == 0 < stable["frequency"]
    assert max(stable["distances"]) < 10 * leaving.DISPLACED


@pytest.mark.parametrize("name", MOTIONS)
def test_the_closed_form_does_not_leave(name):
    assert max(leaving._closed(MOTIONS[name])["distances"]) < 1e-13


@pytest.mark.parametrize("name", MOTIONS)
def test_the_closed_form_is_exact_at_late_times(name):
    row = precision._closed(MOTIONS[name], 1e6)
    assert row["error"] < 1e-13
    assert max(row["drift"].values()) < 1e-13


def test_an_integrator_that_would_take_too_long_is_left_out_with_the_reason():
    row = precision._run("dop853", STABLE, 1e7, 1e-12)
    assert (row["seconds"], row["verdict"]) == (None, "left out")
    assert "more than 10 s" in row["reason"]


def test_a_method_that_is_not_installed_is_left_out_with_the_reason(monkeypatch):
    def missing(*_):
        raise ModuleNotFoundError("no heyoka here")

    monkeypatch.setitem(INTEGRATORS, "taylor", missing)
    for row in (
        precision._run("taylor", STABLE, 10.0, 1e-16),
        leaving._run("taylor", STABLE, 0.0),
        limits._run("taylor", limits.LIMITS["rest-1"], Fraction(1, 10)),
    ):
        assert (row["verdict"], row["reason"]) == ("left out", "no heyoka here")


def test_a_forecast_counts_what_grows_with_time():
    times = []
    assert forecast(lambda time: times.append(time), 1.0, 1e6) < 1e5
    assert times == [1.0, 1.0, 3.0]


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in STEPS if name.startswith("motion-")])
def test_steps_have_tasks_of_different_names_and_draw_what_they_have(name):
    step = load(name)
    tasks = list(step.measure(quick=False))
    assert len({(task.method, task.case) for task in tasks}) == len(tasks) > 10
    first = [task for task in step.measure(quick=True) if task.method == "closed"][:3]
    rows = [task.row() for task in first]
    left = {"seconds": None, "verdict": "left out", "reason": "for this test"}
    rows.append({"method": "radau", "case": first[0].case, **left})
    drawn = step.draw(rows).values()
    assert any(axes.lines for figure in drawn for axes in figure.axes)


def test_an_error_is_relative_to_the_state():
    from study.motion.cases import relative_error

    exact = np.ones((2, 9))
    assert relative_error(exact * (1 + 1e-8), exact) == pytest.approx(1e-8)
