"""Write the certificates of a derivation: one file a claim, in its folder `certificates`.

Evidence that is there is used again. Each certificate is accepted by the checker, on its own,
before it is written.
"""

from __future__ import annotations

import argparse
import sys

from kowalevski_cas.cli import plain, session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, CommandError
from kowalevski_cas.files import write_all
from kowalevski_cas.verify.certificate import FOLDER
from kowalevski_cas.verify.outcome import DECIDED


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
    session.add_output(parser, "write there instead of the derivation")
    session.add_timeout(parser, 600)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    chosen = session.derivations(arguments.derivations)
    runs = [run for run, _ in session.runs(chosen, ["flint"], timeout=arguments.timeout)]
    for (folder, derivation), found, reasons in zip(
        chosen, runs, session.map_in_processes(session.rejections, runs), strict=True
    ):
        open_ones = (outcome for outcome in found.outcomes if outcome.verdict not in DECIDED)
        reasons |= {outcome.claim: f"{outcome.verdict}: {outcome.message}" for outcome in open_ones}
        texts = {
            name: text
            for name, text in found.certificates.items()
            if name.rpartition("/")[2] not in reasons
        }
        if not texts:
            raise CommandError(f"no claim of {derivation.name} has a certificate", NOTHING)
        target = arguments.output or folder / FOLDER
        write_all({target / f"{name}.json": text for name, text in texts.items()})
        if arguments.output is None:
            session.remove_others(folder, texts)
        for name, reason in reasons.items():
            print(f"{name}: no certificate: {reason}", file=sys.stderr)
        print(f"{target}: {plain.many(len(texts), 'certificate')} written")
    return AS_RECORDED
