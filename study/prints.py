"""How systems are read that others print, compared with what each of them means.

The file has a list of prints: their equations and the text beside them, what moves and how, claims
that are true and claims that are false (tests/data/prints/README.md). Each is typed into ``System``
as a stranger would do it, and every claim of it is decided.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Iterator
from enum import StrEnum
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

from kowalevski_cas import System
from kowalevski_cas.cli import run as run_command
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT
from kowalevski_cas.notation import Formula, Relation

Print = dict[str, Any]
"""A print, with what it means."""

GREEN = ("proved", "conditional")
BESIDE = ("where", "display", "given")
"""What a line of text beside the equations may be typed as."""


class PrintReading(StrEnum):
    """What becomes of a print."""

    MEANT = "read as meant"
    OPEN = "read as meant, with claims that are refused or not decided"
    MISREAD = "misread"
    REFUSED = "refused"


class PrintResult(NamedTuple):
    """What became of a print, and why."""

    reading: PrintReading
    words: tuple[str, ...] = ()


def read(entry: Print, seconds: float) -> PrintResult:
    """How a print is read: what moves, its rates or images, and its claims."""
    try:
        system, given = typed(entry)
    except ValueError as error:
        return PrintResult(PrintReading.REFUSED, (str(error),))
    system.seconds = seconds
    wrong, left = list[str](), list[str]()
    for words, expected, verdict in judged(entry, system, given):
        if verdict == "refuted" if expected else verdict in GREEN:
            wrong.append(f"{words}: {verdict}")
        elif verdict not in (*GREEN, "refuted"):
            left.append(f"{words}: {verdict}")
    if wrong:
        return PrintResult(PrintReading.MISREAD, tuple(wrong))
    return PrintResult(PrintReading.OPEN, tuple(left)) if left else PrintResult(PrintReading.MEANT)


def typed(entry: Print) -> tuple[System, tuple[str, ...]]:
    """The system, and what its claims are given.

    The text beside the equations is typed as a relation of constants, beside the equations, or as
    an equation that claims are given, what is possible first. Raises what the last try raises.
    """
    for kinds in sorted(product(BESIDE, repeat=len(entry["where"])), key=_order):
        sides = [*zip(kinds, entry["where"], strict=True)]
        display = [*entry["equations"], *(tex for kind, tex in sides if kind == "display")]
        given = tuple(tex for kind, tex in sides if kind == "given")
        try:
            system = System(r",\quad ".join(display), map=entry["map"])
            for kind, tex in sides:
                if kind == "where":
                    system = system.where(tex)
            for tex in given:
                _check_equation(system.read(tex), tex)
        except ValueError as error:
            last = error
        else:
            return system, given
    raise last


def _check_equation(formula: Formula, tex: str) -> None:
    if not isinstance(formula, Relation) or not formula.is_equality:
        raise ValueError(f"{tex} is no equation that a claim may be given")


def _order(kinds: tuple[str, ...]) -> list[int]:
    return [kinds.count("given"), *map(BESIDE.index, kinds)]


def judged(entry: Print, system: System, given: tuple[str, ...]) -> Iterator[tuple[str, bool, str]]:
    """Statements about a print, whether they are true, and the verdicts."""
    expected = entry["expected"]
    for name, rate in expected["fields"].items():
        yield _verdict(system, "identity", f"{_rate(name, system, expected)}={rate}", True, ())
    for true in (True, False):
        for claim in entry["true" if true else "false"]:
            # What holds everywhere is no theorem on the set where nothing else is possible.
            bound = claim.get("needs_hypothesis") or not true
            needed = given if bound and claim["kind"] == "integral" else ()
            yield _verdict(system, claim["kind"], claim["claim"], true, needed)


def _verdict(
    system: System, kind: str, tex: str, true: bool, given: tuple[str, ...]
) -> tuple[str, bool, str]:
    try:
        claim = getattr(system, kind)(tex, **({"given": given} if given else {}))
        verdict = str(claim.verdict)
        words = claim.outcome.message if verdict not in (*GREEN, "refuted") else ""
    except ValueError as error:
        verdict, words = "refused", str(error)
    return f"{kind} {tex}{words and f' ({words})'}", true, verdict


def _rate(name: str, system: System, expected: Print) -> str:
    """The rate, or the image, of a name, as it is printed."""
    if system.law.images:
        return dict(system.law.images).get(name.replace(r"\overline ", ""), name)
    time = expected["independent"]
    twice = name.removeprefix(r"\ddot ") if name.startswith(r"\ddot") else name.removesuffix("''")
    if twice != name and name not in expected["variables"]:
        return rf"\frac{{d^2{twice}}}{{d{time}^2}}"
    return rf"\frac{{d{name}}}{{d{time}}}"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("prints", type=Path, metavar="PRINTS.json")
    parser.add_argument("--half", choices=["open", "held"], help="one half of them only")
    parser.add_argument("--only", action="append", default=[], metavar="ID", help="these only")
    session.add_timeout(parser, 10)
    parser.add_argument("-v", "--verbose", action="store_true", help="say what became of each")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    count = Counter[PrintReading]()
    for entry in json.loads(arguments.prints.read_text(encoding="utf-8")):
        if arguments.half not in (None, entry["half"]):
            continue
        if arguments.only and entry["id"] not in arguments.only:
            continue
        found = read(entry, arguments.timeout)
        count[found.reading] += 1
        if arguments.verbose:
            print(f"{entry['id']}: {found.reading}", *found.words, sep="\n    ", flush=True)
    print("; ".join(f"{count[reading]} {reading}" for reading in PrintReading))
    return DIFFERENT if count[PrintReading.MISREAD] else AS_RECORDED


if __name__ == "__main__":
    sys.exit(run_command("python -m study.prints", "study.prints", sys.argv[1:]))
