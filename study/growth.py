"""How cost grows: the k-th derivatives of the relations (15), (16), in each arithmetic, by k."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Sequence
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.systems import SYSTEMS
from study.direct import recorded
from study.growth_chart import chart
from study.growth_programs import WORDS, growth_program
from study.race import race
from study.step import LEFT_OUT, Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "how cost grows"

CASES = {"complex": "eq15", "real": "eq16.invariance"}
"""The variables, and the claim about the set whose relations are differentiated in them."""

DIRECT = "python-flint"
OWN = (*EXACT, "modular", DIRECT)

SECONDS = 12.0
MEBIBYTES = 3072
MOST = 24

QUICK_SECONDS = 2.0
QUICK_MOST = 3

PREPARED = 6.0
"""How long the work is recorded for the programs to which it is given as a list, in seconds."""


def measure(quick: bool) -> Iterable[Task]:
    """Each method in each case, until a limit stops it."""
    seconds, most = (QUICK_SECONDS, QUICK_MOST) if quick else (SECONDS, MOST)
    for case in CASES:
        for method in OWN:
            yield Task(method, case, partial(_own, method, CASES[case], seconds, most))
        for program in WORDS:
            yield Task(program, case, partial(_program, program, CASES[case], seconds, most))


def _own(method: str, claim: str, seconds: float, most: int) -> Measured:
    arithmetic = "direct" if method == DIRECT else method
    module = "study.grow"
    path = os.pathsep.join(path for path in sys.path if path)
    command = [sys.executable, "-m", module, arithmetic, claim, str(most)]
    # What is timed alone has been recorded in the same process, which takes as long again.
    limit = 2 * seconds if method == DIRECT else seconds
    return race(command, Path.cwd(), limit, MEBIBYTES, {"PYTHONPATH": path})


def _program(program: str, claim: str, seconds: float, most: int) -> Measured:
    words, call = WORDS[program], SYSTEMS[program].call()
    with TemporaryDirectory() as folder:
        file = Path(folder) / f"growth{words.suffix}"
        steps = recorded(claim, most, min(PREPARED, seconds))
        file.write_text(growth_program(program, steps), encoding="utf-8")
        return race([*call, *words.options, file.name], Path(folder), seconds, MEBIBYTES)


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Time and memory against k."""
    return {"growth": chart([row for row in rows if row["verdict"] != LEFT_OUT])}
