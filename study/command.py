"""Measure what each way of checking costs, how sure it is, and where it fails; draw the charts.

Every measurement is stored at once: an interrupted study is continued by the same
command. Rows that another machine or other versions measured are not continued.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path

from kowalevski_cas.cli import exits, session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, CommandError
from kowalevski_cas.pictures import save, style
from study import STEPS, load
from study.plates import write_plates
from study.step import DISAGREEMENT, LEFT_OUT
from study.store import data_file, measure, stored

FULL, QUICK = Path("reports/study"), Path("build/study")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument(
        "steps",
        nargs="*",
        metavar="STEP",
        help=f"one of {', '.join(STEPS)}; all of them if none is named",
    )
    parser.add_argument("--quick", action="store_true", help="small cases only, under a minute")
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar="DIR",
        help=f"write there ({FULL}; {QUICK} with --quick)",
    )
    again = parser.add_mutually_exclusive_group()
    again.add_argument("--afresh", action="store_true", help="forget what was measured before")
    again.add_argument("--draw", action="store_true", help="draw what is stored, measure nothing")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    unknown = [name for name in arguments.steps if name not in STEPS]
    if unknown:
        raise CommandError(
            f"the study has no step “{unknown[0]}”; there are {', '.join(STEPS)}", NOTHING
        )
    folder = arguments.output or (QUICK if arguments.quick else FULL)
    code = AS_RECORDED
    for name in arguments.steps or STEPS:
        step = load(name)
        if arguments.draw:
            rows = stored(name, folder)
            if not rows:
                raise CommandError(f"nothing is stored for “{name}” in {folder}", NOTHING)
        else:
            with session.progress_bar() as progress:
                rows = measure(name, step, folder, arguments.quick, progress, arguments.afresh)
        try:
            with style():
                for chart, figure in step.draw(rows).items():
                    save(figure, folder, chart)
        except KeyError as missing:
            raise CommandError(
                f"“{name}” cannot be drawn: {missing} is missing in {data_file(folder, name)}; "
                f"measure it: python -m study {name} -o {folder}"
            ) from None
        counts = Counter(row["verdict"] for row in rows)
        note = "".join(f", {counts[v]} {v}" for v in (LEFT_OUT, "timeout", "error") if counts[v])
        print(f"{name}: {step.TITLE}: {len(rows)} measurements{note}")
        sys.stdout.flush()
        for row in rows:
            if row["verdict"] == DISAGREEMENT:
                print(f"the exact arithmetics disagree: {row['reason']}", file=sys.stderr)
                code = exits.DISAGREEMENT
    write_plates(folder)
    return code
