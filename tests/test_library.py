"""Derivations are found by name or by path, and loaded from their folders."""

import os
import sys
from pathlib import Path

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.library import LibraryError, available, find, library, load


def test_the_library_has_the_paper():
    assert "kharlamov2002" in available()
    assert find("kharlamov2002") == library() / "kharlamov2002"
    assert load("kharlamov2002").author == "M. P. Kharlamov"


def test_a_path_is_as_good_as_a_name():
    assert load(str(library() / "kharlamov2002")).name == "kharlamov2002"


def test_a_file_is_found_without_its_ending(tmp_path, monkeypatch):
    (tmp_path / "circle.py").write_text("")
    monkeypatch.chdir(tmp_path)
    assert find("circle") == find("circle.py") == Path("circle.evidence")


@pytest.mark.slow
def test_scenes_have_names_to_be_typed_on_a_command_line():
    scenes = [scene.name for name in available() for scene in load(name).scenes()]
    assert [name for name in scenes if {*name} & {*"$\\"}] == []


def test_what_is_loaded_twice_is_loaded_anew(tmp_path):
    initial = tmp_path / "__init__.py"
    source = "from kowalevski_cas.paper.derivation import Derivation\nderivation = Derivation({!r}, '', '', '', ())\n"
    initial.write_text(source.format("first"))
    assert load(str(tmp_path)).name == "first"
    initial.write_text(source.format("the second"))
    assert load(str(tmp_path)).name == "the second"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "{file} states nothing: make a System(...), or define `derivation = Derivation(...)`"),
        ("1 +", "{file}:1: SyntaxError: invalid syntax"),
        ("x = 1\nx.y", "{file}:2: AttributeError: 'int' object has no attribute 'y'"),
        ("from . import nothing", "{file}:1: ImportError"),
        ("import sys\nsys.exit()", "{file}:2: SystemExit"),
        ("\nint('a')", "{file}:2: invalid literal for int()"),
        ("class Stop(BaseException): ...\nraise Stop", "{file}:2: Stop"),
        ("import os\nos._exit(0)", "{file}:2: os._exit would end the program: leave it out"),
        ("import ctypes\nctypes.CDLL(None)._exit(0)", "{file}:2: _exit would end the program"),
        ("import os\nos.abort()", "{file}:2: os.abort would end"),
        ("import os\nos.execvp('true', ['true'])", "{file}:2: os.execv would end"),
        ("from os import *\nfrom os import _exit\n_exit(0)", "{file}:3: os._exit would end"),
    ],
)
def test_the_message_names_file_and_line(tmp_path, text, message):
    initial = tmp_path / "__init__.py"
    initial.write_text(text)
    with pytest.raises(LibraryError) as raised:
        load(str(tmp_path))
    assert str(raised.value).startswith(message.format(file=initial))
    assert os._exit.__module__ == "posix"


def test_a_process_that_a_derivation_begins_may_end(tmp_path):
    file = tmp_path / "forks.py"
    file.write_text(
        "import os\nfrom kowalevski_cas import System\n"
        "if not (child := os.fork()):\n    os._exit(7)\n"
        "assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7\n"
        'System("\\\\dot x=x").integral("x")\n'
    )
    assert len(load(str(file)).claims) == 1


COMMANDS = [
    "verify", "record", "report", "check", "certificates", "bundle -o out", "find integrals",
    "export -o out rocq",
]  # fmt: skip


@pytest.mark.parametrize("command", COMMANDS)
def test_a_derivation_that_ends_the_program_is_an_error_of_every_command(
    command, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    Path("dead.py").write_text("import os\nos._exit(0)\n")
    assert main([*command.split(), "dead.py"]) == 2
    assert "dead.py:2: os._exit would end the program" in capsys.readouterr().err


@pytest.mark.slow
def test_nor_does_it_later_in_a_thread(tmp_path, capsys):
    file = tmp_path / "late.py"
    file.write_text(
        "import os, threading\nfrom kowalevski_cas import System\n"
        'System("\\\\dot x=x").integral("x")\n'
        "threading.Timer(0.2, os._exit, (0,)).start()\n"
    )
    assert main(["verify", str(file)]) == 1
    assert "os._exit would end the program" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["euler1758", ""])
