r"""Precision: at how many bits a ball decides a near miss, and when floating point no longer does.

Near misses are true identities of which one side is multiplied by :math:`1+10^{-e}`,
so that the exact answer is "false" for every e.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import islice
from pathlib import Path
from random import Random
from time import perf_counter

from kowalevski_cas.arithmetic import load_points
from kowalevski_cas.arithmetic.points import ExactPoint, Question
from kowalevski_cas.arithmetic.programs import Program
from kowalevski_cas.notation import Relation
from kowalevski_cas.stage import scalar
from study.stability.material import bench, claim, paper, stages
from study.step import Measured, Row, Task

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
        yield Task("ball", id, lambda i=id: bits(i, exponents))  # type: ignore[misc]
        for method in ("floating", "modular"):
            yield Task(method, id, lambda m=method, i=id: verdicts(m, i, exponents))  # type: ignore[misc]
        yield Task("exact", id, lambda i=id: exactly(i, exponents))  # type: ignore[misc]


def near_miss(id: str, exponent: int) -> Question:
    """The identity, as corrected, with one side off by a little."""
    printed = claim(id).printed
    assert printed is not None
    _, stage = stages(claim(id).scene)
    formula = paper()[1].formula(printed)
    assert isinstance(formula, Relation)
    left, right = (scalar(member, stage) for member in formula.members[:2])
    factor = stage.ring.number(1 + Fraction(1, 10**exponent))
    residual = left * factor - right
    assert isinstance(residual, Program)
    return Question(residual.ring, [residual])


def bits(id: str, exponents: Sequence[int]) -> Measured:
    """How many bits exclude zero at an exact random point; ``None`` beyond the last precision."""
    from flint import ctx

    from kowalevski_cas.arithmetic.ball import ball_point, exact_balls, random_point

    start = perf_counter()
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
    return _row(start, exponents, bits=needed)


def verdicts(method: str, id: str, exponents: Sequence[int]) -> Measured:
    """Whether a method refutes the near miss."""
    start = perf_counter()
    points = load_points(method)
    answers = [points.answer(near_miss(id, exponent)).holds for exponent in exponents]
    return _row(start, exponents, refuted=[answer is False for answer in answers])


def exactly(id: str, exponents: Sequence[int]) -> Measured:
    """The exact arithmetic refutes every near miss: the difference is not the zero polynomial."""
    start = perf_counter()
    printed = claim(id).printed
    assert printed is not None
    stage = bench("flint").stage(claim(id).scene)
    formula = paper()[1].formula(printed)
    assert isinstance(formula, Relation)
    left, right = (scalar(member, stage) for member in islice(formula.members, 2))
    refuted = []
    for exponent in exponents:
        factor = stage.ring.number(1 + Fraction(1, 10**exponent))
        refuted.append(not (left * factor - right).is_zero)
    return _row(start, exponents, refuted=refuted)


def _row(start: float, exponents: Sequence[int], **found: object) -> Measured:
    seconds = perf_counter() - start
    return {"seconds": seconds, "verdict": "measured", "exponents": list(exponents), **found}


def draw(rows: Sequence[Row], folder: Path) -> None:
    """Bits against e; hollow marks below show where floating point accepts what is false."""
    from math import log2

    from kowalevski_cas import pictures

    with pictures.style():
        figure = pictures.new_figure(height=3.6)
        axes = figure.subplots()
        balls = [row for row in rows if row["method"] == "ball"]
        for index, row in enumerate(balls):
            mark = pictures.mark(index)
            pairs = zip(row["exponents"], row["bits"], strict=True)
            known = [(e, b) for e, b in pairs if b is not None]
            axes.plot(
                [e for e, _ in known],
                [b for _, b in known],
                color=mark.colour,
                marker=mark.marker,
                linestyle=mark.dashes,
                markersize=3.5,
                label=row["case"],
            )
        if balls:
            ends = min(balls[0]["exponents"]), max(balls[0]["exponents"])
            axes.plot(
                ends, [e * log2(10) for e in ends], color=pictures.FAINT, label=r"$e\,\log_2 10$"
            )
        floats = [row for row in rows if row["method"] == "floating"]
        seen = [
            e for row in floats for e, r in zip(row["exponents"], row["refuted"], strict=True) if r
        ]
        if seen:
            axes.axvspan(max(seen) + 0.5, LARGEST, color=pictures.FAINT, alpha=0.2, linewidth=0)
            words = f"beyond $10^{{-{max(seen)}}}$ floating point accepts them all"
            axes.text(max(seen) + 2, 8, words, fontsize=7)
        axes.set_xlabel(r"$e$: one side is off by the factor $1+10^{-e}$")
        axes.set_ylabel("bits at which a ball refutes")
        sure = [row["refuted"] for row in rows if row["method"] in ("exact", "modular")]
        denied = sum(map(sum, sure))
        words = f"exact and modular arithmetic refute {denied} of {sum(map(len, sure))}"
        axes.set_title(words)
        axes.legend(loc="upper left")
        pictures.save(figure, folder, "stability-precision")
