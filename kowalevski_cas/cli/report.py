"""Write the report of a derivation as a web page, LaTeX and PDF."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.cli import session
from kowalevski_cas.cli.check import tell
from kowalevski_cas.cli.exits import AS_RECORDED, most_urgent
from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.report.pdf import write_report
from kowalevski_cas.verify.certificate import FOLDER
from kowalevski_cas.verify.committed import Checked, check_committed, statements


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
    session.add_output(parser, "where to write", "reports")
    session.add_timeout(parser, 60)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    chosen = session.derivations(arguments.derivations)
    results = runs_with_steps(chosen, arguments.timeout)
    code = write(results, arguments.output)
    return most_urgent([code, *(result.exit_code for result in results)])


def runs_with_steps(chosen: Sequence[tuple[Path, Derivation]], timeout: float) -> list[ComparedRun]:
    """Runs that tell their steps, with what a report needs."""
    runs = session.runs(chosen, EXACT, explain=True, timeout=timeout)
    versions = session.versions()
    return [
        ComparedRun(*selected, texts, run._replace(versions=versions))
        for selected, (run, texts) in zip(chosen, runs, strict=True)
    ]


def write(results: Sequence[ComparedRun], output: Path) -> int:
    """Write the reports of runs, those of most claims first; the exit code for certificates."""
    done = session.map_in_processes(
        lambda found: _write(found, output), results, lambda found: len(found.run.outcomes)
    )
    for _, said in done:
        print(said, file=sys.stderr)
    checked = [found for found, _ in done if found.total]
    return tell(checked) if checked else AS_RECORDED


def _write(found: ComparedRun, output: Path) -> tuple[Checked, str]:
    checked, digests = check_certificates(found)
    evidence = Path(os.path.relpath(found.folder / FOLDER, output)).as_posix()
    written = write_report(found.run, found.paper, output, digests, evidence)
    *pages, last = map(str, written.pages)
    said = [*written.notes, f"{', '.join(pages)} and {last} are written"]
    return checked, "\n".join(said)


def check_certificates(found: ComparedRun) -> tuple[Checked, dict[str, str]]:
    """What the checker says of certificates, and the digests of those about this run's claims."""
    record, run = session.readable_record(found.folder), found.run
    checked = check_committed(found.folder, found.derivation, record, statements(run))
    current = {outcome.claim: outcome.digest for outcome in run.outcomes}
    return checked, dict(current.items() & checked.digests.items())
