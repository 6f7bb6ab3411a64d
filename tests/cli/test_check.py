import json
import re
import shutil
import subprocess
import sys

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.library import available, find
from kowalevski_cas.verify.committed import certificate_files
from tests.problem.tampering import seal
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("here")

PAPER = find("kharlamov2002")


@pytest.fixture
def copy(tmp_path):
    """A derivation with three of its certificates."""
    folder = tmp_path / "copied"
    shutil.copytree(PAPER, folder)
    record = json.loads((folder / "record.json").read_text())
    kept = ("eq6", "eq7", "eq14")
    record["claims"] = {claim: record["claims"][claim] for claim in kept}
    (folder / "record.json").write_text(json.dumps(record))
    for path in certificate_files(folder):
        if path.stem not in kept:
            path.unlink()
    return folder


@pytest.mark.slow
def test_a_run_with_a_report_checks_them_as_make_verify_does(copy, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("kowalevski_cas.report.pdf.has_latex", lambda: False)  # Typst is faster
    makefile = (PAPER.parents[1] / "Makefile").read_text(encoding="utf-8")
    assert "\t@$(RUN) verify --arithmetic all --report reports\n" in makefile
    arguments = ["verify", str(copy), "--only", "eq14"]
    arguments += ["--report", str(tmp_path / "out")]
    first, *others = certificate_files(copy)
    first.write_text("{}")
    assert main(arguments) == 5
    out = capsys.readouterr().out
    assert "REJECTED" in out
    assert f"certificates: CERTIFIED {len(others)} of {len(others) + 1}\n" in out


@pytest.mark.slow
def test_a_report_names_certificates_and_no_link_breaks_where_it_is_sent_alone(
    tmp_path, monkeypatch
):
    monkeypatch.setattr("kowalevski_cas.report.pdf.has_latex", lambda: False)
    out = tmp_path / "far" / "out"
    assert main(["verify", str(PAPER), "--only", "redundant-integral", "--report", str(out)]) == 0
    page = (out / "kharlamov2002.html").read_text(encoding="utf-8")
    named = "redundant-integral.json"
    assert f"<code>{named}</code>" in page and (PAPER / "certificates" / named).is_file()
    assert all(link.startswith(("#", "https://")) for link in re.findall(r'href="([^"]+)"', page))


def test_all_committed_certificates_belong_to_the_record(capsys):
    assert main(["check", "--quiet", "bobenko_reyman_semenov1989"]) == 0
    number = len(certificate_files(find("bobenko_reyman_semenov1989")))
    assert capsys.readouterr().out == f"certificates: CERTIFIED {number} of {number}\n"


def test_a_line_says_what_is_proved_in_the_order_and_the_numbers_of_the_paper(
    copy, capsys, monkeypatch
):
    monkeypatch.setenv("COLUMNS", "500")
    assert main(["check", str(copy)]) == 0
    out = capsys.readouterr().out
    lines = out.splitlines()
    assert lines[0] == "✓   (6): the integral of Kowalevski's type: K = J₁² + J₂²"
    assert lines[1].startswith("✓   (7): the zero level of K is invariant; ")
    assert lines[2].startswith("✗   (14): the derivative of U₁ − U₂: d/dτ(U₁ − U₂) = [1/√(x₁x₂)]")
    assert lines[3].startswith("(✓) (14), corrected: d/dτ(U₁ − U₂) = √(x₁x₂)[")
    assert lines[4:] == ["certificates: CERTIFIED 4 of 4"]
    monkeypatch.setenv("COLUMNS", "60")
    main(["check", str(copy)])
    lines = capsys.readouterr().out.splitlines()
    assert {len(line) for line in lines[1:3]} == {60} and lines[1].endswith("…")


def test_it_says_all_of_it(copy, capsys):
    assert main(["check", "--full", str(copy)]) == 0
    out = capsys.readouterr().out
    assert out.startswith("eq6: D(") and "\n  D(J_1 ^ 2 + J_2 ^ 2) = 0\n" in out
    assert "    variables: " in out and "    field: " in out and "    point: " in out
    with pytest.raises(SystemExit):
        main(["check", "--full", "-q", str(copy)])


def test_an_old_certificate_says_how_to_renew_it(copy, capsys):
    path = copy / "certificates" / "eq6.json"
    data = json.loads(path.read_text())
    path.write_text(json.dumps(data | {"version": 1}))
    assert main(["check", "-q", str(copy)]) == 5
    words = "it is a certificate of format 1: make certificates renews it"
    assert f"REJECTED {path}: {words}\n" in capsys.readouterr().out


def test_a_stale_certificate(copy, capsys):
    record = json.loads((copy / "record.json").read_text())
    record["claims"]["eq6"]["statement"] = "0123456789abcdef"
    (copy / "record.json").write_text(json.dumps(record))
    assert main(["check", "-q", str(copy)]) == 5
    rejected, last = capsys.readouterr().out.splitlines()
    assert rejected.startswith("REJECTED ") and "eq6.json" in rejected and "statement" in rejected
    assert last == "certificates: CERTIFIED 3 of 4"


def test_a_claim_without_a_certificate_is_named(copy, capsys):
    record = json.loads((copy / "record.json").read_text())
    record["claims"]["eq7"]["verdict"] = "undecided"
    (copy / "record.json").write_text(json.dumps(record))
    (copy / "certificates" / "eq7.json").unlink()
    assert main(["check", "-q", str(copy)]) == 0
    assert capsys.readouterr().err == "without a certificate: eq7\n"


def test_a_record_that_cannot_be_read(copy, capsys):
    (copy / "record.json").write_text("{")
    assert main(["check", str(copy)]) == 2
    assert "record.json" in capsys.readouterr().err


@pytest.mark.slow
def test_files(copy, capsys):
    files = [str(path) for path in certificate_files(copy)]
    assert len(files) == 4
    assert main(["check", "-q", *files]) == 0
    assert main(["check", "-q", *files, files[0]]) == 5
    assert "certified before" in capsys.readouterr().out


def test_a_missing_certificate_is_rejected(copy, capsys):
    (copy / "certificates" / "corrected" / "eq14.json").unlink()
    assert main(["check", "-q", str(copy)]) == 5
    out = capsys.readouterr().out
    assert out == (
        "REJECTED corrected/eq14.json: it is in the record, and missing\n"
        "certificates: CERTIFIED 3 of 4\n"
    )


def test_files_of_derivations_with_claims_of_the_same_name(capsys):
    files = [find(name) / "certificates" / "eq10.1.json" for name in available()]
    assert main(["check", "-q", *(str(path) for path in files if path.exists())]) == 0
    assert capsys.readouterr().out == "certificates: CERTIFIED 2 of 2\n"


def test_no_certificates(copy, capsys):
    shutil.rmtree(copy / "certificates")
    (copy / "record.json").unlink()
    assert main(["check", str(copy)]) == 6
    assert capsys.readouterr().out == "certificates: CERTIFIED 0 of 0\n"


def test_a_derivation_that_is_not_there(capsys):
    assert main(["check", "nothing"]) == 2
    assert "no derivation" in capsys.readouterr().err


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "code"), sampled([(b"/nowhere/\xff.json", 5), (b"/nowhere/\xff", 2)], 1)
)
def test_a_name_that_is_no_text(name, code):
    command = [sys.executable, "-m", "kowalevski_cas", "check", name]
    found = subprocess.run(command, capture_output=True, cwd=PAPER.parents[1])
    assert found.returncode == code
    assert b"\\udcff" in found.stdout + found.stderr and b"Traceback" not in found.stderr


