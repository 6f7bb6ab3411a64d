"""Formulas that their authors corrected: what counts as noticed, and as mended as by the author."""

import json

import pytest

from kowalevski_cas.cli import run
from study.corrections import GREEN, LEFT, NOTICED, corrected_formula
from tests.sample import sampled

PAGE = r"""\documentclass{article}
\begin{document}
The equations of motion are
\begin{equation}\dot x=y,\qquad \dot y=-x.\label{eq:1}\end{equation}
A first integral is
\begin{equation}H=%s.\label{eq:2}\end{equation}
\end{document}
"""
RIGHT = r"\frac{1}{2}y^2+\frac{1}{2}x^2"


@pytest.fixture
def folder(tmp_path):
    def made(wrong, id="oscillator"):
        (tmp_path / id).mkdir()
        (tmp_path / id / "PAPER.tex").write_text(PAGE % wrong)
        entry = {"id": id, "kind": "sign", "label": "eq:2", "wrong": wrong, "right": RIGHT}
        (tmp_path / "index.json").write_text(json.dumps([entry]))
        return tmp_path, entry

    return made


@pytest.mark.parametrize(
    ("wrong", "end", "repaired"),
    sampled(
        [
            (r"\frac{1}{2}y^2-\frac{1}{2}x^2", NOTICED, True),
            (r"\frac{1}{2}y^2+y\frac{1}{2}x^2", NOTICED, False),
            (r"y^2+x^2", GREEN, False),
            (r"\frac{1}{2}y^2+\int x", LEFT, False),
        ],
        1,
    ),
)
def test_a_correction_is_noticed_if_the_wrong_formula_is_red(folder, wrong, end, repaired):
    found = corrected_formula(*folder(wrong), 5)
    assert found.end == end and (found.repaired == repaired or end == NOTICED)


@pytest.mark.slow
def test_the_command_counts_and_what_is_not_noticed_is_no_success(folder, capsys):
    path, _ = folder(r"\frac{1}{2}y^2-\frac{1}{2}x^2")
    assert run("python -m study.corrections", "study.corrections", [str(path)]) == 0
    assert "noticed 1, green 0, not noticed 0; as the author mended 1" in capsys.readouterr().out
    path, _ = folder("y^2+x^2", "other")
    assert run("python -m study.corrections", "study.corrections", [str(path)]) == 1


def test_its_help_says_when_it_is_no_success(capsys):
    with pytest.raises(SystemExit):
        run("python -m study.corrections", "study.corrections", ["--help"])
    assert "1   one is not noticed, or is proved" in capsys.readouterr().out
