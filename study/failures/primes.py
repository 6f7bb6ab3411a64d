r"""Small primes: how often a point modulo a prime accepts a near miss, against the bound.

The modular arithmetic draws primes above 2^61. Here it is made to use small ones, to see
its bound :math:`2\deg\prod/p` at work.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial
from random import Random

from flint import fmpz
from matplotlib.axes import Axes

from kowalevski_cas.algebra.bounds import Sizes
from kowalevski_cas.algebra.modular import residue_point
from kowalevski_cas.algebra.points import NoPoint, Question
from kowalevski_cas.pictures import FAINT
from study.charts import display_name, look, points
from study.failures.differences import near_miss
from study.step import Measured, Row, Task

TITLE = "a prime too small"

CLAIM, FACTOR = "F2-prime", Fraction(4, 3)
"""A true identity, and by what one side of it is multiplied."""

POINTS = 400
"""How many points are looked at modulo each prime."""

CAPTION = (
    rf"the share of {POINTS} points modulo $p$ that accept $F_2'=(U_1+U_2)F_1/\sqrt\theta$ with "
    f"one side multiplied by {FACTOR}; hollow: 0 of {POINTS}, so at most 3/{POINTS}"
)


def measure(quick: bool) -> Iterator[Task]:
    """The share of points that accept a false claim, for primes of all sizes."""
    powers = (2, 7, 16) if quick else (2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14)
    moduli = [small_prime(2**power) for power in powers]
    yield Task("modular", "primes", partial(count_accepting, moduli))


def small_prime(least: int) -> int:
    """The first prime from here on that is 1 modulo 4."""
    candidate = least
    while not (candidate % 4 == 1 and fmpz(candidate).is_prime()):
        candidate += 1
    return candidate


def count_accepting(moduli: Sequence[int]) -> Measured:
    """For each prime: how many points accept, of how many, and the bound of that share."""
    asked, sizes = near_miss(CLAIM, FACTOR), Sizes()
    degree = max(sizes(program).degree for program in asked.residuals)
    for radicand in asked.ring.radicands:
        degree *= max(2, sizes(radicand).degree)
    found = [_count_points(asked, prime) for prime in moduli]
    return {
        "primes": list(moduli),
        "accepted": [count for count, _ in found],
        "points": [number for _, number in found],
        "bound": [min(1.0, 2 * degree / prime) for prime in moduli],
    }


def _count_points(asked: Question, prime: int) -> tuple[int, int]:
    """How many points modulo a prime accept, and how many there are."""
    random, accepts, found = Random(prime), 0, 0
    for _ in range(POINTS):
        try:
            point = residue_point(asked, prime, random)
        except NoPoint:
            continue
        found += 1
        accepts += all(point(program) == 0 for program in asked.residuals)
    return accepts, found


def draw(axes: Axes, rows: Sequence[Row]) -> None:
    """The share of wrong acceptances against the prime, with the bound."""
    axes.set(xscale="log", yscale="log", xlabel="prime $p$", ylabel="share of points that accept")
    axes.set_ylim(3e-4, 2)
    for row in rows:
        axes.plot(row["primes"], row["bound"], color=FAINT, label="guaranteed bound")
        shares = list(zip(row["primes"], row["accepted"], row["points"], strict=True))
        for full in (True, False):
            chosen = [(p, (n or 3) / of) for p, n, of in shares if of and bool(n) is full]
            words = display_name(row["method"]) if full else None
            look_of = points(look(row["method"]), full)
            axes.plot([p for p, _ in chosen], [s for _, s in chosen], label=words, **look_of)
    axes.legend(loc="lower left", fontsize=7.5, borderaxespad=0)
