"""What the README shows can be pasted."""

import re
from itertools import takewhile
from pathlib import Path

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")


def test_the_lines_of_python_follow_a_motion():
    lines = re.search(r"^From Python:\n\n((?:    .*\n)+)", README, re.MULTILINE)[1]
    names = {}
    exec(re.sub("^    ", "", lines, flags=re.MULTILINE), names)
    assert names["states"].shape == (3, 9)


def test_the_file_of_a_system_is_as_expected(tmp_path, capsys):
    from kowalevski_cas.cli import main

    lines = re.search(r"^A file anywhere.*:\n\n((?:    .*\n|\n)+)", README, re.MULTILINE)[1]
    file = tmp_path / "lorenz.py"
    file.write_text(re.sub("^    ", "", lines, flags=re.MULTILINE))
    assert main(["verify", str(file), "--arithmetic", "flint"]) == 0
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
