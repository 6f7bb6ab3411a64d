"""Write the record of verdicts, and the certificates behind them, anew.

Every search is made again. What changed against the old record is shown. A claim that is undecided
is recorded as such, and named at the end.
"""

from __future__ import annotations

import argparse
import json

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, DISAGREEMENT, UNDECIDED, USAGE, CommandError
from kowalevski_cas.files import write_all
from kowalevski_cas.verify import record
from kowalevski_cas.verify.certificate import FOLDER, Stored
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import disagreement


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    code = AS_RECORDED
    for folder, derivation in session.derivations(arguments.derivations):
        texts, _ = session.certificates(folder, derivation, anew=True)
        stored = {
            name: Stored(folder / FOLDER / f"{name}.json", json.loads(text))
            for name, text in texts.items()
        }
        found = session.run(folder, derivation, EXACT, stored=stored)
        for outcome in found.outcomes:
            if disagreement(outcome.verdicts):
                raise CommandError(f"{outcome.claim}: {outcome.message}", DISAGREEMENT)
            if outcome.verdict is Verdict.ERROR:
                raise CommandError(f"{outcome.claim}: {outcome.message}", USAGE)
        for change in record.differences(found, session.recorded(folder)):
            print(f"{change.claim}: {change.recorded} -> {change.found}")
        write_all(
            {folder / record.FILE: record.dump_record(found)}
            | {folder / FOLDER / f"{name}.json": text for name, text in texts.items()}
        )
        session.remove_others(folder, texts)
        print(f"{folder / record.FILE}: {len(found.outcomes)} claims recorded")
        for outcome in found.outcomes:
            if outcome.verdict is Verdict.UNDECIDED:
                print(f"{outcome.claim}: recorded as undecided; {outcome.message}")
                code = UNDECIDED
    return code
