"""Let another program confirm the certificates of a derivation, each by its own computation.

What it confirms is written to DIR/DERIVATION/PROGRAM.json, for the report.
"""

from __future__ import annotations

import argparse
import sys

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, REJECTED
from kowalevski_cas.cli.export import translate
from kowalevski_cas.export import load
from kowalevski_cas.export.witness import testify
from kowalevski_cas.files import write
from kowalevski_cas.tools import TOOLS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    words = "; ".join(f"{name}: {tool.reads}" for name, tool in TOOLS.items())
    parser.add_argument("program", choices=TOOLS, metavar="PROGRAM", help=words)
    session.add_derivations(parser)
    session.add_output(parser, "write there", "reports/witnesses")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    name = arguments.program
    format = load(name)
    code = AS_RECORDED
    format.tool.call()
    for folder, derivation in session.derivations(arguments.derivations):
        certificates, export = translate(name, folder, derivation)
        digests = {claim: str(certificate["digest"]) for claim, certificate in certificates.items()}
        with session.progress_bar() as progress:
            testimony = testify(name, format, export, digests, progress)
        target = arguments.output / derivation.name / f"{name}.json"
        write(target, testimony.text())
        for claim, reason in testimony.failed.items():
            print(f"{claim}: not confirmed: {reason}", file=sys.stderr)
            code = REJECTED
        said = f"{len(testimony.confirmed)} of {len(certificates)} certificates"
        print(f"{derivation.name}: {said} confirmed by {testimony.program_version}")
    return code
