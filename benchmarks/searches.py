"""How long searches take, and how much memory, against the committed rows of ``searches.json``.

Each search is a process of its own, whose work is counted in CPU seconds and, so that machines can
be compared, in multiples of a fixed calculation of FLINT that is timed in the same run. A row that
takes half as much again as the committed one is told as a warning, in the words of GitHub's log.
With ``--write`` the rows are committed anew.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from random import Random
from statistics import median
from subprocess import DEVNULL, Popen

ROWS = Path(__file__).with_suffix(".json")

ROUNDS = 3

SLOWER = 1.5

CALCULATION = (
    "from random import Random; from flint import nmod_mat; random = Random(1); "
    "nmod_mat(1000, 1000, [random.getrandbits(60) for _ in range(10**6)], 2**61 - 1).rref()"
)

Row = dict[str, float]


def cycle(size: int) -> str:
    """The lattice of Volterra."""
    names = [f"x_{{{k}}}" for k in range(1, size + 1)]
    return r",\ ".join(
        rf"\dot {x}={x}({names[(k + 1) % size]}-{names[k - 1]})" for k, x in enumerate(names)
    )


def chain(size: int) -> str:
    """The open lattice of Toda, in the variables of Flaschka."""
    rates = [rf"\dot a_{k}=a_{k}(b_{k + 1}-b_{k})" for k in range(1, size)]
    for k in range(1, size + 1):
        terms = [f"+2a_{k}^2" if k < size else "", f"-2a_{k - 1}^2" if k > 1 else ""]
        rates.append(rf"\dot b_{k}=" + "".join(terms).removeprefix("+"))
    return r",\ ".join(rates)


def dense(size: int) -> str:
    """A field with all quadratic terms, and coefficients from −5 to 5 that are not zero."""
    random, names = Random(1), [f"x_{k}" for k in range(1, size + 1)]
    pairs = [names[i] + names[j] for i in range(size) for j in range(i, size)]
    numbers = [n for n in range(-5, 6) if n]
    return r",\ ".join(
        rf"\dot {x}=" + "".join(f"{random.choice(numbers):+d}{pair}" for pair in pairs)
        for x in names
    ).replace("=+", "=")


KOWALEVSKI = r"2\dot p=qr,\ 2\dot q=-pr-z,\ \dot r=y,\ \dot x=ry-qz,\ \dot y=pz-rx,\ \dot z=qx-py"
TWO_FIELDS = (
    r"2\dot p=qr+f_3,\ 2\dot q=-pr-e_3,\ \dot r=e_2-f_1,\ \dot e_1=re_2-qe_3,\ "
    r"\dot e_2=pe_3-re_1,\ \dot e_3=qe_1-pe_2,\ \dot f_1=rf_2-qf_3,\ "
    r"\dot f_2=pf_3-rf_1,\ \dot f_3=qf_1-pf_2"
)
LORENZ = r"\dot x=s(y-x),\ \dot y=rx-y-xz,\ \dot z=xy-bz"

SYSTEMS = {
    "two_fields": TWO_FIELDS, "kowalevski": KOWALEVSKI, "lorenz": LORENZ, "toda": chain(5),
    "dense": dense(5), "volterra20": cycle(20), "volterra30": cycle(30),
}  # fmt: skip

SEARCHES = (
    "integrals two_fields.py --weighted --degree 8",
    "integrals two_fields.py --degree 7",
    "integrals two_fields.py --degree 8",
    "integrals toda.py --degree 7",
    "integrals toda.py --degree 8",
    "integrals kowalevski.py --degree 10",
    "integrals dense.py --degree 8",
    "integrals dense.py --degree 9",
    "integrals volterra30.py --degree 3",
    "integrals volterra20.py --degree 4",
    "darboux lorenz.py --degree 6",
    "darboux lorenz.py --degree 7",
    "darboux lorenz.py --degree 6 --special",
    "darboux kowalevski.py --degree 5",
)


@dataclass(frozen=True)
class Measured:
    """CPU seconds of a process and those that it began, and the memory of the largest, in MB."""

    seconds: float
    memory: float


def measure(words: Sequence[str], folder: str) -> Measured:
    """Run Python with these words in a folder."""
    process = Popen([sys.executable, *words], cwd=folder, stdout=DEVNULL, stderr=DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 3):  # 3: nothing was found, or it was left open
        raise SystemExit(f"{' '.join(words)}: exit code {process.returncode}")
    return Measured(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000)


def rows() -> dict[str, Row]:
    """The searches by their command lines, with medians of what they take."""
    with tempfile.TemporaryDirectory() as folder:
        for name, motion in SYSTEMS.items():
            text = f'from kowalevski_cas import System\n\nsystem = System(r"{motion}")\n'
            (Path(folder) / f"{name}.py").write_text(text, encoding="utf-8")
        found: dict[str, list[Measured]] = {search: [] for search in SEARCHES}
        floor = []
        for _ in range(ROUNDS):
            floor.append(measure(["-c", CALCULATION], folder).seconds)
            for search, values in found.items():
                words = ("-m", "kowalevski_cas", "find", *search.split(), "--jobs", "1")
                values.append(measure([*words, "--timeout", "600"], folder))
    return {
        f"kowalevski-cas find {search}": {
            "seconds": round(seconds := median(one.seconds for one in values), 2),
            "ratio": round(seconds / median(floor), 2),
            "MB": round(max(one.memory for one in values)),
        }
        for search, values in found.items()
    }


def main() -> None:
    """Measure, print a table, and say what became slower."""
    known = json.loads(ROWS.read_text(encoding="utf-8")) if ROWS.exists() else {}
    found = rows()
    print(f"{'':62}{'CPU':>9}{'ratio':>8}{'was':>8}{'memory':>10}")
    for search, row in found.items():
        was = known.get(search, {}).get("ratio")
        shown = f"{row['seconds']:7.2f} s{row['ratio']:8.2f}{was or '':>8}{row['MB']:7.0f} MB"
        print(f"{search:62}{shown}")
        if was and row["ratio"] > SLOWER * was:
            print(f"::warning::{search} takes {row['ratio'] / was:.1f} times what it took")
    if "--write" in sys.argv[1:]:
        ROWS.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
