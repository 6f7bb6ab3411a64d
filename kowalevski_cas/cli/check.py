"""Check certificates with the independent checker.

The same as `python -I -S kowalevski_cas/proof/checker.py FILE...`, which trusts
nothing else of this program.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from kowalevski_cas.cli import session
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.committed import certificate_files


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument(
        "certificates",
        nargs="*",
        metavar="CERTIFICATE",
        help="a file, or a derivation whose certificates are meant; all of the library if none",
    )


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    files = [name for name in arguments.certificates if name.endswith(".json")]
    names = [name for name in arguments.certificates if not name.endswith(".json")]
    if names or not files:
        for folder, _ in session.derivations(names):
            files += map(str, certificate_files(Path(folder)))
    return checker.main(files)
