"""A problem that anybody has written is proved or denied, and its certificate accepted."""

import json

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.library import available, find
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.certificate import load_certificates
from tests.sample import sampled

SEARCHED_OTHERWISE = {
    ("kharlamov2002", "M4-dimension"),
    ("kharlamov2002", "N4-dimension"),
    ("kharlamov2002", "appelrot-area"),
    ("kharlamov2002", "appelrot-dimension"),
    ("kharlamov2002", "critical-set"),
    ("kharlamov2002", "corrected/critical-set"),
}
"""Problems of kinds that have a search of their own, and one that is proved by a declared locus."""

PROBLEMS = [
    stored
    for name in available()
    for claim, stored in load_certificates(find(name)).items()
    if (name, claim) not in SEARCHED_OTHERWISE
]


@pytest.fixture
def cli(capsys):
    """Run the command here; its exit code and what it printed."""

    def cli(*arguments):
        code = main([str(argument) for argument in arguments])
        return code, *capsys.readouterr()

    return cli


@pytest.mark.parametrize("stored", sampled(PROBLEMS, 1, seed=2, id=lambda stored: stored.path.stem))
def test_the_committed_problems_are_found_anew(stored, tmp_path, cli):
    data = stored.data
    path = tmp_path / "problem.json"
    path.write_text(json.dumps({key: data[key] for key in ("claim", "spaces", "goals")}))
    code, out, _ = cli("prove", path)
    assert code == 0
    found = checker.check(out)
    assert (found.claim, found.digest, found.sign) == (data["claim"], data["digest"], data["sign"])


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"spaces": [], "goals": [3]}', "[" * 9999])
def test_what_is_no_problem_gets_a_message(text, tmp_path, cli):
    path = tmp_path / "problem.json"
    path.write_text(text)
    code, out, err = cli("prove", path)
    assert code == 2 and not out and f"{path}: " in err


def test_what_is_neither_proved_nor_denied_is_open(tmp_path, cli):
    """What follows where no real point is shows nothing."""
    goal = {
        "goal": "follows",
        "space": 0,
        "given": [[["^", "x", 2], -1]],
        "conclusions": [[["x", 0]]],
    }
    path = tmp_path / "problem.json"
    path.write_text(json.dumps({"spaces": [{"variables": ["x"]}], "goals": [goal]}))
    code, out, err = cli("prove", path)
    assert code == 3 and not out and "no real point is known" in err
