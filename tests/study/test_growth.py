from __future__ import annotations

import sys
from pathlib import Path

import pytest

from kowalevski_cas.algebra import load
from kowalevski_cas.systems import SYSTEMS, MissingSystem
from study.direct import direct, recorded
from study.growing import growth, steps
from study.growth_chart import chart
from study.growth_programs import WORDS, growth_program
from study.race import race


@pytest.mark.parametrize("claim", ["eq15", "eq16.invariance"])
@pytest.mark.parametrize("arithmetic", ["flint", "sympy"])
def test_derivatives_of_the_relations_are_powers_of_the_matrix(claim, arithmetic):
    assert len(list(steps(growth(claim, load(arithmetic)), 2))) == 2


def test_points_see_it_too_and_a_wrong_matrix_is_seen():
    work = growth("eq15")
    assert len(list(steps(work, 3))) == 3
    wrong = growth("eq15")
    wrong.matrix[0][0] = wrong.at.ring.one
    assert len(list(steps(wrong, 3))) == 0


def test_the_recorded_operations_can_be_repeated():
    times = list(direct("eq15", 2))
    assert len(times) == 2 and 0 < times[0] < times[1]


@pytest.mark.parametrize("program", WORDS)
def test_the_operations_come_to_the_same_elsewhere(program, tmp_path):
    words = WORDS[program]
    try:
        call = SYSTEMS[program].call()
    except MissingSystem as missing:
        pytest.skip(str(missing))
    text = growth_program(program, recorded("eq15", 2, 10))
    file = tmp_path / f"growth{words.suffix}"
    for content, reached in ((text, [1, 2]), (text.replace("diff(p", "2*diff(p", 1), None)):
        if reached is None and program != "singular":
            continue
        file.write_text(content)
        found = race([*call, *words.options, file.name], tmp_path, 20, 2048)
        assert (found["steps"] == reached and found["verdict"] == "reached") or (
            reached is None and found["verdict"] == "stopped"
        )


def script(text, seconds=10.0, mebibytes=2048):
    return race([sys.executable, "-c", text], Path.cwd(), seconds, mebibytes)


class TestRace:
    def test_steps_come_with_their_time_and_memory(self):
        found = script("for k in (1, 2): print('step', k, 0.5 * k)")
        assert (found["verdict"], found["steps"], found["times"]) == ("reached", [1, 2], [0.5, 1.0])

    def test_time_is_a_limit(self):
        found = script("import time; print('step 1 0', flush=True); time.sleep(60)", seconds=1.0)
        assert (found["verdict"], found["reason"], found["steps"]) == ("timeout", "1 s", [1])

    def test_memory_is_a_limit(self):
        found = script("x = bytearray(10**9)", mebibytes=300)
        assert (found["verdict"], found["reason"]) == ("timeout", "300 MiB")

    def test_an_error_is_no_success(self):
        assert script("import sys; sys.exit(3)")["reason"] == "exit code 3"
        assert script("print('fails')")["verdict"] == "stopped"


ROWS = [
    {"method": "flint", "case": case, "verdict": "reached", "reason": "", "steps": [1, 2],
     "times": [0.1, 0.2], "memory": [10**7, 10**8]}
    for case in ("complex", "real")
] + [
    {"method": "sympy", "case": case, "verdict": "timeout", "reason": "12 s", "steps": [1],
     "times": [3.0], "memory": [10**8]}
    for case in ("complex", "real")
] + [
    {"method": "pari", "case": "real", "verdict": "stopped", "reason": "exit code 1", "steps": [],
     "times": [], "memory": []}
]  # fmt: skip


def test_a_method_that_is_stopped_is_in_the_chart_with_its_limit():
    figure = chart(ROWS)
    words = " ".join(" ".join(t.get_text() for axes in figure.axes for t in axes.texts).split())
    assert "SymPy polynomials 1 (12 s)" in words and "PARI/GP 0 (exit code 1)" in words
