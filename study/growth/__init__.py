"""How cost grows: the k-th derivatives of the relations (15), (16), by several programs."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from functools import partial
from operator import itemgetter
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from kowalevski_cas.pictures import INK, new_figure
from study.charts import curve, display_name, seconds, size
from study.growth.programs import LIBRARIES, PROGRAMS, write_program
from study.process import race
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

TITLE = "how cost grows"

CASES = {"complex": "eq15", "real": "eq16.invariance"}
"""The variables, and the claim about the set whose relations are differentiated in them."""

SECONDS, MEBIBYTES, MOST = 12.0, 3072, 24

QUICK_SECONDS, QUICK_MOST = 2.0, 3

CAPTION = (
    "How cost grows: the $k$-th derivatives of the relations (15), in complex variables, and of "
    "(16), in real ones, are compared with those that the matrix of $F'=MF$ implies, "
    f"$M_{{k+1}}=M_k'+M_kM$, for $k$ up to {MOST}. The time is that of the processor for a whole "
    "process: its start, what it reads, and all steps so far; what it needs before the first step "
    f"stands at $k=0$. A cross is where a limit stopped a method: {SECONDS:g} s, or {MEBIBYTES} "
    "MiB. FLINT and residues are this program, with fractions, roots and constants as printed; "
    "every other is a program in the best words that were found for it, with polynomials that have "
    "integers as coefficients, and variables in which there is no root: matrices and "
    "derivatives of its own, recursive polynomials in PARI/GP, distributed ones in Giac, canonical "
    "rational expressions in Maxima. Residues look at points, prove nothing, and reach "
    f"{MOST} in both."
)

ROOM = 0.05
"""How much of the width of a panel the name of a line takes."""

WORK = Path(__file__).with_name("work.py")

OWN = ("flint", "modular")
"""The arithmetics of this program."""


def measure(quick: bool) -> Iterable[Task]:
    """Each method in each case, until a limit stops it."""
    limits = (QUICK_SECONDS, QUICK_MOST) if quick else (SECONDS, MOST)
    for case, claim in CASES.items():
        for method in OWN:
            yield Task(method, case, partial(_own, method, claim, *limits))
        for program in (*LIBRARIES, *PROGRAMS):
            yield Task(program, case, partial(_other, program, claim, *limits))


def _own(method: str, claim: str, seconds: float, most: int) -> Measured:
    command = [sys.executable, str(WORK), method, claim, str(most)]
    return race(command, Path.cwd(), seconds, MEBIBYTES, most)


def _other(program: str, claim: str, seconds: float, most: int) -> Measured:
    from study.growth.formulation import formulation  # SymPy has no part in what is measured

    with TemporaryDirectory() as folder:
        command = write_program(program, formulation(claim), most, Path(folder))
        return race(command, Path(folder), seconds, MEBIBYTES, most)


def draw(rows: Sequence[Row]) -> Figure:
    """A column a case: above the time until the k-th identity is decided, below the memory."""
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    figure = new_figure(height=6.0)
    panels = figure.subplots(2, len(CASES), sharex="col", sharey="row")
    words = {"times": ("time until $k$ is decided", seconds), "memory": ("most memory", size)}
    for line, (key, (label, units)) in zip(panels, words.items(), strict=True):
        line[0].set_ylabel(label)
        for axes, case in zip(line, CASES, strict=True):
            here = [row for row in rows if row["case"] == case and row.get("steps")]
            axes.set_yscale("log")
            axes.yaxis.set_major_formatter(FuncFormatter(units))
            axes.xaxis.set_major_locator(MaxNLocator(integer=True))
            for row in here:
                own = f"this program, {display_name(row['method'])}"
                curve(axes, row, "steps", key, own if row["method"] in OWN else "")
                axes.lines[-1].set(ms=3.5)
                if row["verdict"] != "reached":
                    end = row["steps"][-1:], row[key][-1:]
                    axes.plot(*end, color=INK, marker="x", ms=7, ls="none", mew=1.1)
            # Points alone do not grow: what is seen of them is what the others have beside it.
            ends = [row["steps"][-1] for row in here if row["method"] != "modular"]
            axes.set_xlim(-0.3, max(ends, default=MOST) + 0.6)
    for axes, case, number in zip(panels[0], CASES, ("(15)", "(16)"), strict=True):
        axes.set_title(f"{case} variables: {number}", size=8.5, pad=68)
        _name_lines(axes)
    for axes in panels[1]:
        axes.set_xlabel("$k$, the order of the derivative")
    return figure


def _name_lines(axes: Axes) -> None:
    """Write the name of each line, behind its mark, above its last point; side by side at one."""
    from numpy import asarray

    named = [(str(line.get_label()), line) for line in axes.lines]
    ends = [
        (float(asarray(line.get_xdata())[-1]), name, line)
        for name, line in named
        if not name.startswith("_")
    ]
    ends.sort(key=itemgetter(0))
    left, right = axes.get_xlim()
    room = (right - left) * ROOM
    places = [min(x, right - room / 2) for x, *_ in ends]
    for k in range(len(places) - 2, -1, -1):
        places[k] = min(places[k], places[k + 1] - room)
    above = axes.get_xaxis_transform()
    for place, (_, name, line) in zip(places, ends, strict=True):
        axes.plot(
            place, 1.04, color=line.get_color(), marker=line.get_marker(), ms=3.5,
            transform=above, clip_on=False,
        )  # fmt: skip
        axes.text(
            place, 1.07, name, color=INK, size=7, rotation=90,
            ha="center", va="bottom", transform=above,
        )  # fmt: skip
