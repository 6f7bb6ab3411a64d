"""The phase point in every way: exact arithmetics prove it, SymPy's expand does not see it."""

import pytest

from study import phase_point


def tasks(case):
    return {task.method: task for task in phase_point.measure(quick=True) if task.case == case}


def test_exact_arithmetics_prove_the_phase_point():
    for method in ("flint", "symengine", "sympy"):
        assert tasks("point.c")[method].run()["verdict"] in ("proved", "conditional")


@pytest.mark.parametrize(("call", "verdict"), [("cancel", "accepted"), ("expand", "rejected")])
def test_what_sympy_sees_of_a_true_statement_with_roots(call, verdict):
    assert tasks("point.c")[f"SymPy {call}"].run()["verdict"] == verdict


def test_a_method_that_failed_is_drawn():
    rows = [
        {"method": "flint", "case": "point.c", "seconds": 0.01, "verdict": "proved"},
        {"method": "SymPy expand", "case": "point.c", "seconds": 0.1, "verdict": "rejected"},
        {"method": "SymPy simplify", "case": "point.c", "seconds": 120, "verdict": "timeout"},
    ]
    (axes,) = phase_point.draw(rows)["phase-point"].axes
    drawn = {
        (line.get_xdata()[0], line.get_markerfacecolor() == "white")
        for line in axes.lines
        if len(line.get_xdata())
    }
    assert drawn == {(0.01, False), (0.1, True), (120, True)}
