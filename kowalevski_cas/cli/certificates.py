"""Write the certificates of a derivation: one file a claim, in its folder `certificates`.

Evidence that is there is used again. Each certificate is accepted by the checker before it is
written.
"""

from __future__ import annotations

import argparse
import sys

from kowalevski_cas.cli import plain, session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, CommandError
from kowalevski_cas.files import write_all
from kowalevski_cas.verify.certificate import FOLDER


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
    session.add_output(parser, "write there instead of the derivation")
    session.add_timeout(parser, 600)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    found = session.derivations(arguments.derivations)
    written = session.watched(lambda one: session.certificates(*one, arguments.timeout), found)
    for (folder, derivation), (texts, reasons) in zip(found, written, strict=True):
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
