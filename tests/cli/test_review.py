"""The papers of a repository: what is false fails, unless it was known."""

import json
import subprocess
from xml.etree import ElementTree

import pytest
from jsonschema import validate

from kowalevski_cas.cli import main
from kowalevski_cas.report.badge import badge
from kowalevski_cas.schema import schema

PAPER = r"""\documentclass{article}
\begin{document}
The oscillator moves by
\[\dot x=v,\quad \dot v=-x.\]
The energy $H=\frac12(v^2%sx^2)$ is a first integral.
\end{document}
"""
RIGHT, WRONG = PAPER % "+", PAPER % "-"


@pytest.fixture
def repository(tmp_path, monkeypatch):
    """An empty repository, in which the test is."""
    monkeypatch.chdir(tmp_path)
    git("init", "-q")
    return tmp_path


def git(*words):
    names = ("-c", "user.name=a", "-c", "user.email=a@b", "-c", "commit.gpgsign=false")
    subprocess.run(["git", *names, *words], check=True, capture_output=True)


def commit():
    git("add", "-A")
    git("commit", "-q", "-m", "papers")


@pytest.mark.slow
def test_what_is_false_fails_at_its_line_until_it_is_known(repository, capsys):
    (repository / "paper.tex").write_text(WRONG)
    (repository / "chapter.tex").write_text("no paper: $x=")
    assert main(["review", "--format", "github", "--badge", "badge.svg", "--sarif", "a.sarif"]) == 1
    marked, summary = capsys.readouterr().out.splitlines()
    assert marked.startswith("::error file=paper.tex,line=5,col=13,")
    assert summary == "paper.tex: 1 refuted"
    assert "1 false" in (repository / "badge.svg").read_text()
    (result,) = json.loads((repository / "a.sarif").read_text())["runs"][0]["results"]
    assert result["fixes"]

    assert main(["review", "--baseline", "known.json", "--update"]) == 0
    validate(json.loads((repository / "known.json").read_text()), schema())
    (repository / "paper.tex").write_text(WRONG.replace("The osc", "\n\nThe osc"))
    capsys.readouterr()
    assert main(["review", "--strict", "--baseline", "known.json"]) == 0
    assert capsys.readouterr().out == "paper.tex: 1 refuted; 1 known\n"


@pytest.mark.slow
def test_only_papers_that_changed_or_that_read_what_did(repository, capsys):
    (repository / "false.tex").write_text(WRONG)
    (repository / "folder").mkdir()
    (repository / "folder" / "reads.tex").write_text(RIGHT.replace("+", r"\input{sign}"))
    (repository / "folder" / "sign.tex").write_text("+")
    commit()
    assert main(["review", "--since", "HEAD"]) == 0
    assert capsys.readouterr().out == "no paper has changed since HEAD\n"
    (repository / "folder" / "sign.tex").write_text("-")
    assert main(["review", "--since", "HEAD"]) == 1
    out = capsys.readouterr().out
    assert out.startswith("folder/reads.tex: 1 refuted\n") and "false.tex" not in out
    commit()
    (repository / "false.kc").write_text('"moves by" %kc: law\n')
    assert main(["review", "--since", "HEAD"]) == 1
    assert capsys.readouterr().out.startswith("false.tex: 1 refuted")


@pytest.mark.slow
@pytest.mark.parametrize("before", ["HEAD", "0" * 40])
def test_before_the_first_commit_all_has_changed(repository, before):
    (repository / "paper.tex").write_text(WRONG)
    assert main(["review", "--since", before]) == 1


@pytest.mark.slow
def test_nothing_and_what_cannot_be_read_are_no_success(repository, capsys):
    assert main(["review"]) == 6
    (repository / "paper.tex").write_text("\\documentclass{article}\n")
    assert main(["review"]) == 6
    assert main(["review", "paper.tex", "absent.tex"]) == 2
    assert "absent.tex" in capsys.readouterr().out
    for words in (["--since", "main~7"], ["--since=--output=x"], ["--update"]):
        assert main(["review", *words]) == 2
    (repository / "noise.tex").write_bytes(b"\0")
    assert main(["review", "noise.tex", "--baseline", "new.json", "--update"]) == 2
    assert not (repository / "new.json").exists()
    (repository / "known.json").write_text("[]")
    assert main(["review", "--baseline", "known.json"]) == 2
    assert "--update" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("counts", "says"),
    [
        ({"proved": 2, "conditional": 1}, "formulas: 3 proved"),
        ({"proved": 2, "refuted": 1, "timeout": 1}, "formulas: 2 proved, 1 false, 1 open"),
        ({}, "formulas: no claims"),
    ],
)
def test_a_badge_says_how_the_claims_stand(counts, says):
    assert ElementTree.fromstring(badge(counts)).get("aria-label") == says
