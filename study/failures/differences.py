r"""Small differences: true identities of which one side is multiplied by :math:`1+10^{-e}`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import takewhile

from matplotlib.axes import Axes

from kowalevski_cas.algebra import load_points
from kowalevski_cas.algebra.points import Question
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from study.charts import display_name, look
from study.paper import both, paper, sides
from study.step import Measured, Row, Task

TITLE = "a difference too small"

IDENTITIES = ("eq5.1", "eq12", "F2-prime", "U1-prime", "eq21")

LARGEST, STEP = 200, 5

CAPTION = (
    f"one side of {len(IDENTITIES)} identities is multiplied by $1+10^{{-e}}$, $e\\le{LARGEST}$; "
    "drawn is up to which $e$ a method sees that all are false"
)


def measure(quick: bool) -> Iterator[Task]:
    """For each method, how many of the near misses it refutes, for each exponent e."""
    exponents = [STEP, 40] if quick else list(range(STEP, LARGEST + 1, STEP))
    for method in ("flint", "modular", "ball", "floating"):
        yield Task(method, "differences", partial(count_refuted, method, exponents))


def count_refuted(method: str, exponents: Sequence[int]) -> Measured:
    """How many of the near misses a method refutes."""
    factors = [1 + Fraction(1, 10**e) for e in exponents]
    counts = [sum(_refutes(method, id, factor) for id in IDENTITIES) for factor in factors]
    return {"exponents": list(exponents), "refuted": counts}


def near_miss(id: str, factor: Fraction) -> Question:
    """A true identity with one side multiplied by a number, to be asked at points."""
    _, at = both(paper().claims[id].scene)
    return Question(at.programs, [at.carry(_difference(id, factor, at))])


def _refutes(method: str, id: str, factor: Fraction) -> bool:
    if method == "flint":
        at, _ = both(paper().claims[id].scene)
        return not _difference(id, factor, at).is_zero
    return load_points(method).answer(near_miss(id, factor)).holds is False


def _difference(id: str, factor: Fraction, at: Evaluation) -> Element:
    left, right = sides(id, at)
    return left * left.ring.number(factor) - right


def draw(axes: Axes, rows: Sequence[Row]) -> None:
    """A bar a method, as long as it refutes everything."""
    for line, row in enumerate(rows):
        pairs = zip(row["exponents"], row["refuted"], strict=True)
        seen = [e for e, _ in takewhile(lambda pair: pair[1] == len(IDENTITIES), pairs)]
        end = max(seen, default=0)
        axes.barh([line], [end], height=0.5, color=look(row["method"]).colour)
        words = "all" if end == max(row["exponents"]) else f"$e\\leq{end}$"
        axes.annotate(words, (end, line), (3, 0), textcoords="offset points", va="center", size=7)
    axes.set_yticks(range(len(rows)), [display_name(row["method"]) for row in rows], size=7)
    axes.set(xlim=(0, 1.25 * LARGEST), xlabel="$e$: off by the factor $1+10^{-e}$")
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
