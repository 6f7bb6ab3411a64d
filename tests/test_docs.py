"""Every block of code in the documentation runs, in the order of its page, and says what is printed."""

import re
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from subprocess import STDOUT, run

import pytest

from kowalevski_cas.library import available, find
from kowalevski_cas.verify.record import load_record

DOCS = Path(__file__).parents[1] / "docs"
PAGES = sorted(
    page
    for page in DOCS.rglob("*.md")
    if re.search("^```(console|pycon)", page.read_text(encoding="utf-8"), re.M)
)
"""The pages with code; the certificate in ``certificate.md`` is checked in ``problem/test_format.py``."""

BLOCK = re.compile(r'^```(\w+)(?: title="([^"]+)")?\n(.*?)^```$', re.MULTILINE | re.DOTALL)
TIMES = re.compile(r" *\d+\.\d+ ?m?s\b")


def said(text):
    """What is printed, without times and the ends of lines."""
    return [
        re.sub(r" in$", "", TIMES.sub("", line)).rstrip() for line in text.rstrip().splitlines()
    ]


def shown(language, text):
    """The commands or the lines of Python in a block, each with what it prints."""
    prompt, more = (r"\$ ", "\0") if language == "console" else (r">>> ", "... ")
    for entry in re.split(rf"^{prompt}", text, flags=re.MULTILINE)[1:]:
        command, *output = entry.splitlines()
        while output and output[0].startswith(more):
            command += "\n" + output.pop(0)[len(more) :]
        yield command, output


def printed(code, folder):
    """What a command or lines of Python print, run in a folder."""
    done = run(
        code, cwd=folder, text=True, stdout=-1, stderr=STDOUT,
        env={"PYTHONPATH": f"{DOCS.parent}:{folder}", "PYTHONIOENCODING": "utf-8", "COLUMNS": "80", "PATH": ""},
    )  # fmt: skip
    return done.stdout


def spoken(block, folder):
    """A block with what each of its entries prints, as it is to be printed."""
    language, _, text = block
    before, lines = "", []
    for command, _ in shown(language, text):
        if language == "console":
            words = command.split()
            program = ["-m", "kowalevski_cas"] if words[0] == "kowalevski-cas" else []
            lines += [
                f"$ {command}",
                *printed([sys.executable, *program, *words[1:]], folder).splitlines(),
            ]
        else:
            first, *rest = command.splitlines()
            value = f"exec(compile({command!r} + chr(10), '', 'single'))"
            whole = printed(
                [sys.executable, "-c", f"{before}\nprint(chr(0), end='')\n{value}"], folder
            )
            lines += [f">>> {first}", *(f"... {line}" for line in rest)]
            lines += whole.partition("\0")[2].splitlines()
            before += f"\n{value}"
    return lines


@pytest.mark.slow
@pytest.mark.parametrize(
    "page",
    [
        pytest.param(p, marks=[] if p.stem == "source" else pytest.mark.slow, id=p.stem)
        for p in PAGES
    ],
)
def test_every_block_of_a_page_says_what_is_printed(page, tmp_path):
    for block in BLOCK.findall(page.read_text(encoding="utf-8")):
        language, title, text = block
        if title:
            (tmp_path / title).write_text(text, encoding="utf-8")
        else:
            assert language in ("console", "pycon"), f"a block that nobody runs: {text}"
            assert said("\n".join(spoken(block, tmp_path))) == said(text)


def test_the_pages_are_those_of_the_site():
    named = set(re.findall(r"[\w/]+\.md", (DOCS.parent / "mkdocs.yml").read_text(encoding="utf-8")))
    assert named == {str(page.relative_to(DOCS)) for page in DOCS.rglob("*.md")}


@pytest.fixture
def hooks():
    """What mkdocs does with pages."""
    spec = spec_from_file_location("hooks", DOCS / "hooks.py")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_gallery_has_every_derivation_with_its_verdicts(hooks):
    gallery = (DOCS / "gallery.md").read_text(encoding="utf-8")
    shown = hooks.on_page_markdown(gallery)
    rows = re.findall(r"^\| `(\w+)` \| (\d+) \| (\d+) \| (\d+) \|$", shown, re.M)
    assert sorted(name for name, *_ in rows) == sorted(available())
    assert all(f"**`{name}`**" in gallery for name, *_ in rows)
    for name, *counts in rows:
        assert sum(map(int, counts)) == len(load_record(find(name)))


def test_the_home_page_shows_the_beginning_of_what_the_tutorial_runs():
    home, tutorial = ((DOCS / f"{n}.md").read_text(encoding="utf-8") for n in ("index", "tutorial"))
    (example,) = re.findall(r"^```text\n(.*?)^```$", home, re.M | re.S)
    assert example in tutorial


def test_roles_of_docstrings_are_code_on_the_site(hooks):
    shown = hooks.on_page_content(":class:<code>~a.b.C</code>, :math:<code>x_1</code>")
    assert shown == "<code>C</code>, <code>x_1</code>"
