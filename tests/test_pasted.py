"""Every command of the README and of the documentation can be pasted into a clone."""

import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

HERE = Path(__file__).parents[1]
README = (HERE / "README.md").read_text(encoding="utf-8")
PAGES = [HERE / "README.md", *sorted((HERE / "docs").rglob("*.md"))]
TEXTS = [page.read_text(encoding="utf-8") for page in PAGES]
FILES = HERE / "tests" / "data" / "readme"

PROGRAMS = r"\.venv/bin/kowalevski-cas|kowalevski-cas|python3|mkdir|pip|make|dask"
LINES = [
    line for text in TEXTS for line in re.findall(rf"^    ((?:{PROGRAMS}) .*)$", text, re.MULTILINE)
]
COMMANDS = [re.sub(r" +# .*$", "", line) for line in LINES]

ELSEWHERE = re.compile(
    r"pip install|make |dask |.* --scheduler tcp://HOST"  # a machine of its own, or several
)
WITHIN = {
    page.stem: commands
    for page, text in zip(PAGES, TEXTS, strict=True)
    if (
        commands := [
            " ".join(command.split())
            for command in re.findall(r"`((?:\.venv/bin/)?kowalevski-cas [a-z]+ [^`]+)`", text)
            if not re.search(r"\b(NAME|FILE|COMMAND)\b|--help|--watch|--arithmetic all", command)
        ]
    )
}
"""The commands within sentences, which speak of the files that their page shows.

One that watches does not end, and `verify --arithmetic all` is `make verify`.
"""

FOUND = {"audit": (0, 1, 3)}
"""The exit codes of commands that say what they found; of all others it is 0."""


@pytest.fixture(scope="module")
def clone(tmp_path_factory):
    """A folder like a clone after ``make verify``, with the files of which the pages speak."""
    folder = tmp_path_factory.mktemp("clone")
    for name in ("kowalevski_cas", "derivations"):
        shutil.copytree(HERE / name, folder / name)
    for file in FILES.iterdir():
        shutil.copy(file, folder)
    lines = re.search(r"^A file anywhere.*:\n\n((?:    .*\n|\n)+)", README, re.MULTILINE)[1]
    (folder / "lorenz.py").write_text(re.sub("^    ", "", lines, flags=re.MULTILINE))
    certificate = (HERE / "docs" / "certificate.md").read_text(encoding="utf-8")
    (name, text), *_ = re.findall(r'^```json title="(.*?)"\n(.*?)^```', certificate, re.M | re.S)
    (folder / name).write_text(text, encoding="utf-8")
    tool = folder / ".venv" / "bin" / "kowalevski-cas"
    tool.parent.mkdir(parents=True)
    tool.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m kowalevski_cas "$@"\n')
    tool.chmod(0o755)
    return folder


def test_there_are_commands_of_the_readme_and_of_the_pages():
    assert len([one for one in COMMANDS if not ELSEWHERE.match(one)]) > 40


@pytest.mark.slow
@pytest.mark.parametrize("command", [one for one in COMMANDS if not ELSEWHERE.match(one)])
def test_every_command_works_as_it_is_pasted(command, clone):
    if "witness rocq" in command and shutil.which("coqc") is None:
        pytest.skip("no Rocq here")
    if " completion " in command and find_spec("shtab") is None:
        pytest.skip("the extra completion is not installed")
    runs(command, clone, clone)


@pytest.mark.slow
@pytest.mark.parametrize("page", WITHIN)
def test_the_commands_within_sentences_work_in_their_order_beside_the_files_of_their_page(
    page, clone
):
    folder = clone if page == "README" else clone / page
    folder.mkdir(exist_ok=True)
    (text,) = (text for path, text in zip(PAGES, TEXTS, strict=True) if path.stem == page)
    for name, own in re.findall(r'^```\w+ title="(.*?)"\n(.*?)^```', text, re.M | re.S):
        (folder / name).write_text(own, encoding="utf-8")
    for command in WITHIN[page]:
        if " completion " not in command or find_spec("shtab") is not None:
            runs(command, folder, clone)


def runs(command, folder, clone):
    """A command in a folder, with the tool of the clone: it ends as it says, and says something."""
    path = f"{clone / '.venv' / 'bin'}:/usr/local/bin:/usr/bin:/bin"
    # the tool replaces the shell: where it takes too long, nothing goes on working behind the test
    done = subprocess.run(
        ["bash", "-c", f"exec {command}"], cwd=folder, capture_output=True, text=True, timeout=1800,
        env={"HOME": str(clone), "PATH": path, "PYTHONPATH": str(clone)},
    )  # fmt: skip
    name = command.split()[1]
    assert done.returncode in FOUND.get(name, (0,)), done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout or done.stderr or ">" in command or name == "-p"
