"""How long proving and reporting take, against the import of python-flint as the floor.

Each command is run in turn several times, so that a noisy moment of the machine
touches all of them; medians and ratios are printed.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from statistics import median
from time import perf_counter

ROUNDS = 9

COMMANDS = {
    "import flint": ["-c", "import flint"],
    "the first paper, FLINT, cold": [
        "-m",
        "kowalevski_cas",
        "verify",
        "kharlamov2002",
        "--arithmetic",
        "flint",
    ],
    "verify, FLINT, cold": ["-m", "kowalevski_cas", "verify", "--arithmetic", "flint"],
    "verify, SymEngine, cold": ["-m", "kowalevski_cas", "verify", "--arithmetic", "symengine"],
    "verify, SymPy, cold": ["-m", "kowalevski_cas", "verify", "--arithmetic", "sympy"],
    "verify, all three": ["-m", "kowalevski_cas", "verify"],
}


def measure(arguments: list[str]) -> float:
    """The time of one run, in seconds, as a process of its own."""
    start = perf_counter()
    subprocess.run(
        [sys.executable, *arguments],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        check=True,
    )
    return perf_counter() - start


def main() -> None:
    """Measure, and print a table."""
    with tempfile.TemporaryDirectory() as folder:
        commands = {
            **COMMANDS,
            "verify, all three, with the report": [
                "-m", "kowalevski_cas", "verify", "--report", folder,
            ],
        }  # fmt: skip
        times: dict[str, list[float]] = {name: [] for name in commands}
        for _ in range(ROUNDS):
            for name, arguments in commands.items():
                times[name].append(measure(arguments))
    floor = median(times["import flint"])
    print(f"{'':38}{'median':>10}{'fastest':>10}{'slowest':>10}{'ratio':>8}")
    for name, values in times.items():
        shown = "".join(f"{1000 * v:7.0f} ms" for v in (median(values), min(values), max(values)))
        print(f"{name:38}{shown}{median(values) / floor:8.1f}")


if __name__ == "__main__":
    main()
