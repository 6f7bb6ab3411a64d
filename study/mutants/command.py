"""Change one token of one formula at a time, and count what an audit notices.

A mutant is a sign, an index, an exponent, a coefficient or a letter changed, in a
definition, a vector field, a condition or a claim, so that the formula can still
be read. The seed of the sample is printed; --seed repeats it.
"""

from __future__ import annotations

import argparse
import random
from collections import Counter
from pathlib import Path

from kowalevski_cas.cli import session
from kowalevski_cas.cli.audit import choose
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT, NOTHING, UNDECIDED, CommandError
from kowalevski_cas.library import find
from kowalevski_cas.source.files import read_source
from kowalevski_cas.source.text import Source
from study.mutants.catching import Measure, Measurement, measure
from study.mutants.mutant import every, sample
from study.mutants.synthetic import synthetic


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument(
        "source",
        nargs="?",
        type=Path,
        metavar="PAPER.tex",
        help="the source to change (if it is not there, the formulas of the derivation)",
    )
    parser.add_argument("--derivation", metavar="NAME", help="name in the library, or folder")
    parser.add_argument("--sample", type=int, default=300, metavar="N", help="how many (300)")
    parser.add_argument("--all", action="store_true", help="every mutant instead of a sample")
    parser.add_argument("--seed", type=int, metavar="N", help="seed of the sample")
    session.add_pool(parser)
    session.add_timeout(parser, 1)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    seed = random.SystemRandom().randrange(10**6) if arguments.seed is None else arguments.seed
    if arguments.source is not None and arguments.source.exists():
        source = read_source(arguments.source)
        folder, derivation = choose(source, arguments.derivation)
    else:
        name = [] if arguments.derivation is None else [arguments.derivation]
        folder, derivation = session.derivations(name)[0]
        source = synthetic(derivation)
    print(f"{source.path} by {derivation.name}, seed {seed}", flush=True)

    pool = session.pool(arguments, [folder, *(find(basis.name) for basis in derivation.bases())])

    def measure_source(source: Source) -> Measurement:
        work = Measure(folder, source.path, source.text, arguments.timeout)
        choose = random.Random(seed)
        mutants = every(work.base) if arguments.all else sample(work.base, arguments.sample, choose)
        return measure(work, list(mutants), pool)

    (found,) = session.map_in_processes(measure_source, [source])
    pool.forget()
    if not found.results:
        raise CommandError("no mutants can be made of this source", NOTHING)
    print(report(found), end="")
    return DIFFERENT if found.escapes else UNDECIDED if found.late else AS_RECORDED


def report(found: Measurement) -> str:
    """The share that was caught, by role and kind; survivors with reasons; repairs."""
    caught, of = found.share()
    lines = [
        f"{len(found.results)} mutants in {found.seconds:.1f} s; "
        f"{caught} of {of} that are not equivalent are caught ({_percent(caught, of)})"
    ]
    named = sum(result.named for result in found.results if result.is_caught)
    lines.append(f"the changed place is named for {named} of {caught} ({_percent(named, caught)})")
    lines.append(f"by role: {_by(found, [result.role for result in found.results])}")
    lines.append(f"by kind: {_by(found, [result.mutant.kind for result in found.results])}")
    lines += _repairs(found)
    for result in found.survivors:
        if result.equivalent:
            lines.append(f"  equivalent  {result.mutant.words}: {result.equivalent}")
    lines += [f"  MISSED      {result.mutant.words}" for result in found.escapes]
    lines += [f"  not in time {result.mutant.words}" for result in found.late]
    unnamed = [result for result in found.results if result.is_caught and not result.named]
    lines += [f"  not named   {r.mutant.words}: {', '.join(r.changed[:3])}" for r in unnamed]
    return "\n".join(lines) + "\n"


def _by(found: Measurement, names: list[str]) -> str:
    """How many are caught or equivalent, of how many, for each name."""
    pairs = zip(names, found.results, strict=True)
    counts = Counter((name, r.is_caught or bool(r.equivalent)) for name, r in pairs)
    return ", ".join(
        f"{n} {counts[n, True]}/{counts[n, True] + counts[n, False]}" for n in sorted(set(names))
    )


def _repairs(found: Measurement) -> list[str]:
    """How often a mutated claim is repaired, by what, and how long it takes."""
    counts = found.repairs()
    total = sum(counts.values())
    if not total:
        return []
    times = sorted(result.seconds for result in found.results if result.repair)
    return [
        f"repairs of {total} claims: {counts['restored']} by the edit that restores them, "
        f"{counts['derivation']} by what the derivation has, {counts['true']} by another true "
        f"formula, {counts['none']} none",
        f"seconds for one: median {times[total // 2]:.2f}, most {times[-1]:.2f}",
    ]


def _percent(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} %" if whole else "none"
