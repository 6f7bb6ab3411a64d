from __future__ import annotations

from dataclasses import replace
from itertools import product

import pytest

from kowalevski_cas.algebra import load
from kowalevski_cas.tools import MissingTool
from study.growth import draw
from study.growth.formulation import formulation
from study.growth.programs import LIBRARIES, PROGRAMS, write_program
from study.growth.work import growth, steps
from study.process import race
from tests.sample import sampled


@pytest.mark.parametrize(
    ("claim", "arithmetic"), sampled(product(["eq15", "eq16.invariance"], ["flint", "sympy"]), 2)
)
def test_derivatives_of_the_relations_are_powers_of_the_matrix(claim, arithmetic):
    assert [*steps(growth(claim, load(arithmetic)), 2)] == [0, 1, 2]


def test_points_see_it_too_and_a_wrong_matrix_is_seen():
    assert [*steps(growth("eq15"), 3)] == [0, 1, 2, 3]
    wrong = growth("eq15")
    wrong.matrix[0][0] = wrong.at.ring.one
    assert [*steps(wrong, 3)] == [0]


@pytest.mark.parametrize(
    ("claim", "name"), sampled(product(["eq15", "eq16.invariance"], [*LIBRARIES, *PROGRAMS]), 1)
)
def test_every_program_comes_to_the_same_and_sees_a_wrong_matrix(claim, name, tmp_path):
    work = formulation(claim)
    wrong = replace(work, matrix=[*work.matrix[:3], work.matrix[3] + 1])
    for given, steps_done, reason in ((work, [0, 1, 2], ""), (wrong, [0], "fails")):
        try:
            command = write_program(name, given, 2, tmp_path)
        except MissingTool as missing:
            pytest.skip(str(missing))
        found = race(command, tmp_path, 60, 2048, 2)
        assert (found["steps"], found["verdict"]) == (
            steps_done,
            "stopped" if reason else "reached",
        )
        assert reason in found["reason"]


def test_what_a_limit_stopped_has_a_cross_at_its_end():
    rows = [
        {"method": method, "case": "real", "verdict": verdict, "steps": [1, 2],
         "times": [0.1, end], "memory": [10**7, None]}
        for method, verdict, end in (("flint", "reached", 0.2), ("pari", "timeout", 3.0))
    ]  # fmt: skip
    times = draw(rows).axes[1]
    assert [line.get_ydata() for line in times.lines if line.get_marker() == "x"] == [[3.0]]
    assert {line.get_label() for line in times.lines} >= {"this program, FLINT", "PARI/GP"}
