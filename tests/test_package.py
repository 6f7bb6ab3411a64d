"""What is released: a wheel, a source distribution, an action and a hook, each tried where nothing else is."""

import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path
from venv import EnvBuilder

import pytest
import yaml

ROOT = Path(__file__).parents[1]
PAPER = r"""\documentclass{article}
\begin{document}
The oscillator moves by
\[\dot x=v,\quad \dot v=-x.\]
The energy $H=\frac12(v^2-x^2)$ is a first integral.
\end{document}
"""

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The folder with the wheel and the source distribution, built from what git knows."""
    folder = tmp_path_factory.mktemp("dist")
    words = [sys.executable, "-m", "build", "--outdir", folder, ROOT]
    subprocess.run(words, check=True, capture_output=True)
    return folder


@pytest.fixture
def python(tmp_path):
    """The Python of a new environment, which sees the libraries that are here and not the package."""
    EnvBuilder(symlinks=True, with_pip=True).create(tmp_path / "venv")
    python = tmp_path / "venv" / "bin" / "python"
    where = [python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    libraries = Path(subprocess.run(where, check=True, capture_output=True, text=True).stdout[:-1])
    (libraries / "zz.pth").write_text(sysconfig.get_path("purelib"))
    return python


@pytest.fixture
def repository(tmp_path):
    """An empty repository with a paper."""
    folder = tmp_path / "repository"
    folder.mkdir()
    (folder / "paper.tex").write_text(PAPER)
    subprocess.run(["git", "init", "-q", folder], check=True)
    return folder


def install(python, *words):
    """Install into an environment, of the libraries nothing."""
    pip = [python, "-m", "pip", "install", "-q", "--no-deps", "--force-reinstall", *words]
    subprocess.run(pip, check=True, capture_output=True)


def ran(words, folder, python, **environment):
    """What a command prints in a folder, and its exit code; the programs of an environment are found."""
    path = f"{python.parent}:{os.environ['PATH']}"
    done = subprocess.run(
        words, cwd=folder, env=os.environ | {"PATH": path} | environment, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )  # fmt: skip
    return done.stdout, done.returncode


def evaluated(text, values):
    """A text of an action with the values of its expressions."""
    return re.sub(r"\$\{\{ *([\w.-]+) *\}\}", lambda match: values[match[1]], text)


def test_the_wheel_works_where_nothing_else_is(built, python, tmp_path):
    (wheel,) = built.glob("*.whl")
    names = zipfile.ZipFile(wheel).namelist()
    assert {"kowalevski_cas/py.typed", "kowalevski_cas/schema.json"} <= {*names}
    assert not any(name.startswith(("tests/", "study/", "derivations/")) for name in names)
    install(python, wheel)
    program = str(python.with_name("kowalevski-cas"))
    out, code = ran([program, "verify", "kharlamov2005"], tmp_path, python)
    assert code == 0, out
    out, code = ran([program, "check", "-q", "kharlamov2005"], tmp_path, python)
    assert code == 0 and "CERTIFIED" in out


def test_the_source_distribution_is_whole(built, python, tmp_path):
    (archive,) = built.glob("*.tar.gz")
    with tarfile.open(archive) as file:
        file.extractall(tmp_path, filter="data")
    folder = tmp_path / archive.name.removesuffix(".tar.gz")
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True).stdout
    files = {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}
    assert {*listed.splitlines()} - files <= {".gitignore"}
    words = [python, "-m", "pytest", "-q", "-n0", "-m", "not slow", "-p", "no:cacheprovider"]
    chosen = [
        "tests/test_imports.py",
        "tests/test_library.py",
        "tests/test_readme.py",
        "tests/problem/test_checker.py",
    ]
    out, code = ran([*words, *chosen], folder, python)
    assert code == 0, out


def test_the_action_marks_and_fails_in_an_empty_repository(built, python, repository):
    (wheel,) = built.glob("*.whl")
    action = yaml.safe_load((ROOT / "action.yml").read_text())
    inputs = {name: one["default"] for name, one in action["inputs"].items()}
    inputs |= {"package": str(wheel), "badge": "badge.svg"}
    values = {f"inputs.{name}": value for name, value in inputs.items()}
    values["github.action_path"] = str(ROOT)
    for step in (one for one in action["runs"]["steps"] if "run" in one):
        environment = {key: evaluated(text, values) for key, text in step["env"].items()}
        bash = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
        out, code = ran(bash, repository, python, PIP_NO_DEPS="1", **environment)
        assert code == (1 if step["name"] == "Audit" else 0), out
    assert out.startswith("::error file=paper.tex,line=5,")
    assert "1 false" in (repository / "badge.svg").read_text()


def test_the_hook_fails_on_what_was_changed(built, python, repository):
    (wheel,) = built.glob("*.whl")
    install(python, wheel)
    (hook,) = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text())
    assert re.search(hook["files"], "paper.tex")
    git = ["git", "-C", repository, "-c", "user.name=a", "-c", "user.email=a@b"]
    subprocess.run([*git, "commit", "-q", "--allow-empty", "-m", "empty"], check=True)
    out, code = ran(shlex.split(hook["entry"]), repository, python)
    assert code == 1 and "paper.tex" in out
    subprocess.run([*git, "add", "."], check=True)
    subprocess.run([*git, "commit", "-q", "-m", "paper"], check=True)
    out, code = ran(shlex.split(hook["entry"]), repository, python)
    assert code == 0, out
