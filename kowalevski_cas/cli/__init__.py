"""The command line: one file for each command, imported when it is asked for."""

from __future__ import annotations

import argparse
import gc
import os
import sys
from collections.abc import Sequence
from importlib import import_module

from kowalevski_cas import __version__
from kowalevski_cas.cli.exits import EXIT_CODES, INTERRUPTED, USAGE, CommandError

COMMANDS = {
    "verify": "prove or refute the claims of a derivation and compare with its record",
    "report": "write the report of a derivation as LaTeX and PDF",
    "audit": "read a paper's TeX source and prove or refute each formula in it",
    "check": "check certificates with the independent checker",
    "certificates": "write the certificates of a derivation",
    "export": "write certificates in the language of another program",
    "witness": "let another program confirm the certificates",
    "mutants": "change one token at a time, and count what an audit notices",
    "motion": "follow a motion on N⁴ by its closed form, or by an integrator",
    "pictures": "draw a motion on N⁴: hodographs, traces, torus, bifurcation diagrams",
    "animation": "show the body as it moves on N⁴, as an animated GIF",
    "record": "write the record of verdicts, and the evidence behind them, anew",
}

EXTRAS = {"numpy": "motion", "scipy": "motion", "matplotlib": "motion", "heyoka": "taylor"}
"""Libraries that a plain install leaves out, and the extra that brings each."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command and return its exit code."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    gc.set_threshold(100_000)  # formulas and elements hardly make cycles: look for them seldom
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(encoding="utf-8", errors="backslashreplace")
    if not arguments or arguments[0] not in COMMANDS:
        return _overview(arguments)
    name, *rest = arguments
    return run(f"kowalevski-cas {name}", f"{__name__}.{name}", rest)


def run(prog: str, name: str, arguments: Sequence[str]) -> int:
    """Run the command in the module with this name, called ``prog``; return its exit code."""
    sys.unraisablehook = _unraisable
    try:
        module = import_module(name)
        parser = argparse.ArgumentParser(
            prog=prog,
            description=module.__doc__,
            epilog=EXIT_CODES,
            formatter_class=_Help,
        )
        module.add_arguments(parser)
        code: int = module.run(parser.parse_args(arguments))
        sys.stdout.flush()
        gc.freeze()  # the process ends: nobody need look for cycles in what is left
    except CommandError as error:
        print(f"{prog}: {error}", file=sys.stderr)
        return error.code
    except ModuleNotFoundError as error:
        library = (error.name or "").partition(".")[0]
        if library not in EXTRAS:
            raise
        install = f"pip install 'kowalevski-cas[{EXTRAS[library]}]'"
        print(f"{prog} needs {library}: {install}", file=sys.stderr)
        return USAGE
    except KeyboardInterrupt:
        print("\ninterrupted: files written earlier are as they were", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        _silence()
        return 0
    except OSError as error:
        if error.filename is None:
            _silence()
        place = error.filename or "the output"
        print(f"{prog}: {place}: {error.strerror}", file=sys.stderr)
        return USAGE
    return code


def _silence() -> None:
    """The reader has gone, or the disk is full: nothing more can be written, not even at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _unraisable(unraisable: sys.UnraisableHookArgs) -> None:
    """An interruption that fell into a finalizer, where nothing can be raised, comes once more."""
    if unraisable.exc_type is not KeyboardInterrupt:
        sys.__unraisablehook__(unraisable)
        return
    from signal import SIGINT, pthread_kill
    from threading import Timer, get_ident

    again = Timer(0.02, pthread_kill, (get_ident(), SIGINT))
    again.daemon = True
    again.start()


class _Help(argparse.RawDescriptionHelpFormatter):
    """Help as wide as the terminal; argparse itself loads archive formats to ask how wide it is."""

    def __init__(self, prog: str) -> None:
        try:
            columns = int(os.environ.get("COLUMNS") or os.get_terminal_size().columns)
        except (OSError, ValueError):
            columns = 80
        super().__init__(prog, width=columns - 2)


def _overview(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="kowalevski-cas",
        description="Printed derivations of mathematical mechanics, proved or refuted.",
        epilog="commands:\n"
        + "\n".join(f"  {name:14}{words}" for name, words in COMMANDS.items())
        + "\n\n`kowalevski-cas COMMAND --help` says more.\n\n"
        + EXIT_CODES,
        formatter_class=_Help,
    )
    parser.add_argument("--version", action="version", version=f"kowalevski-cas {__version__}")
    parser.add_argument("command", choices=list(COMMANDS), metavar="COMMAND", help="see below")
    if not arguments:
        parser.print_help()
        return USAGE
    parser.parse_args(arguments[:1])
    return USAGE
