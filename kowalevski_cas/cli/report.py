"""Write the report of a derivation as LaTeX and PDF."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from kowalevski_cas.arithmetic import EXACT
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, CommandError
from kowalevski_cas.cli.parallel import each
from kowalevski_cas.dataclass import replace
from kowalevski_cas.derivation import Derivation
from kowalevski_cas.proof.outcome import Run
from kowalevski_cas.proof.record import RecordError, load_record

if TYPE_CHECKING:
    from kowalevski_cas.report.witnesses import Certified


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


def write(run: Run, folder: Path, derivation: Path) -> None:
    """Write the report of a run with the certificates of its derivation, and say where it is."""
    from kowalevski_cas.report import ReportError, write_report

    try:
        written = write_report(run, folder, _certified(run, derivation))
    except (ReportError, OSError) as error:
        raise CommandError(f"the report: {error}") from None
    for note in written.notes:
        print(note, file=sys.stderr)
    print(f"{written.tex} and {written.pdf} are written", file=sys.stderr)


def _certified(run: Run, derivation: Path) -> Certified:
    """The committed certificates that the checker accepts, and that are about the run."""
    from kowalevski_cas.proof.committed import check_committed
    from kowalevski_cas.report.witnesses import Certified

    try:
        record = load_record(derivation) or {}
    except RecordError:
        return Certified()
    statements = {outcome.claim: outcome.digest for outcome in run.outcomes}
    found = check_committed(
        derivation,
        {c: entry for c, entry in record.items() if entry.get("statement") == statements.get(c)},
    )
    return Certified(found.digests, found.notes)
