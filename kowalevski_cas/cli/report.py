"""Write the report of a derivation as a web page, LaTeX and PDF."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, CommandError
from kowalevski_cas.cli.parallel import each
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.verify.outcome import Run

if TYPE_CHECKING:
    from kowalevski_cas.verify.committed import Checked


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
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
    write(replace(found, versions=session.versions()), output, folder)


def write(run: Run, folder: Path, derivation: Path) -> Checked:
    """Write the report of a run, and say where it is; what the checker says of its certificates."""
    from kowalevski_cas.library import load
    from kowalevski_cas.report import ReportError, sections, write_report
    from kowalevski_cas.verify.committed import check_committed

    checked = check_committed(derivation, session.recorded(derivation))
    own = {outcome.claim: outcome.digest for outcome in run.outcomes}
    try:
        paper = load(str(derivation))
        found = sections(run, paper, paper.texts())
        written = write_report(run, found, folder, dict(own.items() & checked.digests.items()))
    except ReportError as error:
        raise CommandError(f"the report: {error}") from None
    for note in written.notes:
        print(note, file=sys.stderr)
    print(f"{written.html} and {written.pdf} are written", file=sys.stderr)
    return checked
