"""Change one token of papers that are their own derivations, and count what an audit notices.

Mutants of laws, definitions, assumptions and claims are counted apart, as many of each role and
paper, where something that is green rests on what is changed.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path
from random import Random

from kowalevski_cas.cli import run as run_command
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT, NOTHING, UNDECIDED, CommandError
from kowalevski_cas.source.files import read_source
from kowalevski_cas.source.text import Source
from study.mutants.alone import (
    EXCLUDED,
    LATE,
    LOST,
    ROLES,
    STRANGE,
    Alone,
    Fates,
    draw_mutants,
    fates,
)

SEED = 1
SIZE = 2
"""For each role of a paper."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("papers", nargs="+", type=Path, metavar="PAPER.tex", help="to be changed")
    words = f"how many for each role ({SIZE})"
    parser.add_argument("--sample", type=int, default=SIZE, metavar="N", help=words)
    parser.add_argument("--seed", type=int, default=SEED, metavar="N", help=f"({SEED})")
    session.add_pool(parser)
    session.add_timeout(parser, 5)


def run(arguments: argparse.Namespace) -> int:
    """Measure, print what is not noticed of each paper, and the counts of all."""
    total = Fates()
    pool = session.pool(arguments, [])

    def measure(source: Source) -> Fates:
        work = Alone(source.path, source.text, arguments.timeout)
        random = Random(f"{arguments.seed} {Path(source.path).stem}")
        return fates(work, draw_mutants(work, arguments.sample, random), pool)

    for path in arguments.papers:
        (found,) = session.map_in_processes(measure, [read_source(path)])
        print(f"{path.stem}:\n{report(found)}", end="", flush=True)
        total.results += found.results
    pool.forget()
    if not total.results:
        raise CommandError("nothing green rests on what can be changed", NOTHING)
    print(f"all, seed {arguments.seed}:\n{shares(total)}", end="")
    ends = {result.end for result in total.results}
    return DIFFERENT if ends & {STRANGE, LOST} else UNDECIDED if LATE in ends else AS_RECORDED


def shares(found: Fates) -> str:
    """The share that was noticed, role by role, and what is not counted."""
    lines = []
    for role in ROLES:
        noticed, of = found.share(role)
        ends = Counter(result.end for result in found.results if result.role == role)
        counts = "".join(f"; {ends[end]} {end}" for end in (*EXCLUDED, LATE) if ends[end])
        share = f" ({100 * noticed / of:.0f} %)" if of else ""
        lines.append(f"  {role}: {noticed} of {of} noticed{share}{counts}\n")
    return "".join(lines)


def report(found: Fates) -> str:
    """The shares, and what is green and strange, or lost."""
    lines = [
        f"  {result.end:8} {result.role}, {result.mutant.words}: {result.words}\n"
        for result in found.of(STRANGE, LOST, LATE)
    ]
    return shares(found) + "".join(lines)


if __name__ == "__main__":
    sys.exit(run_command("python -m study.mutants.papers", "study.mutants.papers", sys.argv[1:]))
