from __future__ import annotations

from itertools import product

import pytest

from kowalevski_cas.algebra import load
from kowalevski_cas.tools import MissingTool
from study.growth import draw
from study.growth.trace import LANGUAGES, program, record_steps
from study.growth.work import growth, steps
from study.process import race
from tests.sample import sampled


@pytest.mark.parametrize(
    ("claim", "arithmetic"), sampled(product(["eq15", "eq16.invariance"], ["flint", "sympy"]), 2)
)
def test_derivatives_of_the_relations_are_powers_of_the_matrix(claim, arithmetic):
    assert len(list(steps(growth(claim, load(arithmetic)), 2))) == 2


def test_points_see_it_too_and_a_wrong_matrix_is_seen():
    work = growth("eq15")
    assert len(list(steps(work, 3))) == 3
    wrong = growth("eq15")
    wrong.matrix[0][0] = wrong.at.ring.one
    assert len(list(steps(wrong, 3))) == 0


@pytest.mark.parametrize("name", LANGUAGES)
def test_the_same_operations_come_to_the_same_elsewhere(name, tmp_path):
    language = LANGUAGES[name]
    try:
        call = language.call()
    except MissingTool as missing:
        pytest.skip(str(missing))
    file = tmp_path / f"growth{language.suffix}"
    generators, lines = record_steps("eq15", 2, 10)
    file.write_text(program(language, generators, lines))
    assert race([*call, file.name], tmp_path, 60, 2048)["steps"] == [1, 2]
    wrong = [("add" if name == "multiply" else name, *rest) for name, *rest in lines]
    file.write_text(program(language, generators, wrong))
    found = race([*call, file.name], tmp_path, 60, 2048)
    assert (found["verdict"], found["reason"]) == ("stopped", "fails")


def test_what_a_limit_stopped_has_a_cross_at_its_end():
    rows = [
        {"method": method, "case": "real", "verdict": verdict, "steps": [1, 2],
         "times": [0.1, end], "memory": [10**7, None]}
        for method, verdict, end in (("flint", "reached", 0.2), ("pari", "timeout", 3.0))
    ]  # fmt: skip
    times = draw(rows).axes[1]
    assert [line.get_ydata() for line in times.lines if line.get_marker() == "x"] == [[3.0]]
    assert {line.get_label() for line in times.lines} >= {"FLINT", "PARI/GP"}
