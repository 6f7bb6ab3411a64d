"""Every document of JSON is what the schema of its format says."""

import json
from itertools import islice
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator
from jsonschema.exceptions import ValidationError

from kowalevski_cas.cli import main
from kowalevski_cas.export import witness
from kowalevski_cas.library import available, find
from kowalevski_cas.schema import VERSIONS, head, schema

PAPER = r"""\documentclass{article}\begin{document}
\begin{equation}\label{law}\dot x=y,\quad \dot y=-x.\end{equation}
The energy
\begin{equation}\label{energy}h=x^2-y^2\end{equation}
is a first integral, and so is
\begin{equation}\label{other}k=x^2+y^2+\end{equation}
\end{document}
"""
SYSTEM = r"""
from kowalevski_cas import System
circle = System(r"\dot x=y, \dot y=-x")
circle.integral("x^2-y^2")
"""


@pytest.fixture(scope="module")
def validator():
    Draft202012Validator.check_schema(schema())
    return Draft202012Validator(schema())


@pytest.fixture
def written(tmp_path, monkeypatch, capsys):
    """What a command prints as JSON, in a folder with a paper and a system."""
    monkeypatch.chdir(tmp_path)
    Path("paper.tex").write_text(PAPER)
    Path("circle.py").write_text(SYSTEM)

    def document(*words):
        main(words)
        return json.loads(capsys.readouterr().out)

    return document


def begins(document):
    name = document["format"].removeprefix("kowalevski-cas ")
    return head(name).items() <= document.items()


def test_the_schema_has_every_format_in_its_version():
    for name in VERSIONS:
        properties = schema()["$defs"][name]["properties"]
        assert {key: properties[key]["const"] for key in ("format", "version")} == head(name)


@pytest.mark.parametrize(
    "words",
    [
        ("verify", "circle.py", "--format", "json"),
        ("audit", "paper.tex", "--alone", "--format", "json"),
        ("audit", "paper.tex", "--list", "--format", "json"),
        ("find", "integrals", "circle.py", "--degree", "2", "--format", "json"),
    ],
)
def test_what_a_command_prints(validator, written, words):
    document = written(*words)
    validator.validate(document)
    assert begins(document)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["clebsch", "monopole"])
def test_an_audit_of_a_whole_paper(validator, written, name):
    paper = Path(__file__).parent / "data" / "papers" / f"{name}.tex"
    validator.validate(written("audit", str(paper), "--timeout", "1", "--format", "json"))


def test_a_motion(validator, written):
    pytest.importorskip("numpy")
    words = "--a 1 --b 0.4 --m 0.8 --l 0.9 --until 1 --samples 3 --format json".split()
    validator.validate(written("motion", *words))
    validator.validate(written("motion", *words, "--method", "ball"))
    validator.validate(written("motion", *words, "--frequencies", "--attitude"))


def test_the_list_of_pictures(validator):
    pytest.importorskip("matplotlib")
    from kowalevski_cas.cli.pictures import _figures
    from kowalevski_cas.motion import Motion, Parameters

    validator.validate(json.loads(_figures(Motion(Parameters.of(1, "0.4", "0.8", "0.9")))))


def test_what_is_committed(validator):
    for name in available():
        folder = find(name)
        validator.validate(json.loads((folder / "record.json").read_text(encoding="utf-8")))
        for path in islice(sorted((folder / "certificates").rglob("*.json")), 0, None, 25):
            validator.validate(json.loads(path.read_text(encoding="utf-8")))


def test_what_another_program_confirms(validator):
    said = witness.Testimony("pari", "GP 2.15", {"eq6": "6" * 64}, {"eq7": "exit code 1"})
    validator.validate(json.loads(said.text()))


def test_the_facts_behind_a_report(validator, run):
    from kowalevski_cas.report.pdf import facts

    validator.validate(json.loads(facts(run, {}, ())))


@pytest.mark.parametrize(
    "change",
    [
        {"format": "kowalevski-cas else"},
        {"version": 2},
        {"claims": None},
        {"more": 1},
        {"claims": [{"id": "eq1"}]},
    ],
)
def test_another_document_is_refused(validator, change):
    record = json.loads((find(available()[0]) / "record.json").read_text(encoding="utf-8"))
    validator.validate(record)
    with pytest.raises(ValidationError):
        validator.validate(record | change)
