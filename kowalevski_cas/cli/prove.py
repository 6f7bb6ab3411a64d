"""Prove or deny a problem that anybody has written, and print its certificate.

The problem has the spaces and goals of a certificate (docs/certificate.md); whatever else the file
has is not looked at. The certificate is accepted by the checker, on its own, before it is printed.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, UNDECIDED, CommandError
from kowalevski_cas.limits import time_limit
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.codec import read_problem
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.certificate import certificate
from kowalevski_cas.verify.statement import Posed, find_evidence


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("problem", type=Path, metavar="PROBLEM.json", help="the file to read")
    session.add_timeout(parser, 60, "for the search")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    path: Path = arguments.problem
    try:
        with open(path, encoding="utf-8") as file:
            text = file.read(checker.SIZE)
        data = json.loads(text)
        name = data.get("claim", path.stem)
        posed = Posed(name, read_problem(data))
    except (OSError, ValueError, AttributeError, RecursionError) as error:
        raise CommandError(f"{path}: {error}") from None

    def certify(posed: Posed) -> str:
        with time_limit(arguments.timeout):
            return _certificate(posed)

    try:
        (found,) = session.map_in_processes(certify, [posed])
        checker.check(found)
    except TimeoutError:
        raise CommandError(
            f"{path}: nothing is found in {arguments.timeout:g} s", UNDECIDED
        ) from None
    except checker.Rejected as error:
        raise CommandError(f"{path}: the checker says: {error}", UNDECIDED) from None
    except (Unproved, Meaningless, FormatError) as error:
        raise CommandError(f"{path}: {error}", UNDECIDED) from None
    print(found, end="")
    return AS_RECORDED


def _certificate(posed: Posed) -> str:
    """The certificate of a problem; raises :class:`Unproved` if no evidence is found."""
    found = find_evidence(posed.goals, {})
    if found is None:
        raise Unproved("neither a proof nor a point where it fails was found")
    judge = Judge(finder_of)
    if isinstance(found, Denial):
        judge.denies(posed.goals[found.goal], found.evidence)
    else:
        for goal, evidence in zip(posed.goals, found, strict=True):
            judge.holds(goal, evidence)
    return certificate(posed, found, judge.accepted)
