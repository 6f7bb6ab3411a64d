"""Work against precision, and leaving N⁴: what integrators lose and the closed form keeps."""

import numpy as np
import pytest

from study import Task, leaving, load, work_precision
from study.motions import INTEGRATORS, MOTIONS, relative_error
from tests.sample import sampled


def test_an_error_is_relative_to_the_state():
    motion, times = MOTIONS["m > 0"], np.array([1.0, 2.0])
    exact = work_precision.load("ball")(motion, times)
    assert relative_error(motion, exact * (1 + 1e-8), times) == pytest.approx(1e-8)


@pytest.mark.slow
@pytest.mark.parametrize("name", sampled(work_precision.CASES, 1))
def test_the_closed_form_is_exact_at_late_times_and_an_integrator_by_its_tolerance(name):
    _, motion = work_precision.CASES[name]
    assert work_precision._many(1000, motion)["errors"][0] < 1e-13
    coarse, fine = work_precision._measure_integration("dop853", [1e-5, 1e-9], motion)["errors"]
    assert fine < coarse / 100


@pytest.mark.parametrize("name", sampled(work_precision.CASES, 1))
def test_dense_output_is_exact_in_a_short_window(name):
    _, motion = work_precision.CASES[name]
    assert work_precision._dense("dop853", 1e-12, 1000, motion)["errors"][0] < 1e-8


def test_errors_across_a_hyperbolic_torus_grow_at_the_predicted_rate():
    row = leaving.follow("dop853", MOTIONS["m < 0"])
    assert row["rate"] == pytest.approx(row["predicted"], rel=0.1)


def test_nothing_grows_across_an_elliptic_torus():
    row = leaving.follow("dop853", MOTIONS["m > 0"])
    assert row["rate"] is None and row["predicted"] == 0
    assert max(row["distances"]) < 1e-11


@pytest.mark.parametrize("name", MOTIONS)
def test_the_closed_form_does_not_leave(name):
    assert max(leaving.follow("closed", MOTIONS[name])["distances"]) < 1e-13


def test_a_library_that_is_not_installed_is_left_out_with_the_reason(monkeypatch):
    def missing(*_):
        raise ModuleNotFoundError("no heyoka here")

    monkeypatch.setitem(INTEGRATORS, "taylor", missing)
    row = Task("taylor", "m > 0", lambda: leaving.follow("taylor", MOTIONS["m > 0"])).row()
    assert (row["verdict"], row["reason"]) == ("left out", "no heyoka here")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["work-precision", "leaving"])
def test_a_chart_has_a_line_for_each_method_that_was_measured(name):
    step = load(name)
    rows = [task.row() for task in step.measure(quick=True)]
    left = {"seconds": None, "verdict": "left out", "reason": "for this test"}
    figure = step.draw([*rows, {"method": "radau", "case": rows[0]["case"], **left}])
    known = sum(row["verdict"] == "measured" for row in rows)
    slope = name == "leaving"
    assert sum(len(axes.lines) for axes in figure.axes) == known + slope
