"""Prove or refute the claims of a derivation, and compare with its record.

Results go to stdout, progress and notes to stderr. An arithmetic of points only
screens: it refutes, or finds nothing against a claim, and proves none. A screening
is as recorded if it denies no verdict of the record.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from time import sleep

from kowalevski_cas import UserError
from kowalevski_cas.algebra import EXACT, POINTS
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, CommandError, most_urgent
from kowalevski_cas.cli.formats import FORMATS, ComparedRun, load_format
from kowalevski_cas.library import READ, available, find, source
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.verify.certificate import Stored
from kowalevski_cas.verify.outcome import Run
from kowalevski_cas.verify.record import (
    contradictions,
    differences,
    load_record,
    unexpected_verdicts,
)

PAUSE = 0.2
"""Seconds between two looks at the files that are watched."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
    parser.add_argument(
        "--only", action="append", default=[], metavar="ID", help="these claims only (repeatable)"
    )
    parser.add_argument(
        "--arithmetic",
        choices=(*EXACT, "all", *POINTS),
        default=EXACT[0],
        help=f"decide in this arithmetic ({EXACT[0]}), or in all three, which have to agree; "
        f"{', '.join(POINTS)} screen at points",
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="N", help="chooses the points of a screening (1)"
    )
    session.add_format(parser, FORMATS, "claim")
    parser.add_argument("--report", type=Path, metavar="DIR", help="write the report there as well")
    session.add_timeout(parser, 60)
    parser.add_argument(
        "--watch", action="store_true", help="verify again whenever a file is saved, until Ctrl-C"
    )


def run_derivations(arguments: argparse.Namespace) -> list[ComparedRun]:
    """Run the derivations and compare them with their records."""
    chosen = session.derivations(arguments.derivations, arguments.only)
    arithmetics = EXACT if arguments.arithmetic == "all" else (arguments.arithmetic,)
    runs = session.runs(
        chosen, arithmetics, arguments.only, arguments.report is not None, arguments.timeout,
        seed=arguments.seed,
    )  # fmt: skip
    versions = (
        session.versions() if arguments.report is not None or arguments.format == "json" else {}
    )
    return [
        compare_with_record(*one, run._replace(versions=versions), texts, not arguments.only)
        for one, (run, texts) in zip(chosen, runs, strict=True)
    ]


def compare_with_record(
    folder: Path, derivation: Derivation, found: Run, texts: Texts, whole: bool
) -> ComparedRun:
    """A run beside the record in a folder, of all claims if it is whole."""
    record, said = load_record(folder), derivation.expected
    if record is None:
        differing = unexpected_verdicts(found, said)
    elif found.arithmetics[0] in POINTS:
        differing = contradictions(found, record)
    else:
        differing = differences(found, record, whole)
        against = (
            difference
            for difference in unexpected_verdicts(found, said)
            if difference.claim in said
        )
        words = "against the file, which expects {}"
        differing += [
            difference._replace(recorded=words.format(difference.recorded))
            for difference in against
        ]
    return ComparedRun(folder, derivation, texts, found, differing, record is not None)


def failure_text(
    folder: Path, derivation: Derivation, stored: Mapping[str, Stored], claim: str, seconds: float
) -> str:
    """What a terminal says of a claim, if it is not as recorded or expected; else nothing."""
    chosen = [(folder, derivation)]
    (found,) = session.runs(chosen, ["flint"], [claim], timeout=seconds, stored=[stored])
    result = compare_with_record(folder, derivation, *found, False)
    return "" if result.exit_code == AS_RECORDED else load_format("pretty").render([result])


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    return _watch(arguments) if arguments.watch else _verify(arguments)


def _watch(arguments: argparse.Namespace) -> int:
    """Verify whenever a file is saved; the exit code of the last time."""
    code, before = AS_RECORDED, None
    with suppress(KeyboardInterrupt):
        while True:
            if (now := _save_times(arguments.derivations)) != before:
                try:
                    code = _verify(arguments)
                except UserError as error:
                    code = error.code
                    print(error, file=sys.stderr)
                before = READ | now
                print("waiting for a file to be saved; Ctrl-C ends", file=sys.stderr)
            sleep(PAUSE)
    return code


def _save_times(names: Sequence[str]) -> dict[Path, int]:
    """When the files of derivations were saved, and those that they read."""
    sources = [source(find(name)) for name in names or available()]
    evidence = {
        file
        for source in sources
        if source.name == "__init__.py"
        for file in source.parent.glob("*.py")
    }
    return {
        file: file.stat().st_mtime_ns for file in {*sources, *evidence, *READ} if file.is_file()
    }


def _verify(arguments: argparse.Namespace) -> int:
    if arguments.report is not None and arguments.arithmetic in POINTS:
        raise CommandError(
            f"a report says what is proved, and {arguments.arithmetic} proves nothing: "
            f"choose {', '.join(EXACT)} or all"
        )
    results = run_derivations(arguments)
    print(load_format(arguments.format).render(results), end="")
    sys.stdout.flush()
    codes = [result.exit_code for result in results]
    if arguments.report is not None:
        from kowalevski_cas.cli.report import write

        codes.append(write(results, arguments.report))
    return most_urgent(codes)
