r"""Precision: at how many bits a ball decides a near miss, and when floating point no longer does.

Near misses are true identities of which one side is multiplied by :math:`1+10^{-e}`,
so that the exact answer is "false" for every e.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import partial
from math import log2
from random import Random
from typing import TYPE_CHECKING

from kowalevski_cas.algebra import load_points
from kowalevski_cas.algebra.points import ExactPoint, Question
from kowalevski_cas.pictures import FAINT, new_figure
from study.charts import curve, marked
from study.paper import both, paper
from study.stability.material import sides
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "bits that a near miss takes"

IDENTITIES = ("eq5.1", "eq12", "F2-prime", "U1-prime", "eq21")

LARGEST = 120

STEP = 8
"""Bits are raised by so many."""

MOST = 1024


def measure(quick: bool) -> Iterable[Task]:
    """For each identity: bits for balls, and the verdicts of the others, over the exponents e."""
    exponents = [5, 40] if quick else list(range(2, 20)) + list(range(20, LARGEST + 1, 10))
    for id in IDENTITIES[:2] if quick else IDENTITIES:
        yield Task("ball", id, partial(bits, id, exponents))
        for method in ("floating", "modular"):
            yield Task(method, id, partial(verdicts, method, id, exponents))
        yield Task("exact", id, partial(exactly, id, exponents))


def near_miss(id: str, exponent: int) -> Question:
    """The identity, as corrected, with one side off by a little."""
    _, at = both(paper().claims[id].scene)
    left, right = sides(id, at)
    factor = at.ring.number(1 + Fraction(1, 10**exponent))
    return Question(at.programs, [at.carry(left * factor - right)])


def bits(id: str, exponents: Sequence[int]) -> Measured:
    """How many bits exclude zero at an exact random point; ``None`` beyond the last precision."""
    from flint import ctx

    from kowalevski_cas.algebra.ball import ball_point, exact_balls, random_point

    needed: list[int | None] = []
    for exponent in exponents:
        question = near_miss(id, exponent)
        point: ExactPoint = random_point(question.ring.generators, Random(1))
        for precision in range(STEP, MOST + 1, STEP):
            with ctx.workprec(precision):
                ball = ball_point(question.ring, exact_balls(point))(question.residuals[0])
                if ball.is_finite() and not ball.contains(0):
                    needed.append(precision)
                    break
        else:
            needed.append(None)
    return {"exponents": list(exponents), "bits": needed}


def verdicts(method: str, id: str, exponents: Sequence[int]) -> Measured:
    """Whether a method refutes the near miss."""
    points = load_points(method)
    answers = [points.answer(near_miss(id, exponent)).holds for exponent in exponents]
    return {"exponents": list(exponents), "refuted": [answer is False for answer in answers]}


def exactly(id: str, exponents: Sequence[int]) -> Measured:
    """The exact arithmetic refutes every near miss: the difference is not the zero polynomial."""
    at, _ = both(paper().claims[id].scene)
    left, right = sides(id, at)
    refuted = []
    for exponent in exponents:
        factor = at.ring.number(1 + Fraction(1, 10**exponent))
        refuted.append(not (left * factor - right).is_zero)
    return {"exponents": list(exponents), "refuted": refuted}


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Bits against e; the shade covers where floating point accepts what is false."""
    figure = new_figure(height=3.6)
    axes = figure.subplots()
    balls = [row for row in rows if row["method"] == "ball"]
    for mark, row in marked(balls):
        look = {**mark.line, "markersize": 3.5, "label": row["case"]}
        curve(axes, row["exponents"], row["bits"], **look)
    if balls:
        ends = min(balls[0]["exponents"]), max(balls[0]["exponents"])
        axes.plot(ends, [e * log2(10) for e in ends], color=FAINT, label=r"$e\,\log_2 10$")
    seen = [
        e
        for row in rows
        if row["method"] == "floating"
        for e, refuted in zip(row["exponents"], row["refuted"], strict=True)
        if refuted
    ]
    if seen:
        axes.axvspan(max(seen) + 0.5, LARGEST, color=FAINT, alpha=0.2, linewidth=0)
        words = f"beyond $10^{{-{max(seen)}}}$ floating point accepts them all"
        axes.text(max(seen) + 2, 8, words, fontsize=7)
    axes.set_xlabel(r"$e$: one side is off by the factor $1+10^{-e}$")
    axes.set_ylabel("bits at which a ball refutes")
    sure = [row["refuted"] for row in rows if row["method"] in ("exact", "modular")]
    denied = sum(map(sum, sure))
    axes.set_title(f"exact and modular arithmetic refute {denied} of {sum(map(len, sure))}")
    axes.legend(loc="upper left")
    return {"stability-precision": figure}
