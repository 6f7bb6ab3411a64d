"""What is to be looked at: where it stands, what mends it, and how it is known again."""

import json
import shutil
import subprocess
from pathlib import Path

import pytest
from sarif_pydantic import Sarif

from kowalevski_cas.audit.diagnostics import _with_fingerprints, diagnostics
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.cli import main
from kowalevski_cas.cli.formats import github, sarif
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import read_source
from kowalevski_cas.verify.diagnostic import ERROR, NOTE, RULES, Diagnostic, Region, Replacement

BODY = r"""The Euler equations of a free body are
\begin{equation}\label{euler}
A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq.
\end{equation}
The energy
\begin{equation}\label{energy}
  2T=Ap^2+Bq^2-Cr^2
\end{equation}
is a first integral, and so is the momentum
%kc: claim integral
\begin{equation}\label{momentum}
  G^2=A^2p^2-B^2q^2
     +C^2r^2.
\end{equation}
"""
HEAD, END = "\\documentclass{article}\n\\begin{document}\n", "\\end{document}\n"


def found(path: Path) -> list[Diagnostic]:
    """What is to be looked at in a paper that is its own derivation."""
    return diagnostics(audit_reading(ReadingSession(read(read_source(path)))))


@pytest.fixture
def paper(tmp_path, monkeypatch, here):
    """A paper of this text, in a folder of its own."""
    monkeypatch.chdir(tmp_path)

    def write(text: str) -> Path:
        path = Path("top.tex")
        path.write_text(text, encoding="utf-8")
        return path

    return write


def text_at(region: Region) -> str:
    lines = Path(region.path).read_text(encoding="utf-8").splitlines(keepends=True)
    inside = lines[region.line - 1 : region.end_line]
    inside[-1] = inside[-1][: region.end_column - 1]
    return "".join(inside)[region.column - 1 :]


def mend(fixes: list[Replacement]) -> None:
    """Put what belongs there into the files, from the end to the beginning."""
    for region, text in sorted(fixes, reverse=True):
        path = Path(region.path)
        lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
        start = sum(map(len, lines[: region.line - 1])) + region.column - 1
        end = sum(map(len, lines[: region.end_line - 1])) + region.end_column - 1
        whole = "".join(lines)
        path.write_text(whole[:start] + text + whole[end:], encoding="utf-8")


@pytest.mark.slow
def test_they_stand_where_the_formula_does(paper):
    energy, momentum = found(paper(HEAD + BODY + END))
    assert (energy.rule, energy.level, energy.id) == ("refuted", ERROR, "energy")
    assert text_at(energy.region) == "2T=Ap^2+Bq^2-Cr^2"
    assert text_at(momentum.region).split() == ["G^2=A^2p^2-B^2q^2", "+C^2r^2"]


@pytest.mark.slow
def test_what_mends_them_mends_the_paper(paper):
    path = paper(HEAD + BODY + END)
    mend([fix for one in found(path) for fix in one.fixes])
    assert found(path) == []


@pytest.mark.slow
def test_they_stand_in_the_file_that_prints_the_formula(paper):
    Path("part.tex").write_text(BODY)
    path = paper(f"{HEAD}{{\\it An example.}} \\input{{part}} Done.\n{END}")
    energy, momentum = found(path)
    assert energy.region.path == momentum.region.path == "part.tex"
    assert text_at(energy.region) == "2T=Ap^2+Bq^2-Cr^2"
    mend([fix for one in (energy, momentum) for fix in one.fixes])
    assert "part" in path.read_text() and found(path) == []


@pytest.mark.slow
def test_they_are_known_again_wherever_they_stand(paper):
    before = [one.fingerprint for one in found(paper(HEAD + BODY + END))]
    moved = [one.fingerprint for one in found(paper(f"{HEAD}More words.\n\n{BODY} Words.{END}"))]
    assert moved == before and len({*before}) == 2


@pytest.mark.slow
def test_another_misprint_in_the_same_place_is_another(paper):
    before = {one.fingerprint for one in found(paper(HEAD + BODY + END))}
    other = found(paper(HEAD + BODY.replace("2T=Ap^2", "2T=-Ap^2") + END))
    assert len({one.fingerprint for one in other} & before) == 1


def test_the_same_misprint_once_more_is_another():
    one = Diagnostic("refuted", ERROR, "eq1", "", Region("top.tex"))
    prints = [found.fingerprint for found in _with_fingerprints([(one, "x=y"), (one, "x=y")])]
    assert len({*prints}) == 2


