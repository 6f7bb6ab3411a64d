"""What a shell completes, what the manual says, and what the help of each command says of it."""

import argparse
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from kowalevski_cas.cli import COMMANDS, exits, main, whole_parser
from kowalevski_cas.cli.completion import SHELLS

ROOT = Path(__file__).parents[2]
PARSERS = next(
    one.choices for one in whole_parser()._actions if isinstance(one, argparse._SubParsersAction)
)


def options(parser):
    """The long options of a command."""
    return {word for one in parser._actions for word in one.option_strings if word[:2] == "--"} - {
        "--help"
    }


def test_every_command_and_option_is_completed(capsys):
    for shell in SHELLS:
        assert main(["completion", shell]) == 0
        script = capsys.readouterr().out
        for name, parser in PARSERS.items():
            assert name in script
            for option in options(parser):
                assert option in script or (shell == "fish" and f"-l {option[2:]}" in script)


@pytest.mark.parametrize("shell", SHELLS)
def test_a_shell_reads_it(capsys, tmp_path, shell):
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    assert main(["completion", shell]) == 0
    script = tmp_path / "script"
    script.write_text(capsys.readouterr().out)
    subprocess.run([shell, "-n", script], check=True)
    if shell == "bash":
        words = "COMP_WORDS=(kowalevski-cas audit --pa); COMP_CWORD=2; _shtab_kowalevski_cas"
        code = f"source {script}; {words}; echo ${{COMPREPLY[@]}}"
        done = subprocess.run([shell, "-c", code], check=True, capture_output=True, text=True)
        assert done.stdout.split() == ["--patch"]


def test_the_manual_has_every_command_and_option():
    page = (ROOT / "docs" / "kowalevski-cas.1").read_text().replace("\\-", "-")
    for name, parser in PARSERS.items():
        section = page.partition(f"kowalevski-cas {name}\\fR\n")[2].partition("\n.SS ")[0]
        assert all(option in section for option in options(parser)), f"{name}: make docs"


@pytest.mark.parametrize("name", COMMANDS)
def test_help_speaks_of_its_command(capsys, name):
    with pytest.raises(SystemExit):
        main([name, "--help"])
    said = capsys.readouterr().out
    others = {other for other in COMMANDS if other != name}
    codes = said.partition("exit codes:")[2]
    assert not any(re.search(rf"\({other}\)", codes) for other in others)
    source = (ROOT / "kowalevski_cas" / "cli" / f"{name}.py").read_text()
    for code in ("DIFFERENT", "UNDECIDED", "DISAGREEMENT", "REJECTED", "NOTHING"):
        if re.search(rf"\b{code}\b", source):
            assert f"\n  {getattr(exits, code)} " in codes
