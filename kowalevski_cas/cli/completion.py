"""Print what completes the commands and their options in a shell.

  bash:  kowalevski-cas completion bash > ~/.local/share/bash-completion/completions/kowalevski-cas
  zsh:   kowalevski-cas completion zsh > DIR/_kowalevski-cas, in a folder DIR of $fpath
  fish:  kowalevski-cas completion fish > ~/.config/fish/completions/kowalevski-cas.fish

It needs pip install 'kowalevski-cas[completion]'.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

from kowalevski_cas.cli.exits import AS_RECORDED

SHELLS = ("bash", "zsh", "fish")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("shell", choices=SHELLS, help="the shell")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    import shtab

    from kowalevski_cas.cli import whole_parser

    parser = whole_parser()
    for action in _actions(parser):
        if action.type is Path or action.metavar in ("DERIVATION", "CERTIFICATE"):
            action.complete = shtab.FILE  # type: ignore[attr-defined] # where shtab looks for it
        if action.choices is not None:
            action.choices = [*action.choices]  # a mapping would be taken for commands
    print(shtab.complete(parser, arguments.shell))
    return AS_RECORDED


def _actions(parser: argparse.ArgumentParser) -> Iterator[argparse.Action]:
    """The arguments of a parser and of those of its commands."""
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                yield from _actions(command)
        else:
            yield action