def test_what_is_not_there_is_said_with_what_is(name):
    with pytest.raises(
        LibraryError, match=f"there is no derivation “{name}”; the library has: .*kharlamov2002"
    ):
        find(name)


def test_a_file_is_no_derivation(tmp_path):
    file = tmp_path / "paper.txt"
    file.write_text("")
    with pytest.raises(LibraryError, match=r"is no derivation: a Python file is expected"):
        find(str(file))


def test_a_paper_and_a_module_do_not_share_what_is_kept_of_them(tmp_path):
    paper, module = tmp_path / "top.tex", tmp_path / "top.py"
    paper.write_text("$x=1$")
    assert find(str(paper)) == tmp_path / "top.evidence"
    module.write_text("")
    with pytest.raises(LibraryError, match=r"share one folder: rename one"):
        find(str(paper))


BELOW = """
from kowalevski_cas.paper.derivation import Derivation, Section
section = Section("1", "")
law = section.display("law", r"x=x")
derivation = Derivation("below", "", "", "", (section,))
"""

ABOVE = """
from kowalevski_cas.paper.derivation import Derivation
from ..{below} import derivation as below
derivation = Derivation("above", "", "", "", (), rests_on=(below,))
"""


def test_a_derivation_rests_on_one_beside_it_or_in_the_library(tmp_path):
    for name, source in {"below": BELOW, "above": ABOVE.format(below="below")}.items():
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text(source)
    (below,) = load(str(tmp_path / "above")).rests_on
    assert [display.id for display in below.displays()] == ["law"]
    (tmp_path / "above" / "__init__.py").write_text(ABOVE.format(below="kharlamov2002") + "\n")
    (below,) = load(str(tmp_path / "above")).rests_on
    assert below.name == "kharlamov2002"


def test_what_it_rests_on_and_is_not_there_is_an_error(tmp_path):
    (tmp_path / "__init__.py").write_text(ABOVE.format(below="euler1758"))
    with pytest.raises(LibraryError, match=r"__init__\.py:3: ModuleNotFoundError: .*euler1758"):
        load(str(tmp_path))


@pytest.mark.parametrize("saved", ["circle.py", "circle/__init__.py", "circle/section1.py"])
def test_what_is_loaded_is_what_was_saved_last(tmp_path, monkeypatch, saved):
    """Also if it is saved twice in a second, with the same number of letters."""
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    said = "from kowalevski_cas import System\nsystem = System(r'{}')\n"
    file = tmp_path / saved
    file.parent.mkdir(exist_ok=True)
    (file.parent / "__init__.py").write_text("from .section1 import system\n")
    titles = []
    for field in (r"\dot x=y,\dot y=-x", r"\dot u=v,\dot v=-u"):
        file.write_text(said.format(field))
        os.utime(file, (1, 1))
        titles.append(load(str(tmp_path / saved.split("/")[0])).sections[0].title)
    assert "$x$" in titles[0] and "$u$" in titles[1]


def test_what_is_loaded_together_is_executed_once_and_a_namesake_is_another(tmp_path):
    for name, source in {"below": BELOW, "above": ABOVE.format(below="below")}.items():
        for place in (tmp_path / "here", tmp_path / "there"):
            (place / name).mkdir(parents=True)
            (place / name / "__init__.py").write_text(source)
    here, there = (str(tmp_path / place / "below") for place in ("here", "there"))
    for names in (["below", "above"], ["above", "below"]):
        one, other = (load(str(tmp_path / "here" / n), anew=n == names[0]) for n in names)
        below, above = (one, other) if names[0] == "below" else (other, one)
        assert above.rests_on == (below,)
    assert load(here, anew=False) is below
    assert load(there, anew=False) is not below
    assert load(there) is not load(there)
