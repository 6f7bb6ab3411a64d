"""How cost grows: the k-th derivatives of the relations (15), (16), in each arithmetic, by k."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.pictures import INK, new_figure
from study.charts import curve, label_ends, seconds, size
from study.growth.trace import LANGUAGES, program, record_steps
from study.process import race
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "how cost grows"

CASES = {"complex": "eq15", "real": "eq16.invariance"}
"""The variables, and the claim about the set whose relations are differentiated in them."""

SECONDS, MEBIBYTES, MOST = 12.0, 3072, 24

QUICK_SECONDS, QUICK_MOST = 2.0, 3

CAPTION = (
    "How cost grows: the $k$-th derivatives of the relations (15), in complex variables, and of "
    "(16), in real ones, are compared with those that the matrix of $F'=MF$ implies, "
    f"$M_{{k+1}}=M_k'+M_kM$, for $k$ up to {MOST}. A cross is where a limit stopped a method: "
    f"{SECONDS:g} s of the processor, as all times are, or {MEBIBYTES} MiB. python-flint "
    "alone, Singular and PARI/GP are given the same operations on polynomials as a program, "
    "without this one around them, which each of them reads line by line while its clock runs "
    "(in Python most of the time for the first steps, and a tenth of that for the last). "
    "Residues look at points, and prove nothing."
)


def measure(quick: bool) -> Iterable[Task]:
    """Each method in each case, until a limit stops it."""
    limits = (QUICK_SECONDS, QUICK_MOST) if quick else (SECONDS, MOST)
    for case, claim in CASES.items():
        for method in (*EXACT, "modular"):
            yield Task(method, case, partial(_own, method, claim, *limits))
        for language in LANGUAGES:
            yield Task(language, case, partial(_other, language, claim, *limits))


def _own(method: str, claim: str, seconds: float, most: int) -> Measured:
    command = [sys.executable, "-m", "study.growth", method, claim, str(most)]
    return race(command, Path.cwd(), seconds, MEBIBYTES)


def _other(name: str, claim: str, seconds: float, most: int) -> Measured:
    """A program that is given the work as a list, as far as FLINT comes in twice the time."""
    language = LANGUAGES[name]
    call = language.call()
    with TemporaryDirectory() as folder:
        file = Path(folder) / f"growth{language.suffix}"
        text = program(language, *record_steps(claim, most, 2 * seconds))
        file.write_text(text, encoding="utf-8")
        return race([*call, file.name], Path(folder), seconds, MEBIBYTES)


def draw(rows: Sequence[Row]) -> Figure:
    """A column a case: above the time until the k-th identity is decided, below the memory."""
    from matplotlib.ticker import FuncFormatter

    figure = new_figure(height=5.6)
    panels = figure.subplots(2, len(CASES), sharex="col", sharey="row")
    words = {"times": ("time until $k$ is decided", seconds), "memory": ("most memory", size)}
    for line, (key, (label, units)) in zip(panels, words.items(), strict=True):
        line[0].set_ylabel(label)
        for axes, case in zip(line, CASES, strict=True):
            # A clock of milliseconds says 0 before its first tick: that is no point of the chart.
            axes.set_yscale("log", nonpositive="mask")
            axes.set_xticks(range(0, MOST + 1, 4))
            axes.yaxis.set_major_formatter(FuncFormatter(units))
            for row in rows:
                if row["case"] == case and row.get("steps"):
                    curve(axes, row, "steps", key)
                    axes.lines[-1].set(ms=3.5)
                    if row["verdict"] != "reached":
                        end = row["steps"][-1:], row[key][-1:]
                        axes.plot(*end, color=INK, marker="x", ms=7, ls="none", mew=1.1)
    for axes, case, number in zip(panels[0], CASES, ("(15)", "(16)"), strict=True):
        axes.set_title(f"{case} variables: {number}", size=8.5)
    for axes in panels[1]:
        axes.set_xlabel("$k$, the order of the derivative")
        left, right = axes.get_xlim()
        axes.set_xlim(left, right + 0.45 * (right - left))
    for axes in panels.flat:
        label_ends(axes)
    return figure
