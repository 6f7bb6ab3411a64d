"""What commands take, against committed rows: CPU seconds, memory, multiples of a calculation.

Each command is a process of its own, whose work is counted in CPU seconds and, so that machines can
be compared, in multiples of a fixed calculation of FLINT that is timed in the same run. A row that
takes half as much again as the committed one is told as a warning, in the words of GitHub's log.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from subprocess import DEVNULL, Popen

ROUNDS = 3

SLOWER = 1.5

CALCULATION = (
    "from random import Random; from flint import nmod_mat; random = Random(1); "
    "nmod_mat(1000, 1000, [random.getrandbits(60) for _ in range(10**6)], 2**61 - 1).rref()"
)

ACCEPTED = (0, 3)
"""Exit codes of a command that was not stopped; 3: nothing was found, or it was left open."""

Row = dict[str, float]


@dataclass(frozen=True)
class Measured:
    """CPU seconds of a process and those that it began, and the memory of the largest, in MB."""

    seconds: float
    memory: float


def measure(words: Sequence[str], folder: str) -> Measured:
    """Run Python with these words in a folder; what is imported may be compiled once."""
    surroundings = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    process = Popen(
        [sys.executable, *words], cwd=folder, env=surroundings, stdout=DEVNULL, stderr=DEVNULL
    )
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in ACCEPTED:
        raise SystemExit(f"{' '.join(words)}: exit code {process.returncode}")
    return Measured(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000)


def measure_rows(commands: Sequence[str], folder: str) -> dict[str, Row]:
    """The commands in turn, several times, with medians of what they take."""
    found: dict[str, list[Measured]] = {command: [] for command in commands}
    floor = []
    for _ in range(ROUNDS):
        floor.append(measure(["-c", CALCULATION], folder).seconds)
        for command, values in found.items():
            values.append(measure(["-m", "kowalevski_cas", *command.split()[1:]], folder))
    return {
        command: {
            "seconds": round(seconds := median(one.seconds for one in values), 2),
            "ratio": round(seconds / median(floor), 2),
            "MB": round(max(one.memory for one in values)),
        }
        for command, values in found.items()
    }


def compare(found: Mapping[str, Row], file: Path) -> None:
    """Print a table, and what became slower than the rows of a file; or write them (--write)."""
    known = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    print(f"{'':78}{'CPU':>9}{'ratio':>8}{'was':>8}{'memory':>10}")
    for command, row in found.items():
        was = known.get(command, {}).get("ratio")
        shown = f"{row['seconds']:7.2f} s{row['ratio']:8.2f}{was or '':>8}{row['MB']:7.0f} MB"
        print(f"{command:78}{shown}")
        if was and row["ratio"] > SLOWER * was:
            print(f"::warning::{command} takes {row['ratio'] / was:.1f} times what it took")
    if "--write" in sys.argv[1:]:
        file.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
