"""The command that finds first integrals: what it finds is decided like any claim."""

import json

import pytest

from kowalevski_cas.cli import main

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
