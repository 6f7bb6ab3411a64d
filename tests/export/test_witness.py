"""A program that is asked to confirm certificates: its answers, its silence, its absence."""

import json

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.export.witness import answer
from kowalevski_cas.verify.committed import certificate_files


def test_a_missing_program_is_named_with_what_installs_it(small, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert main(["witness", "rocq", str(small), "-o", str(tmp_path / "out")]) == 2
    assert "coqc or rocq is not installed" in (err := capsys.readouterr().err)
    assert "apt-get install coq" in err
    assert not (tmp_path / "out").exists()


def test_silence_confirms_nothing(small, tmp_path, program, capsys):
    program("coqc", 'case "$1" in --version) echo Rocq 0;; esac')
    assert main(["witness", "rocq", str(small), "-o", str(tmp_path)]) == 5
    out, err = capsys.readouterr()
    assert "kharlamov2002: 0 of 4 certificates confirmed by Rocq 0" in out
    assert "eq21: not confirmed: the theorems are not closed" in err
    (path,) = tmp_path.glob("*/rocq.json")
    said = json.loads(path.read_text(encoding="utf-8"))
    # the point of eq21 may have square roots, which Rocq does not read
    assert not said["confirmed"] and {*said["failed"]} - {"eq21"} == {
        "corrected/eq21",
        "eq6",
        "eq7",
    }


def test_a_program_that_does_not_run(small, tmp_path, program, capsys):
    program("coqc", "echo no library; exit 3")
    assert main(["witness", "rocq", str(small), "-o", str(tmp_path)]) == 2
    assert "no library" in capsys.readouterr().err


def test_a_rejected_certificate_is_not_exported(small, tmp_path, capsys):
    path = certificate_files(small)[-1]
    path.write_text(path.read_text(encoding="utf-8").replace("2", "3", 1), encoding="utf-8")
    assert main(["export", "rocq", str(small), "-o", str(tmp_path / "out")]) == 5
    assert path.name in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_no_certificates(small, tmp_path, capsys):
    for path in certificate_files(small):
        path.unlink()
    (small / "record.json").unlink()
    assert main(["export", "rocq", str(small), "-o", str(tmp_path / "out")]) == 6
    assert "no claim of" in capsys.readouterr().err


@pytest.mark.parametrize("home", [None, "", "/somewhere"])
def test_a_program_has_a_home(home, tmp_path, monkeypatch):
    if home is None:
        monkeypatch.delenv("HOME", raising=False)
    else:
        monkeypatch.setenv("HOME", home)
    code, said = answer(["sh", "-c", 'echo "$HOME"'], tmp_path)
    assert (code, said.strip()) == (0, home or str(tmp_path))
