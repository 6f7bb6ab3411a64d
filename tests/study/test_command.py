"""The command `python -m study`, with a step that takes no time."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from kowalevski_cas.cli import run
from kowalevski_cas.pictures import style
from study import STEPS, command, load, page
from study.command import FULL
from study.store import load_rows
from tests.study.toys import Interrupt


def main(arguments):
    return run("python -m study", "study.command", arguments)


@pytest.fixture
def step(monkeypatch):
    step = Interrupt()
    for module in (command, page):
        monkeypatch.setattr(module, "STEPS", ("toys",))
        monkeypatch.setattr(module, "load", lambda name: step)
    return step


def test_a_study_says_what_it_measured(step, tmp_path, capsys):
    assert main(["--quick", "-o", str(tmp_path)]) == 0
    assert capsys.readouterr().out == "toys: toys: 3 measurements\n"
    assert {path.name for path in tmp_path.iterdir()} == {"toys.png", "data"}
    head = json.loads((tmp_path / "data" / "toys.jsonl").read_text().splitlines()[0])
    assert head["quick"] is True and {"processor", "Python", "sympy"} <= head["machine"].keys()


def test_a_whole_study_has_a_page_with_its_captions(step, tmp_path):
    folder = tmp_path / "study"
    assert main(["-o", str(folder)]) == 0
    assert f"![toys](toys.png)\n\n{step.CAPTION}" in (folder / "README.md").read_text()


def test_the_committed_page_has_the_charts_and_the_captions_of_this_version(tmp_path):
    committed = Path(__file__).parents[2] / FULL
    assert {path.stem for path in (committed / "data").iterdir()} == set(STEPS)
    assert {path.stem for path in committed.glob("*.png")} == set(STEPS)
    for name in STEPS:
        (tmp_path / f"{name}.png").touch()
    page.write_page(tmp_path)
    assert (tmp_path / "README.md").read_text() == (committed / "README.md").read_text()


@pytest.mark.slow
@pytest.mark.parametrize("name", STEPS)
def test_the_committed_measurements_can_be_drawn(name):
    with style():
        assert load(name).draw(load_rows(name, Path(__file__).parents[2] / FULL)).axes


def test_drawing_measures_nothing(step, tmp_path):
    main(["-o", str(tmp_path)])
    step.ran.clear()
    (tmp_path / "toys.png").unlink()
    assert main(["--draw", "-o", str(tmp_path)]) == 0
    assert step.ran == [] and (tmp_path / "toys.png").exists()


def test_nothing_to_draw_is_no_success(step, tmp_path, capsys):
    assert main(["--draw", "-o", str(tmp_path)]) == 6
    assert "nothing is stored for “toys”" in capsys.readouterr().err


def test_an_unknown_step_is_named(step, capsys):
    assert main(["tosy"]) == 6
    assert "no step “tosy”; there are toys" in capsys.readouterr().err


def test_an_interruption_keeps_what_was_measured(step, tmp_path):
    step.at = "slow"
    assert main(["-o", str(tmp_path)]) == 130
    step.at = ""
    step.ran.clear()
    assert main(["-o", str(tmp_path)]) == 0
    assert step.ran == ["slow"]


def test_a_measurement_that_fails_is_no_success(step, tmp_path, capsys):
    step.fails = "fair"
    assert main(["-o", str(tmp_path)]) == 3
    said = capsys.readouterr()
    assert said.out == "toys: toys: 3 measurements, 1 error\n"
    assert said.err == "fair on one failed: ValueError: it cannot\n"


def test_a_disagreement_of_exact_arithmetics_has_its_exit_code(step, tmp_path, monkeypatch, capsys):
    contradicted = {"seconds": 1.0, "verdict": "disagreement", "reason": "eq1: both"}
    monkeypatch.setattr(step, "_run", lambda method: contradicted)
    assert main(["-o", str(tmp_path)]) == 4
    assert "the exact arithmetics disagree: eq1: both" in capsys.readouterr().err


def test_a_folder_that_cannot_be_written_is_named(step, capsys):
    assert main(["-o", "/dev/null/x"]) == 2
    assert (
        "/dev/null/x/data/toys.jsonl: cannot be written: Not a directory" in capsys.readouterr().err
    )


def test_a_picture_that_lacks_a_measurement_says_which(step, tmp_path, monkeypatch, capsys):
    def draw(rows):
        raise KeyError("good")

    monkeypatch.setattr(step, "draw", draw)
    assert main(["-o", str(tmp_path)]) == 2
    assert "“toys” cannot be drawn: 'good' is missing in" in capsys.readouterr().err
