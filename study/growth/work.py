r"""Growing work: the k-th derivatives of the relations of a set against powers of its matrix.

If :math:`F' = MF` then :math:`F^{(k)} = M_kF` with :math:`M_0 = 1` and
:math:`M_{k+1} = M_k' + M_kM`. Both sides are computed, and compared, for k = 1, 2, …
The matrix is the one that was found for the set.

It is the program ``python work.py ARITHMETIC CLAIM STEPS`` too, which tells each step and loads
nothing of what draws.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path

from kowalevski_cas.algebra import POINTS, Arithmetic, load
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.codec import read_evidence, read_problem
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Found
from kowalevski_cas.problem.goals import Exists, Follows
from kowalevski_cas.problem.sampled import Sampled

CERTIFICATES = Path(__file__).parents[2] / "derivations" / "kharlamov2002" / "certificates"

Matrix = list[list[Element]]


class Growth:
    """The two sides of the identity for one k after the other, in a ring."""

    def __init__(self, at: Evaluation, functions: list[Element], matrix: Matrix) -> None:
        self.at, self.functions, self.matrix = at, functions, matrix
        element, zero = at.ring.one, at.ring.zero
        size = range(len(functions))
        self.left = functions
        self.powers = [[element if i == j else zero for j in size] for i in size]

    def step(self) -> bool:
        """Go on to the next k; whether the identity holds there."""
        along, powers = self.at.derivative, self.powers
        self.left = [along(function) for function in self.left]
        self.powers = [
            [
                along(entry) + self._sum(row, [r[j] for r in self.matrix])
                for j, entry in enumerate(row)
            ]
            for row in powers
        ]
        sides = zip(self.left, self.powers, strict=True)
        return all((left - self._sum(row, self.functions)).is_zero for left, row in sides)

    def _sum(self, row: list[Element], column: list[Element]) -> Element:
        total = self.at.ring.zero
        for a, b in zip(row, column, strict=True):
            total = total + a * b
        return total


def certified_set(claim: str) -> tuple[Exists, Found, Follows]:
    """What the certificate of a claim says of a set: the goal, its matrix, and the set."""
    data = json.loads((CERTIFICATES / f"{claim}.json").read_text(encoding="utf-8"))
    (goal,) = read_problem(data).goals
    assert isinstance(goal, Exists)
    found, there = read_evidence(data["evidence"][0], goal), goal.goals[-1]
    assert isinstance(found, Found) and isinstance(there, Follows)
    return goal, found, there


def growth(claim: str, polynomials: Arithmetic | None = None) -> Growth:
    """The growing work for the set of a claim, at points if no exact arithmetic is given."""
    goal, found, there = certified_set(claim)
    at = Evaluation(there.space, polynomials or load("flint")).adjoin_roots()
    at = at if polynomials else Sampled(at)
    entries = [at.scalar(found.values[name]) for name in goal.expressions]
    functions = at.differences(there.given)
    size = len(functions)
    matrix = [entries[row * size : (row + 1) * size] for row in range(size)]
    return Growth(at, functions, matrix)


def steps(growth: Growth, most: int) -> Iterator[int]:
    """The steps that are done, from 0, when the vector field is derived; none that fails."""
    growth.at.rates  # noqa: B018 (they are derived when they are first asked for)
    yield 0
    for k in range(1, most + 1):
        if not growth.step():
            return
        yield k


if __name__ == "__main__":
    arithmetic, claim, most = sys.argv[1:]
    work = growth(claim, None if arithmetic in POINTS else load(arithmetic))
    for k in steps(work, int(most)):
        print("step", k, flush=True)
