"""Check certificates with the independent checker, and compare them with the record and the print.

It says in a line which statement each certificate proves or refutes, or why it is rejected; the
problem of each claim is written anew from the printed formulas. `python -I -S
kowalevski_cas/problem/checker FILE...` does so too, and trusts nothing else of this program.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from kowalevski_cas.cli import plain, session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, REJECTED
from kowalevski_cas.cli.theorems import readable
from kowalevski_cas.library import available, find, load, source
from kowalevski_cas.problem.checker import Certificate, printable
from kowalevski_cas.verify.certificate import FOLDER
from kowalevski_cas.verify.committed import Checked, Expected, check_committed, check_files
from kowalevski_cas.verify.outcome import CORRECTED, Verdict
from kowalevski_cas.verify.record import load_record


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument(
        "certificates",
        nargs="*",
        metavar="CERTIFICATE",
        help="a file, or a derivation whose certificates are meant; all of the library if none",
    )
    how_much = parser.add_mutually_exclusive_group()
    how_much.add_argument(
        "--full", action="store_true", help="say all of each theorem, as the file has it"
    )
    how_much.add_argument(
        "-q", "--quiet", action="store_true", help="do not say what the certificates prove"
    )


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    results = _check(arguments.certificates)
    for found in results if not arguments.quiet else ():
        if len(results) > 1 and found.derivation:
            print(plain.bold(found.derivation))
        for name, certificate in found.accepted.items():
            if not arguments.full:
                verdict, said = found.said.get(name) or _by_itself(certificate)
                print(plain.shorten(f"{plain.sign(verdict)}{said}"))
                continue
            print(f"{name.removesuffix(certificate.claim)}{certificate.summary()}")
            for line in certificate.lines():
                print(line)
    return tell(results)


def _by_itself(certificate: Certificate) -> tuple[Verdict, str]:
    """What a certificate proves of which nobody says to which derivation it belongs."""
    verdict = Verdict.PROVED if certificate.sign == "holds" else Verdict.REFUTED
    return verdict, readable(certificate.summary())


def tell(results: Sequence[Checked]) -> int:
    """Say how many certificates are accepted, and why others are not; the exit code."""
    certified = total = 0
    for found in results:
        for name, why in found.rejected.items():
            print(f"REJECTED {printable(ascii(name)[1:-1])}: {why}")
        if found.without:
            print(f"without a certificate: {', '.join(found.without)}", file=sys.stderr)
        certified, total = certified + len(found.accepted), total + found.total
    print(f"certificates: CERTIFIED {certified} of {total}")
    if not total:
        print("there are none: `kowalevski-cas record` writes them", file=sys.stderr)
    return NOTHING if not total else AS_RECORDED if certified == total else REJECTED


def _check(names: list[str]) -> list[Checked]:
    """What the checker says about files, and about each derivation."""
    files: dict[Path, list[Path]] = {}  # derivations may have claims of the same name
    for path in [Path(name) for name in names if name.endswith(".json")]:
        files.setdefault(path.parent.resolve(), []).append(path)
    folders = [name for name in names if not name.endswith(".json")] if names else available()
    derivations = [find(name) for name in folders]
    found = session.map_in_processes(_check_committed, derivations)
    return [*(check_files(paths, _about(at)) for at, paths in files.items()), *found]


def _check_committed(folder: Path) -> Checked:
    derivation = session.load_named(folder, str(folder))
    return check_committed(folder, derivation, load_record(folder) or {})


def _about(folder: Path) -> Expected | None:
    """What files in a folder have to be about, if it is that of a derivation's certificates."""
    folder = folder.parent if folder.name == CORRECTED else folder
    if folder.name != FOLDER or not source(folder.parent).is_file():
        return None
    return Expected(load(str(folder.parent)), load_record(folder.parent) or {})
