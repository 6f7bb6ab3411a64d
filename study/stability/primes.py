r"""Unlucky primes: small moduli, bad reduction, points on a denominator, too few points.

The modular arithmetic draws primes above 2^61. Here it is made to use small ones, to see
its bound :math:`2\deg\prod/p` at work: how often a point accepts a false claim, and how
often there is no point. The exact answer is that all claims asked here are false,
but for one that is true modulo the prime only.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import partial
from random import Random
from typing import TYPE_CHECKING

from flint import fmpz

from kowalevski_cas.algebra import load_points
from kowalevski_cas.algebra.bounds import Sizes
from kowalevski_cas.algebra.modular import primes, residue_point
from kowalevski_cas.algebra.points import NoPoint, Question
from kowalevski_cas.algebra.programs import Programs
from kowalevski_cas.pictures import FAINT, new_figure
from kowalevski_cas.problem.goals import Problem
from kowalevski_cas.verify.statement import Statement
from study.charts import curve, legend_below, marked
from study.labelled import identities, residuals
from study.paper import paper, sampled
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "unlucky primes and too few points"

FALSE = ("eq14", "eq21", "eq10.1")
"""Misprints of the paper."""

POINTS = 400
"""How many points are looked at modulo each prime."""


def measure(quick: bool) -> Iterable[Task]:
    """The share of points that accept a false claim, for primes of all sizes."""
    sizes = (2, 7, 16) if quick else (2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14)
    moduli = [small_prime(2**k) for k in sizes]
    for id in FALSE:
        yield Task("modular", id, partial(accepted, id, moduli, 100 if quick else POINTS))
    yield Task("modular", "coefficients that vanish modulo the prime", bad_reduction)
    yield Task("modular", "a denominator that vanishes modulo the prime", denominator)


def small_prime(least: int) -> int:
    """The first prime from here on that is 1 modulo 4."""
    candidate = least
    while not (candidate % 4 == 1 and fmpz(candidate).is_prime()):
        candidate += 1
    return candidate


def question(id: str) -> Question:
    """What is asked about the claim as it is printed, with all other misprints corrected."""
    claim, texts = paper().claims[id], paper().corrected.texts
    assert claim.printed is not None
    printed = {claim.printed: paper().printed.texts.formula(claim.printed)}
    statement = Statement(claim, paper().corrected.under(texts.reading(printed)))
    of, goal = sampled(), next(identities(statement.problem.goals))
    at = of(goal.space)
    return Question(at.programs, [at.carry(e) for e in residuals(Problem((goal,)), of)])


def accepted(id: str, moduli: Sequence[int], number: int) -> Measured:
    """For each prime: the share of points that accept, the share that are lost, and the bound."""
    asked = question(id)
    sizes = Sizes()
    degree = max(sizes(program).degree for program in asked.residuals)
    for radicand in asked.ring.radicands:
        degree *= max(2, sizes(radicand).degree)
    shares, lost = [], []
    for prime in moduli:
        random = Random(prime)
        accepts = found = 0
        for _ in range(number):
            try:
                point = residue_point(asked, prime, random)
            except NoPoint:
                continue
            found += 1
            accepts += all(point(program) == 0 for program in asked.residuals)
        shares.append(accepts / found if found else None)
        lost.append(1 - found / number)
    return {
        "primes": list(moduli),
        "accepted": shares,
        "lost": lost,
        "points": number,
        "bound": [min(1.0, 2 * degree / prime) for prime in moduli],
    }


def bad_reduction() -> Measured:
    """A claim that is false by a multiple of both primes of one seed; other seeds refute it."""
    seeds = range(1, 9)
    product = 1
    for prime in primes(Random(1), 2):
        product *= prime
    ring = Programs(("x",))
    asked = Question(ring, [ring.number(product) * ring.generator("x")])
    answers = [load_points("modular", seed).answer(asked).holds for seed in seeds]
    return {"seeds": list(seeds), "accepted": answers}


def denominator() -> Measured:
    """A coefficient with a denominator has no value modulo its divisors: no point, no answer."""
    ring = Programs(("x",))
    prime = small_prime(100)
    asked = Question(ring, [ring.number(Fraction(1, prime)) * ring.generator("x")])
    try:
        residue_point(asked, prime, Random(1))
    except NoPoint as error:
        return {"verdict": "undecided", "reason": str(error)}
    return {"verdict": "refuted"}


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """The share of wrong acceptances against the prime, with the bound."""
    figure = new_figure(height=3.4)
    axes = figure.subplots()
    axes.set(xscale="log", yscale="log", xlabel="prime")
    mine = [row for row in rows if "bound" in row]
    for mark, row in marked(mine):
        floor = 0.3 / row["points"]
        shares = [None if share is None else max(share, floor) for share in row["accepted"]]
        words = f"{row['case']} as printed, accepted"
        curve(axes, row["primes"], shares, label=words, **mark.points())
        curve(axes, row["primes"], row["bound"], label="its bound", **{**mark.line, "marker": ""})
    if mine:
        floor = 0.3 / mine[0]["points"]
        axes.axhline(floor, color=FAINT, linewidth=0.8)
        words = f"none of {mine[0]['points']} points"
        axes.text(mine[0]["primes"][0], floor * 1.15, words, fontsize=7)
    axes.set_title("share of points modulo a small prime that accept a false claim")
    legend_below(figure, axes, len(mine), fontsize=6.5)
    return {"stability-primes": figure}
