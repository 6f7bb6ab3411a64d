"""Files appear whole or not at all."""

import os
import stat
from pathlib import Path

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.files import read, read_json, write, write_all
from kowalevski_cas.problem.checker import command


def failing(monkeypatch, name, error, at=1):
    """Let the function ``name`` of ``os`` raise an error when it is called for the ``at``-th time."""
    original, calls = getattr(os, name), []

    def function(*arguments):
        calls.append(arguments)
        if len(calls) == at:
            raise error
        return original(*arguments)

    monkeypatch.setattr(os, name, function)


def test_text_and_bytes_are_written_and_readable_by_others(tmp_path):
    path = tmp_path / "new" / "folder" / "a.txt"
    write(path, "ωα\n")
    assert path.read_bytes() == "ωα\n".encode()
    write(path, b"\x00\xff\r\n")
    assert path.read_bytes() == b"\x00\xff\r\n"
    assert stat.S_IMODE(path.stat().st_mode) == 0o644
    assert list(path.parent.iterdir()) == [path]


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), KeyboardInterrupt()])
@pytest.mark.parametrize("name", ["chmod", "replace"])
def test_what_fails_leaves_the_file_as_it_was_and_no_other(tmp_path, monkeypatch, name, error):
    path = tmp_path / "a.txt"
    write(path, "before")
    failing(monkeypatch, name, error)
    with pytest.raises(type(error)):
        write(path, "after")
    assert path.read_text() == "before" and list(tmp_path.iterdir()) == [path]


def test_the_error_names_the_file_and_the_reason(tmp_path):
    (tmp_path / "file").write_text("kept")
    with pytest.raises(OSError) as caught:
        write(tmp_path / "file" / "a.txt", "text")
    assert caught.value.filename == str(tmp_path / "file" / "a.txt")
    assert caught.value.strerror.startswith("cannot be written: ")


def test_of_several_files_all_appear_or_none(tmp_path, monkeypatch):
    old, new, last = (tmp_path / name for name in ("old", "new", "last"))
    write(old, "before")
    failing(monkeypatch, "replace", KeyboardInterrupt(), at=3)
    with pytest.raises(KeyboardInterrupt):
        write_all({old: "after", new: b"new", last: "last"})
    assert old.read_text() == "before" and list(tmp_path.iterdir()) == [old]
    write_all({old: "after", new: b"new", last: "last"})
    assert [path.read_text() for path in (old, new, last)] == ["after", "new", "last"]


def made(path, kind):
    """What stands at a path in the place of a file."""
    {
        "pipe": lambda: os.mkfifo(path),
        "device": lambda: path.symlink_to("/dev/zero"),
        "folder": path.mkdir,
        "nothing": lambda: None,
        "circle": lambda: path.symlink_to(path),
        "noise": lambda: path.write_bytes(b"\xff\x00"),
        "brackets": lambda: path.write_text("[" * 100_000 + "]" * 100_000),
        "half": lambda: path.write_text('{"version": 2, '),
    }[kind]()
    return path


KINDS = ("pipe", "device", "folder", "nothing", "circle", "noise", "brackets", "half")


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_no_file_of_json_is_an_error_and_nobody_waits(kind, tmp_path):
    path = made(tmp_path / "a.json", kind)
    with pytest.raises((OSError, ValueError)):
        read_json(path)
    if kind in KINDS[:6]:
        with pytest.raises((OSError, ValueError)):
            read(path)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_a_spoiled_certificate_is_proved_anew_and_rejected_by_the_checker(
    kind, tmp_path, capsys, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    Path("circle.py").write_text(
        'from kowalevski_cas import System\nSystem(r"\\dot x=y, \\dot y=-x").integral("x^2+y^2")\n'
    )
    assert main(["record", "circle.py"]) == 0
    (path,) = Path("circle.evidence/certificates").glob("*.json")
    path.unlink()
    made(path, kind)
    assert main(["verify", "circle.py"]) == 0
    assert main(["check", "circle.py"]) == 5
    assert command.main([str(path)]) == 5
    assert "REJECTED" in capsys.readouterr().out
    record = Path("circle.evidence/record.json")
    record.unlink()
    made(record, kind)
    if kind not in ("nothing", "circle"):
        assert main(["verify", "circle.py"]) == 2
        assert "the record cannot be read" in capsys.readouterr().err
    if kind != "folder":
        assert main(["record", "circle.py"]) == 0
        assert main(["verify", "circle.py"]) == 0
