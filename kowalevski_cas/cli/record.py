"""Write the record of verdicts, and the certificates behind them, anew.

Every search is made again. What changed against the old record is shown. A claim that comes to no
end keeps what is recorded of it, and does not keep the others from being recorded.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping
from pathlib import Path

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.cli import plain, session
from kowalevski_cas.cli.exits import AS_RECORDED, DISAGREEMENT, UNDECIDED, CommandError
from kowalevski_cas.files import write_all
from kowalevski_cas.verify import record
from kowalevski_cas.verify.certificate import FOLDER, Stored
from kowalevski_cas.verify.committed import certificates_of
from kowalevski_cas.verify.outcome import Run, Verdict
from kowalevski_cas.verify.outcome_writer import disagreement


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
    session.add_timeout(parser, 600)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    chosen = session.derivations(arguments.derivations)
    anew: list[dict[str, Stored]] = [{} for _ in chosen]
    both = session.runs(chosen, EXACT, timeout=arguments.timeout, stored=anew)
    runs = [run for run, _ in both]
    rejected = session.map_in_processes(session.rejections, runs)
    return max(
        _write(folder, _decide(run, reasons))
        for (folder, _), run, reasons in zip(chosen, runs, rejected, strict=True)
    )


def _decide(found: Run, rejected: Mapping[str, str]) -> Run:
    """A run in which what the checker, on its own, does not accept is an error."""
    for outcome in found.outcomes:
        if disagreement(outcome.verdicts):
            raise CommandError(f"{outcome.claim}: {outcome.message}", DISAGREEMENT)
    outcomes = (
        o._replace(verdict=Verdict.ERROR, message=f"no certificate: {rejected[o.claim]}")
        if o.claim in rejected
        else o
        for o in found.outcomes
    )
    return found._replace(outcomes=tuple(outcomes))


def _write(folder: Path, found: Run) -> int:
    """Record what is decided; what the record has of claims that came to no end is left alone."""
    recorded = session.readable_record(folder)
    left = {outcome.claim: outcome for outcome in record.open_ones(found)}
    for outcome in left.values():
        said = f"{outcome.verdict}: {outcome.message}"
        print(f"{outcome.claim} is not recorded: {said}", file=sys.stderr)
    for change in record.differences(found, recorded):
        if change.claim not in left:
            print(f"{change.claim}: {change.recorded} -> {change.found}")
    texts = found.certificates
    kept = certificates_of({claim: recorded[claim] for claim in left if claim in recorded})
    write_all(
        {folder / record.FILE: record.dump_record(found, recorded)}
        | {folder / FOLDER / f"{name}.json": text for name, text in texts.items()}
    )
    session.remove_others(folder, [*texts, *kept])
    print(
        f"{folder / record.FILE}: {plain.many(len(found.outcomes) - len(left), 'claim')} recorded"
    )
    undecided = any(outcome.verdict is Verdict.UNDECIDED for outcome in found.outcomes)
    return UNDECIDED if left or undecided else AS_RECORDED