@pytest.mark.parametrize("place", sampled(["key", "name", "formula", "sign", "claim", "file"], 1))
def test_nothing_in_a_file_prints_a_line_of_its_own(copy, capsys, place):
    false = "x\nCERTIFIED 9 of 9\n"
    path = copy / "certificates" / "eq6.json"
    data = json.loads(path.read_text())
    if place == "key":
        data["spaces"][0][false] = []
    elif place == "name":
        data["spaces"][0]["variables"][0] = false
    elif place == "formula":
        data["evidence"] = [{"cofactors": [[false]]}]
    elif place == "file":
        path = path.rename(path.with_name(f"{false}.json"))
    else:
        data[place] = false
    path.write_text(json.dumps(data))
    for arguments in ([str(copy)], ["--full", str(path)]):
        assert main(["check", *arguments]) == 5
        lines = capsys.readouterr().out.splitlines()
        assert not [line for line in lines if line.startswith("CERTIFIED")]
        assert all(line.isprintable() for line in lines)
        assert sum(line.startswith("certificates: CERTIFIED") for line in lines) == 1


def test_a_triviality_under_the_name_of_a_claim_even_if_the_record_has_its_digest(copy, capsys):
    path = copy / "certificates" / "eq14.json"
    goal = {"goal": "follows", "space": 0, "given": [], "conclusions": [[["x", "x"]]]}
    point = {"roots": [], "values": [["x", 0]]}
    data = {"spaces": [{"variables": ["x"]}], "goals": [goal], "sign": "holds"}
    text = seal({**json.loads(path.read_text()), **data, "evidence": [{"point": point}]})
    path.write_text(text)
    record = json.loads((copy / "record.json").read_text())
    entry = {"statement": json.loads(text)["digest"], "verdict": "proved", "correction": None}
    record["claims"]["eq14"] = {**entry, "conditions": []}
    (copy / "record.json").write_text(json.dumps(record))
    (copy / "certificates" / "corrected" / "eq14.json").unlink()
    for named in (copy, path):
        assert main(["check", "-q", str(named)]) == 5
        out = capsys.readouterr().out
        assert f"REJECTED {path}: the derivation prints another statement of it" in out


def test_a_derivation_that_cannot_be_loaded(copy, capsys):
    (copy / "section1.py").write_text("1/0")
    for named in (copy, copy / "certificates" / "eq6.json"):
        assert main(["check", "-q", str(named)]) == 2
        assert "section1.py:1: ZeroDivisionError" in capsys.readouterr().err


def test_a_correction_among_several_formulas_is_shown_with_them_and_recorded(tmp_path, capsys):
    file = tmp_path / "saddle.py"
    file.write_text(
        "from kowalevski_cas import System\n"
        's = System(r"\\dot x=x, \\dot y=-y, \\dot z=x+y")\n'
        's.invariant("x=0", "z+2y=0")\n'
    )
    assert main(["record", str(file)]) == main(["check", "-q", str(file)]) == 0
    assert "CERTIFIED 2 of 2" in capsys.readouterr().out
    assert main(["verify", str(file)]) == 0
    assert "✓   x = 0, 2z + 2y = 0" in capsys.readouterr().out
