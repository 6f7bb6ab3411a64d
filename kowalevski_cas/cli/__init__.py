"""The command line: one file for each command, imported when it is asked for."""

from __future__ import annotations

import argparse
import gc
import os
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from signal import SIGINT, SIGTERM, default_int_handler, pthread_kill, signal
from threading import Timer, current_thread, get_ident, main_thread
from traceback import print_exception

from kowalevski_cas import UserError, __version__
from kowalevski_cas.cli.exits import AS_RECORDED, FAILED, INTERRUPTED, USAGE, exit_codes
from kowalevski_cas.cli.terminal import output
from kowalevski_cas.exit_guard import no_exit

COMMANDS = {
    "verify": "prove or refute the claims of a derivation and compare with its record",
    "report": "write the report of a derivation as a web page, LaTeX and PDF",
    "audit": "read a paper's TeX source and prove or refute each formula in it",
    "review": "audit the papers of a repository, against what is known of them",
    "bundle": "put the evidence, the checker and the page into a folder to deposit with a paper",
    "find": "find what nobody has printed: integrals and the like",
    "prove": "find evidence for a problem of your own, and print its certificate",
    "check": "check certificates with the independent checker",
    "certificates": "write the certificates of a derivation",
    "export": "write certificates in the language of another program",
    "witness": "let another program confirm the certificates",
    "motion": "follow a motion from any state: on N⁴ and O⁴ by its closed form",
    "pictures": "draw a motion, and the bifurcation diagrams of the whole top",
    "animation": "show the body as it moves on N⁴, as an animated GIF",
    "lsp": "serve an editor: diagnostics and corrections while a paper is typed",
    "mcp": "serve an agent: audit, verify, find, check",
    "completion": "print what completes these commands in a shell",
    "record": "search anew, and write the record of verdicts and the certificates",
}

EXTRAS = {
    "numpy": "motion",
    "scipy": "motion",
    "matplotlib": "motion",
    "heyoka": "taylor",
    "distributed": "cluster",
    "pygls": "editor",
    "lsprotocol": "editor",
    "mcp": "agents",
    "shtab": "completion",
}
"""Libraries that a plain install leaves out, and the extra that brings each."""

GARBAGE = 100_000
"""So many objects more are made before garbage in circles is looked for: there is hardly any."""

_HELP = argparse.RawDescriptionHelpFormatter


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command and return its exit code."""
    gc.set_threshold(GARBAGE)
    words = list(sys.argv[1:] if argv is None else argv)
    if words and words[0] in COMMANDS:
        return run(f"kowalevski-cas {words[0]}", f"{__name__}.{words[0]}", words[1:])
    return _run("kowalevski-cas", words, _overview)


def run(program: str, module: str, words: Sequence[str]) -> int:
    """Run the command in the module with this name, called ``program``; return its exit code."""

    def parser() -> argparse.ArgumentParser:
        found = argparse.ArgumentParser(program, formatter_class=_HELP)
        try:
            command = import_module(module)
        except ModuleNotFoundError as error:
            if not {"-h", "--help"} & {*words}:
                raise
            found.description = _docstring(module)
            found.epilog = f"Its arguments are shown where there is {_needed(error)}"
            return found
        own = getattr(command, "EXIT_CODES", None)
        found.epilog = exit_codes(module.rpartition(".")[2], own)
        found.description = command.__doc__
        command.add_arguments(found)
        found.set_defaults(run=command.run)
        return found

    return _run(program, words, parser)


@contextmanager
def _terminable() -> Iterator[None]:
    """Let this process be ended like by an interruption: with those that it has begun."""
    if current_thread() is not main_thread():
        yield
        return
    before = signal(SIGTERM, default_int_handler)
    try:
        yield
    finally:
        signal(SIGTERM, before)


@_terminable()
def _run(program: str, words: Sequence[str], parser: Callable[[], argparse.ArgumentParser]) -> int:
    """Run what the words ask a parser for; what goes wrong is told in the program's name."""
    sys.unraisablehook, threading.excepthook = _unraisable, _tell_of_thread
    closed = sys.stdout is None
    with output(), no_exit():
        known = {*threading.enumerate()}
        code = _exit_code(program, words, parser)
        for thread in {*threading.enumerate()} - known:  # as the interpreter does, unguarded
            if not thread.daemon:
                thread.join()
        if closed and code == AS_RECORDED:
            print(f"{program}: the output is closed", file=sys.stderr)
            return USAGE
        return code


