r"""Growing work: the k-th derivatives of the relations of a set against powers of its matrix.

If :math:`F' = MF` then :math:`F^{(k)} = M_kF` with :math:`M_0 = 1` and
:math:`M_{k+1} = M_k' + M_kM`. Both sides are computed, and compared, for k = 1, 2, …
The matrix is the one that was found for the set.
"""

from __future__ import annotations

from collections.abc import Iterator
from time import process_time

from kowalevski_cas.algebra import Arithmetic, load
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.codec import read_evidence, read_problem
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Found
from kowalevski_cas.problem.goals import Exists, Follows
from kowalevski_cas.problem.sampled import Sampled
from study.paper import paper

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


def growth(claim: str, polynomials: Arithmetic | None = None) -> Growth:
    """The growing work for the set of a claim, at points if no exact arithmetic is given.

    The set and its matrix are those of the certificate of the claim.
    """
    data = paper().certificates[claim].data
    (goal,) = read_problem(data).goals
    found = read_evidence(data["evidence"][0], goal)
    assert isinstance(goal, Exists) and isinstance(found, Found)
    there = goal.goals[-1]
    assert isinstance(there, Follows)
    at = Evaluation(there.space, polynomials or load("flint")).adjoin_roots()
    at = at if polynomials else Sampled(at)
    entries = [at.scalar(found.values[name]) for name in goal.expressions]
    functions = at.differences(there.given)
    size = len(functions)
    matrix = [entries[row * size : (row + 1) * size] for row in range(size)]
    return Growth(at, functions, matrix)


def steps(growth: Growth, most: int) -> Iterator[float]:
    """The seconds of processor time from the start to each step; ends where the identity fails.

    The vector field is derived before the clock starts.
    """
    growth.at.rates  # noqa: B018 (they are derived when they are first asked for)
    start = process_time()
    for _ in range(most):
        if not growth.step():
            return
        yield process_time() - start
