"""Write the report of a derivation as a web page, LaTeX and PDF."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.report.pdf import write_report
from kowalevski_cas.report.places import Section, sections
from kowalevski_cas.verify.certificate import FOLDER
from kowalevski_cas.verify.committed import Checked, check_committed, statements
from kowalevski_cas.verify.outcome import Run

Explained = tuple[Run, Sequence[Section], Path]
"""A run, its outcomes in the order of the paper, and the folder of the derivation."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
    session.add_output(parser, "where to write", "reports")
    session.add_timeout(parser, 60)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    chosen = session.derivations(arguments.derivations)

    def written(found: Explained) -> tuple[Checked, str]:
        return write(*found, arguments.output)

    found = explained(chosen, arguments.timeout)
    for _, said in session.watched(written, found, lambda one: len(one[0].outcomes)):
        print(said, file=sys.stderr)
    return AS_RECORDED


def explained(chosen: Sequence[tuple[Path, Derivation]], timeout: float) -> list[Explained]:
    """Runs that tell their steps, with what a report needs."""
    runs = session.runs(chosen, EXACT, explain=True, timeout=timeout)
    versions = session.versions()
    return [
        (run._replace(versions=versions), sections(run, derivation, texts), folder)
        for (folder, derivation), (run, texts) in zip(chosen, runs, strict=True)
    ]


def write(
    run: Run, paper: Sequence[Section], derivation: Path, folder: Path
) -> tuple[Checked, str]:
    """Write the report of a run; what the checker says of its certificates, and where it is."""
    checked, digests = certified(run, derivation)
    evidence = os.path.relpath(derivation / FOLDER, folder)
    written = write_report(run, paper, folder, digests, Path(evidence).as_posix())
    said = [*written.notes, f"{written.html} and {written.pdf} are written"]
    return checked, "\n".join(said)


def certified(run: Run, folder: Path) -> tuple[Checked, dict[str, str]]:
    """What the checker says of certificates, and the digests of those about this run's claims."""
    checked = check_committed(folder, session.recorded(folder), statements(run))
    own = {outcome.claim: outcome.digest for outcome in run.outcomes}
    return checked, dict(own.items() & checked.digests.items())