def _exit_code(
    program: str, words: Sequence[str], parser: Callable[[], argparse.ArgumentParser]
) -> int:
    """How a command ends."""
    try:
        arguments = parser().parse_args(words)
        code: int = arguments.run(arguments)
        sys.stdout.flush()
    except UserError as error:
        print(f"{program}: {error}", file=sys.stderr)
        return error.code
    except ModuleNotFoundError as error:
        print(f"{program} needs {_needed(error)}", file=sys.stderr)
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
        print(f"{program}: {place}: {error.strerror}", file=sys.stderr)
        return USAGE
    except Exception as error:
        said = f"{type(error).__name__}: {error}"
        print(f"{program}: this should not happen: {said}", file=sys.stderr)
        if {"-v", "--verbose"} & {*words}:
            print_exception(error)
        else:
            print("`--verbose` shows where; please report it", file=sys.stderr)
        return FAILED
    return code


def _docstring(module: str) -> str | None:
    """What a module says of itself, without what it needs."""
    import ast

    spec = find_spec(module)
    assert spec is not None and spec.origin is not None
    return ast.get_docstring(ast.parse(Path(spec.origin).read_text(encoding="utf-8")))


def _needed(error: ModuleNotFoundError) -> str:
    """The library that is missing, and how it is installed; the error, if it is none of ours."""
    library = (error.name or "").partition(".")[0]
    if library not in EXTRAS:
        raise error
    return f"{library}: pip install 'kowalevski-cas[{EXTRAS[library]}]'"


def whole_parser() -> argparse.ArgumentParser:
    """A parser that knows all commands with their arguments, as far as what they need is there."""
    parser = _overview()
    (commands,) = (
        action for action in parser._actions if isinstance(action, argparse._SubParsersAction)
    )
    for name, command in commands.choices.items():
        command.formatter_class, command.epilog = _HELP, exit_codes(name)
        command.description = _docstring(module := f"{__name__}.{name}")
        with suppress(ModuleNotFoundError):
            import_module(module).add_arguments(command)
    return parser


def _overview() -> argparse.ArgumentParser:
    """A parser that knows what commands there are, and runs none."""
    parser = argparse.ArgumentParser(
        prog="kowalevski-cas",
        description="Printed derivations of mathematical mechanics, proved or refuted.",
        epilog=f"`kowalevski-cas COMMAND --help` says more of a command.\n\n{exit_codes('')}",
        formatter_class=_HELP,
    )

    def overview(_: argparse.Namespace) -> int:
        parser.print_help()
        return USAGE

    parser.add_argument("--version", action="version", version=f"kowalevski-cas {__version__}")
    parser.set_defaults(run=overview)
    commands = parser.add_subparsers(title="commands", metavar="COMMAND")
    for name, summary in COMMANDS.items():
        commands.add_parser(name, help=summary)
    return parser


def _silence() -> None:
    """The reader has gone, or the disk is full: nothing more can be written, not even at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _tell_of_thread(ended: threading.ExceptHookArgs) -> None:
    """What goes wrong in a thread that a derivation has begun is told; the run goes on."""
    if ended.exc_type is not SystemExit:
        said = f"{ended.exc_type.__name__}: {ended.exc_value}"
        print(f"kowalevski-cas: a thread ended with an error: {said}", file=sys.stderr)


def _unraisable(unraisable: sys.UnraisableHookArgs) -> None:
    """An interruption that fell into a finalizer, where nothing can be raised, comes once more."""
    if unraisable.exc_type is not KeyboardInterrupt:
        sys.__unraisablehook__(unraisable)
        return
    again = Timer(0.02, pthread_kill, (get_ident(), SIGINT))
    again.daemon = True
    again.start()
