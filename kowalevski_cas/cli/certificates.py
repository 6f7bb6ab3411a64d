"""Write the certificates of a derivation: one file a claim, in its folder `certificates`.

Each one is read back and accepted by the checker before it is written. The record
of the derivation keeps their digests.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, CommandError
from kowalevski_cas.files import write_all
from kowalevski_cas.proof.certificate import Written, certificates
from kowalevski_cas.proof.committed import FOLDER, certificate_files
from kowalevski_cas.proof.evidence import load_evidence
from kowalevski_cas.verify.record import FILE, RecordError, with_certificates


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
    parser.add_argument(
        "-o", "--output", type=Path, metavar="DIR", help="write there instead of the derivation"
    )


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    for folder, derivation in session.derivations(arguments.derivations):
        with session.progress_bar() as progress:
            written = certificates(derivation, load_evidence(folder), progress=progress)
        target = arguments.output or folder / FOLDER
        texts = {f"{one.claim}.json": one.text for one in written if one.text}
        if not texts:
            raise CommandError(f"no claim of {derivation.name} has a certificate", NOTHING)
        files: dict[Path, str | bytes] = {target / name: text for name, text in texts.items()}
        if arguments.output is None:
            files |= _recorded(folder, written)
        write_all(files)
        if arguments.output is None:
            for path in certificate_files(folder):
                if path.name not in texts:
                    path.unlink()
        for one in written:
            if one.reason:
                print(f"{one.claim}: no certificate: {one.reason}", file=sys.stderr)
        print(f"{target}: {len(texts)} of {len(written)} claims have a certificate")
    return AS_RECORDED


def _recorded(folder: Path, written: Sequence[Written]) -> dict[Path, str]:
    """The record with the digests of the certificates, if there is one."""
    try:
        text = with_certificates(folder, {one.claim: one.digest for one in written if one.text})
    except RecordError as error:
        raise CommandError(str(error)) from None
    return {} if text is None else {folder / FILE: text}
