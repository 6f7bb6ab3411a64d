"""How long proving, reporting and testing take, against the import of python-flint as the floor.

Each command is run in turn several times, so that a noisy moment of the machine touches all of
them; medians are printed, of the time and of the work of all processors, and ratios of the work.
A first round, which is not counted, compiles what is imported and writes the reports: later ones
find a PDF in place that is made of the same source. The tests are run once.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from statistics import median
from time import perf_counter

ROUNDS = 9

FLOOR = "import flint"
VERIFY = ("-m", "kowalevski_cas", "verify")
ALL = (*VERIFY, "--arithmetic", "all")
PAPERS = ("kharlamov2002", "kharlamov_savushkin2004")

COMMANDS = {
    FLOOR: ("-c", "import flint"),
    "the first paper, FLINT, cold": (*VERIFY, PAPERS[0]),
    "both papers, FLINT, cold": (*VERIFY, *PAPERS),
    "all derivations, FLINT, cold": VERIFY,
    "all derivations, SymEngine, cold": (*VERIFY, "--arithmetic", "symengine"),
    "all derivations, SymPy, cold": (*VERIFY, "--arithmetic", "sympy"),
    "all derivations, all three": ALL,
    "the certificates, by the checker": ("-m", "kowalevski_cas", "check", "-q"),
}

TESTS = ("-m", "pytest", "-q", "-n", "auto", "--dist", "loadfile", "-m", "not slow")


LOADED = f"""
import os, sys
from pathlib import Path
del os.fork  # all is done in this process
from kowalevski_cas.cli import main
main(["verify", {PAPERS[0]!r}])
package = Path(sys.modules["kowalevski_cas"].__file__).parent
files = {{Path(getattr(m, "__file__", None) or "/") for m in sys.modules.values()}}
own = [file for file in files if file.is_relative_to(package)]
print(sum(len(file.read_text("utf-8").splitlines()) for file in own), file=sys.stderr)
"""


def count_lines() -> int:
    """The lines of the package that are loaded after the first paper, with its certificates."""
    command = [sys.executable, "-c", LOADED]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return int(done.stderr)


def measure(arguments: Sequence[str]) -> tuple[float, float]:
    """The seconds of one run, as a process of its own, and those of all its processes together."""
    surroundings = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    start, before = perf_counter(), os.times()
    subprocess.run(
        [sys.executable, *arguments],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env=surroundings,
        check=True,
    )
    time, after = perf_counter() - start, os.times()
    work = after.children_user + after.children_system
    return time, work - before.children_user - before.children_system


def main() -> None:
    """Measure, and print a table."""
    with tempfile.TemporaryDirectory() as folder:
        commands = {**COMMANDS, "make verify, in place": (*ALL, "--report", folder)}
        runs: dict[str, list[tuple[float, float]]] = {name: [] for name in commands}
        for _ in range(ROUNDS + 1):
            for name, arguments in commands.items():
                runs[name].append(measure(arguments))
    counted = {name: values[1:] for name, values in runs.items()}
    counted["make test"] = [measure(TESTS)]
    floor = median(work for _, work in counted[FLOOR])
    print(f"{'':34}{'time':>10}{'fastest':>10}{'work':>10}{'ratio':>8}")
    for name, values in counted.items():
        times, works = zip(*values, strict=True)
        shown = "".join(f"{1000 * v:7.0f} ms" for v in (median(times), min(times), median(works)))
        print(f"{name:34}{shown}{median(works) / floor:8.1f}")
    print(f"{'lines loaded for the first paper':34}{count_lines():7}")


if __name__ == "__main__":
    main()
