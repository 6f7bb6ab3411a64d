"""Measure what each way of checking costs, how sure it is, and where it fails; draw the charts.

Measurements are stored in their order, at once: an interrupted study is continued by the same
command. Rows that another machine or other versions measured are not continued. With several
jobs the times are those of a machine that has other work.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path

from kowalevski_cas.cli import exits, session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, CommandError
from kowalevski_cas.pictures import save, style
from kowalevski_cas.pool import Pool
from study import STEPS, Row, load
from study.page import write_page
from study.step import DISAGREEMENT, ERROR, LEFT_OUT
from study.store import data_file, load_rows, measure

FULL, QUICK = Path("reports/study"), Path("build/study")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    words = f"one of {', '.join(STEPS)}; all of them if none is named"
    parser.add_argument("steps", nargs="*", metavar="STEP", help=words)
    parser.add_argument("--quick", action="store_true", help="small cases only, under a minute")
    words = f"write there ({FULL}; {QUICK} with --quick)"
    parser.add_argument("-o", "--output", type=Path, metavar="DIR", help=words)
    session.add_pool(parser, 1)
    again = parser.add_mutually_exclusive_group()
    again.add_argument("--afresh", action="store_true", help="forget what was measured before")
    again.add_argument("--draw", action="store_true", help="draw what is stored, measure nothing")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    unknown = [name for name in arguments.steps if name not in STEPS]
    if unknown:
        words = f"the study has no step “{unknown[0]}”; there are {', '.join(STEPS)}"
        raise CommandError(words, NOTHING)
    folder = arguments.output or (QUICK if arguments.quick else FULL)
    codes = [AS_RECORDED]
    for name in arguments.steps or STEPS:
        rows = _rows(name, folder, arguments)
        _draw(name, folder, rows)
        counts = Counter(row["verdict"] for row in rows)
        note = "".join(f", {counts[v]} {v}" for v in (LEFT_OUT, "timeout", ERROR) if counts[v])
        print(f"{name}: {load(name).TITLE}: {len(rows)} measurements{note}", flush=True)
        codes += map(_print_trouble, rows)
    if not arguments.quick:  # the captions are about the whole study
        write_page(folder)
    return exits.most_urgent(codes)


def _print_trouble(row: Row) -> int:
    """The exit code for a measurement, which is told if it is none."""
    if row["verdict"] == DISAGREEMENT:
        print(f"the exact arithmetics disagree: {row['reason']}", file=sys.stderr)
        return exits.DISAGREEMENT
    if row["verdict"] == ERROR:
        print(f"{row['method']} on {row['case']} failed: {row['reason']}", file=sys.stderr)
        return exits.UNDECIDED
    return AS_RECORDED


def _rows(name: str, folder: Path, arguments: argparse.Namespace) -> list[Row]:
    if not arguments.draw:
        with session.progress_bar() as progress:
            pool = Pool(arguments.jobs, arguments.scheduler)
            return measure(
                name, load(name), folder, arguments.quick, progress, arguments.afresh, pool
            )
    if rows := load_rows(name, folder):
        return rows
    raise CommandError(f"nothing is stored for “{name}” in {folder}", NOTHING)


def _draw(name: str, folder: Path, rows: list[Row]) -> None:
    try:
        with style():
            save(load(name).draw(rows), folder, name)
    except KeyError as missing:
        raise CommandError(
            f"“{name}” cannot be drawn: {missing} is missing in {data_file(folder, name)}; "
            f"measure it: python -m study {name} -o {folder}"
        ) from None
