"""Write the record of verdicts, and the evidence behind them, anew.

Every search is made again. What changed against the old record is shown.
"""

from __future__ import annotations

import argparse

from kowalevski_cas.arithmetic import EXACT
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, DISAGREEMENT, UNDECIDED, USAGE, CommandError
from kowalevski_cas.files import write_all
from kowalevski_cas.proof import evidence as kept
from kowalevski_cas.proof import record
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.proof.verify import disagreement


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    for folder, derivation in session.derivations(arguments.derivations):
        evidence: dict[str, kept.Evidence] = {}
        found = session.run(folder, derivation, EXACT, evidence=evidence)
        for outcome in found.outcomes:
            if disagreement(outcome.verdicts):
                raise CommandError(f"{outcome.claim}: {outcome.message}", DISAGREEMENT)
            if outcome.verdict is Verdict.ERROR:
                raise CommandError(f"{outcome.claim}: {outcome.message}", USAGE)
            if outcome.verdict in (Verdict.UNDECIDED, Verdict.TIMEOUT):
                raise CommandError(f"{outcome.claim} is {outcome.verdict}", UNDECIDED)
        try:
            old = record.load_record(folder)
        except record.RecordError:
            old = None
        for change in record.differences(found, old) if old is not None else ():
            print(f"{change.claim}: {change.recorded} -> {change.found}")
        write_all(
            {
                folder / record.FILE: record.dump_record(found, old),
                folder / kept.FILE: kept.dump_evidence(evidence),
            }
        )
        print(f"{folder / record.FILE}: {len(found.outcomes)} claims recorded")
    return AS_RECORDED