# -- formats ---------------------------------------------------------------------------------


def document(capsys, *words: str) -> dict:
    main(words)
    return json.loads(capsys.readouterr().out)


def unknown(model) -> set[str]:
    """The keys of a model of SARIF, and of those in it, that SARIF has not."""
    keys = {*(model.model_extra or ())}
    for name in type(model).model_fields:
        value = getattr(model, name)
        for one in value if isinstance(value, list) else [value]:
            keys |= unknown(one) if hasattr(one, "model_extra") else set()
    return keys


@pytest.mark.slow
def test_sarif_has_places_fixes_and_fingerprints(paper, capsys):
    value = document(capsys, "audit", str(paper(HEAD + BODY + END)), "--format", "sarif")
    assert unknown(Sarif.model_validate(value)) <= {"columnKind", "ruleIndex"}
    energy, _ = value["runs"][0]["results"]
    place = energy["locations"][0]["physicalLocation"]
    assert place == {
        "artifactLocation": {"uri": "top.tex"},
        "region": {"startLine": 9, "startColumn": 3, "endLine": 9, "endColumn": 20},
    }
    (replacement,) = energy["fixes"][0]["artifactChanges"][0]["replacements"]
    assert replacement["deletedRegion"]["startColumn"] == 15
    assert replacement["insertedContent"] == {"text": "+"}
    assert len(energy["partialFingerprints"][sarif.FINGERPRINT]) == 32


def test_sarif_of_a_run(tmp_path, monkeypatch, capsys, here):
    monkeypatch.chdir(tmp_path)
    system = r'circle = System(r"\dot x=y, \dot y=-x"); circle.integral("x^2-y^2")'
    Path("circle.py").write_text(f"from kowalevski_cas import System\n{system}\n")
    value = document(capsys, "verify", "circle.py", "--format", "sarif")
    different, refuted = value["runs"][0]["results"]
    assert (different["ruleId"], different["level"]) == ("different", ERROR)
    assert (refuted["ruleId"], refuted["level"]) == ("refuted", NOTE)
    region = {"startLine": 2}
    assert refuted["locations"][0]["physicalLocation"]["region"] == region


def test_links_to_help_are_those_of_the_project(monkeypatch):
    def driver():
        return json.loads(sarif.log([]))["runs"][0]["tool"]["driver"]

    pages = {"Repository": "https://example.org/x", "Documentation": "https://example.org/docs"}
    monkeypatch.setattr(sarif, "url", lambda name: "")
    assert not any("helpUri" in rule for rule in driver()["rules"])
    monkeypatch.setattr(sarif, "url", pages.get)
    assert driver()["informationUri"] == "https://example.org/x"
    links = {rule["id"]: rule["helpUri"] for rule in driver()["rules"]}
    assert links["refuted"] == "https://example.org/docs/formats/#refuted"


def test_every_rule_has_its_help_in_the_documentation():
    page = (Path(__file__).parents[2] / "docs" / "formats.md").read_text(encoding="utf-8")
    assert [rule for rule in RULES if f"\n### {rule}\n" not in page] == []


@pytest.mark.slow
def test_microsofts_validator_accepts_it(paper, capsys, tmp_path):
    tool = shutil.which("sarif-multitool")
    if tool is None:
        pytest.skip("sarif-multitool is not installed: npm install -g @microsoft/sarif-multitool")
    value = document(capsys, "audit", str(paper(HEAD + BODY + END)), "--format", "sarif")
    Path("found.sarif").write_text(json.dumps(value))
    done = subprocess.run([tool, "validate", "found.sarif"], capture_output=True, text=True)
    assert "successfully" in done.stdout and ": error" not in done.stdout


def test_an_annotation_has_columns_if_it_stands_on_one_line():
    one = Diagnostic("refuted", ERROR, "a:1,2", "it is\nnot 50%", Region("p,q.tex", 3, 2, 3, 9))
    assert github.workflow_commands([one]) == (
        "::error file=p%2Cq.tex,line=3,col=2,endColumn=9,title=a%3A1%2C2::it is%0Anot 50%25\n"
    )
    several = one._replace(region=Region("p.tex", 3, 2, 5, 9), level=NOTE, id="a", message="")
    assert github.workflow_commands([several]) == "::notice file=p.tex,line=3,endLine=5,title=a::\n"
