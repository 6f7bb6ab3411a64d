"""The command that finds first integrals: what it finds is decided like any claim."""

import json

import pytest

from kowalevski_cas.cli import main

CLOSURE = ["find", "closure", "kharlamov2002", "--scene"]
CASE = ["find", "integrals", "kharlamov2002", "--scene", "Kowalevski case"]


def test_the_integrals_of_the_kowalevski_case(capsys):
    assert main([*CASE, "--degree", "4"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "proved  α₁² + α₂² + α₃²"
    assert lines[3] == "proved  2ω₁² + 2ω₂² + ω₃² − 2α₁ − 2β₂"
    assert all(line.startswith("proved  ") for line in lines[:-1])
    assert lines[-1] == "6 found"


def test_coefficients_in_the_constants(capsys):
    scene = ["find", "integrals", "kharlamov2002", "--scene", "general body", "--constants", "1"]
    assert main([*scene, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert len(found) == 4
    assert {entry["verdict"] for entry in found} == {"proved"}
    assert r"\omega_1^2A_1" in found[-1]["formulas"][0]


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["find", "integrals", "kharlamov2002"], 6, "name a scene"),
        (["find", "integrals", "kharlamov2002", "--scene", "Kowalevski"], 6, "Kowalevski case"),
        (["find", "integrals", "nobody1900"], 2, "there is no derivation"),
        ([*CLOSURE, "Kowalevski case", "q_7"], 2, "q_7 is not declared here"),
        ([*CLOSURE, "Kowalevski case", "J_1-J_1"], 2, "the function vanishes identically"),
        ([*CASE, "--degree", "40", "--timeout", "0.5"], 3, "give it a longer --timeout"),
        (
            ["find", "integrals", "kharlamov2002", "--scene", "complex variables with the root"],
            2,
            "a root stands in the equations of motion",
        ),
    ],
)
def test_what_cannot_be_done_says_why(capsys, words, code, said):
    assert main(words) == code
    assert said in capsys.readouterr().err


def test_a_function_and_its_derivative_define_an_invariant_set(capsys):
    assert main([*CLOSURE, "Kowalevski case", "J_1", "--order", "2"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("conditional  ω₁² − ω₂² + α₁ − β₂ = 0, 2ω₁ω₂ω₃ + ω₃α₂ + ")
    assert [line.split()[0] for line in lines[1:]] == ["conditional", "proved", "3"]


@pytest.mark.slow
def test_the_relations_of_the_paper_and_a_third_one_that_needs_no_condition(capsys):
    assert main([*CLOSURE, "complex variables", r"\theta\omega_3-Q_1", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [one["verdict"] for one in found] == ["conditional"] * 2 + ["proved"] * 4
    assert [len(one["formulas"]) for one in found] == [2, 1, 2, 3, 1, 1]
    assert "dimension 7" in found[2]["says"]
    assert found[4]["says"].startswith("the symmetric square of y'' = qy with $q=")
