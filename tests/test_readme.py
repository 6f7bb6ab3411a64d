"""What the README shows can be pasted."""

import re
import subprocess
import sys
from itertools import takewhile
from pathlib import Path

import pytest
from PIL import Image, ImageChops, ImageStat

from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.words import in_words

README_PATH = Path(__file__).parents[1] / "README.md"
README = README_PATH.read_text(encoding="utf-8")


@pytest.mark.slow
def test_its_pictures_are_of_this_version(tmp_path):
    script = README_PATH.parent / "docs" / "pictures.py"
    subprocess.run([sys.executable, script, tmp_path], check=True, capture_output=True)
    made = sorted(file.name for file in tmp_path.iterdir())
    pages = [README, *(page.read_text(encoding="utf-8") for page in script.parent.rglob("*.md"))]
    assert "erratum.png" in made and all(any(name in page for page in pages) for name in made)
    for name in made:
        with Image.open(tmp_path / name) as now, Image.open(script.parent / name) as then:
            assert now.size == then.size
            differences = ImageChops.difference(now.convert("L"), then.convert("L"))
        assert ImageStat.Stat(differences).mean[0] < 1, f"{name} is old: make docs"


def test_its_first_words_are_what_was_found(run, derivation):
    found = Findings(Phrases(run.vocabulary, {}), run.outcomes)
    main = [one for one in run.outcomes if one.claim in derivation.main]
    assert all(one.verdict.green for one in main) and "Its main results stand" in README
    counts = [(found.slips, "formulas are misprinted"), (found.false, "sentence is false")]
    counts.append((found.missing, "hypotheses are missing"))
    for ones, words in counts:
        assert f"{in_words(len(ones))} {words}" in " ".join(README.lower().split())


def test_the_file_of_a_system_is_as_expected(tmp_path, capsys):
    from kowalevski_cas.cli import main

    lines = re.search(r"^A file anywhere.*:\n\n((?:    .*\n|\n)+)", README, re.MULTILINE)[1]
    file = tmp_path / "lorenz.py"
    file.write_text(re.sub("^    ", "", lines, flags=re.MULTILINE))
    assert main(["verify", str(file)]) == 0
    assert "3 claims: 2 proved, 1 refuted" in capsys.readouterr().out


def test_its_commands_and_their_options_exist(capsys):
    from kowalevski_cas.cli import main

    commands = re.findall(r"^    \.venv/bin/kowalevski-cas ([^#\n]*)", README, re.MULTILINE)
    assert len(commands) > 10
    for command in commands:
        name, *rest = re.sub(r" > .*| 2>.*", "", command).split()
        try:
            main([name, *takewhile(lambda word: word[0] != "-", rest), "--help"])
        except SystemExit as stopped:
            assert stopped.code == 0
        said = capsys.readouterr().out
        options = [word.partition("=")[0] for word in rest if re.match(r"-[-a-z]", word)]
        assert all(re.search(rf"(^|[ [|]){option}\b", said, re.MULTILINE) for option in options)
