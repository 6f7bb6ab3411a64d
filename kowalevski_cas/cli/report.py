"""Write the report of a derivation as LaTeX and PDF."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from kowalevski_cas.arithmetic import EXACT
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, CommandError
from kowalevski_cas.cli.parallel import each
from kowalevski_cas.dataclass import replace
from kowalevski_cas.derivation import Derivation
from kowalevski_cas.proof.outcome import Run


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument(
        "derivations",
        nargs="*",
        metavar="DERIVATION",
        help="name in the library, or folder; all of the library if none is named",
    )
    parser.add_argument(
        "--output",
        type=Path,
        default=Path("reports"),
        metavar="DIR",
        help="where to write (reports)",
    )


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    each(
        lambda found: _report(*found, arguments.output), session.derivations(arguments.derivations)
    )
    return AS_RECORDED


def _report(folder: Path, derivation: Derivation, output: Path) -> None:
    found = session.run(folder, derivation, EXACT, explain=True)
    write(replace(found, versions=session.versions()), output)


def write(run: Run, folder: Path) -> None:
    """Write the report of a run, and say where it is."""
    from kowalevski_cas.report import ReportError, write_report

    try:
        written = write_report(run, folder)
    except (ReportError, OSError) as error:
        raise CommandError(f"the report: {error}") from None
    for note in written.notes:
        print(note, file=sys.stderr)
    print(f"{written.tex} and {written.pdf} are written", file=sys.stderr)
