"""Change one token of one formula at a time, and count what an audit notices.

A mutant is a sign, an index, an exponent, a coefficient or a letter changed, in a
definition, a vector field, a condition or a claim, so that the formula can still
be read. The seed of the sample is printed; --seed repeats it. With --alone the
paper is its own derivation, and mutants of laws, definitions, assumptions and
claims are counted apart.
"""

from __future__ import annotations

import argparse
import random
from collections import Counter
from pathlib import Path

from kowalevski_cas.cli import session
from kowalevski_cas.cli.audit import choose
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT, NOTHING, UNDECIDED, USAGE, CommandError
from kowalevski_cas.library import find
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
    parser.add_argument(
        "--alone",
        action="store_true",
        help="read the source as its own derivation; --sample is the number for each role",
    )
    parser.add_argument("--seed", type=int, metavar="N", help="seed of the sample")
    session.add_pool(parser)
    session.add_timeout(parser, 1)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    seed = random.SystemRandom().randrange(10**6) if arguments.seed is None else arguments.seed
    if arguments.alone:
        return _alone(arguments, seed)
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


def _alone(arguments: argparse.Namespace, seed: int) -> int:
    """Measure mutants of a paper that is its own derivation, and return the exit code."""
    if arguments.source is None:
        raise CommandError("--alone needs the paper's source", USAGE)
    source = read_source(arguments.source)
    print(f"{source.path} by itself, seed {seed}", flush=True)
    pool = session.pool(arguments, [])

    def measure_source(source: Source) -> Fates:
        work = Alone(source.path, source.text, arguments.timeout)
        return fates(work, draw_mutants(work, arguments.sample, random.Random(seed)), pool)

    (found,) = session.map_in_processes(measure_source, [source])
    pool.forget()
    if not found.results:
        raise CommandError("nothing green rests on what can be changed", NOTHING)
    print(report_alone(found), end="")
    return DIFFERENT if found.of(STRANGE, LOST) else UNDECIDED if found.of(LATE) else AS_RECORDED


def report_alone(found: Fates) -> str:
    """The share that was noticed, role by role; what is green and strange, or lost."""
    lines = []
    for role in ROLES:
        noticed, of = found.share(role)
        ends = Counter(result.end for result in found.results if result.role == role)
        counts = ", ".join(f"{ends[end]} {end}" for end in EXCLUDED if ends[end])
        lines.append(f"{role}: {noticed} of {of} noticed ({_percent(noticed, of)}); {counts or 0}")
    for end in (STRANGE, LOST, LATE):
        results = found.of(end)
        lines += [
            f"  {end:8} {result.role}, {result.mutant.words}: {result.words}" for result in results
        ]
    return "\n".join(lines) + "\n"


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
