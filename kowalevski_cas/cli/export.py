"""Write the certificates of a derivation in the language of another program.

Each certificate has a file of its own, in a folder with the name of the derivation.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, REJECTED, CommandError
from kowalevski_cas.export import Export, Json, load
from kowalevski_cas.files import write_all
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.tools import TOOLS
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.committed import certificate_files, check_committed, check_files
from kowalevski_cas.verify.record import load_record


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    words = "; ".join(f"{name}: {tool.reads}" for name, tool in TOOLS.items())
    parser.add_argument("format", choices=TOOLS, metavar="FORMAT", help=words)
    session.add_derivations(parser)
    session.add_output(parser, "write there", required=True)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    for folder, derivation in session.derivations(arguments.derivations):
        certificates, export = translate(arguments.format, folder, derivation)
        target = arguments.output / derivation.name
        files = export.files | load(arguments.format).project(export.files)
        write_all({target / name: text for name, text in files.items()})
        said = f"{len(export.texts)} of {len(certificates)} certificates"
        print(f"{derivation.name}: {said}, in {target}")
    return AS_RECORDED


def translate(format: str, folder: Path, derivation: Derivation) -> tuple[dict[str, Json], Export]:
    """The certificates of a derivation and their export; what is left out is named on stderr."""
    certificates = certificates_to_export(folder, derivation)
    export = load(format).files(certificates)
    if not export.texts:
        raise CommandError(f"no claim of {derivation.name} can be said in {format}", NOTHING)
    for name in dict.fromkeys([*(claim.id for claim in derivation.claims), *certificates]):
        if name not in export.texts:
            reason = export.omitted.get(name, "it has no certificate")
            print(f"{name}: left out: {reason}", file=sys.stderr)
    return certificates, export


def certificates_to_export(folder: Path, derivation: Derivation) -> dict[str, Json]:
    """The certificates in the folder of a derivation by name; all have to be as recorded."""
    record = load_record(folder)
    files = certificate_files(folder)
    found = check_committed(folder, derivation, record) if record else check_files(files)
    for name, reason in found.rejected.items():
        raise CommandError(f"{name}: {reason}", REJECTED)
    stored = load_certificates(folder)
    return {name: stored[name].data for name in found.digests}
