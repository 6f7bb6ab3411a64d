r"""Growing work: the k-th derivatives of the relations of a set against powers of its matrix.

If :math:`F' = MF` then :math:`F^{(k)} = M_kF` with :math:`M_0 = 1` and
:math:`M_{k+1} = M_k' + M_kM`. Both sides are computed, and compared, for k = 1, 2, …
The matrix is the one that was found for the set.

As a program ``python -m study.growing ARITHMETIC CLAIM STEPS`` it tells the
seconds from the start to each step.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from time import perf_counter

from kowalevski_cas import arithmetic as arithmetics
from kowalevski_cas.algebra import POINTS, Arithmetic
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.claims import InvariantRelations
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.library import find, load
from kowalevski_cas.proof.evidence import load_evidence
from kowalevski_cas.proof.verify import Session
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.stage.programs import ProgramStage

DERIVATION = "kharlamov2002"
Matrix = list[list[Element]]


class Growth:
    """The two sides of the identity for one k after the other, on a stage."""

    def __init__(self, stage: Stage, functions: list[Element], matrix: Matrix) -> None:
        self.stage, self.functions, self.matrix = stage, functions, matrix
        one, zero = stage.ring.one, stage.ring.zero
        size = range(len(functions))
        self.left = functions
        self.powers = [[one if i == j else zero for j in size] for i in size]

    def step(self) -> bool:
        """Go on to the next k; whether the identity holds there."""
        along, powers = self.stage.derivative, self.powers
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
        total = self.stage.ring.zero
        for a, b in zip(row, column, strict=True):
            total = total + a * b
        return total


def growth(claim: str, kind: Arithmetic | None = None) -> Growth:
    """The growing work for the set of a claim, at points if no exact arithmetic is given."""
    derivation = load(DERIVATION)
    session = Session(derivation, ["flint"], False, load_evidence(find(DERIVATION)))
    session.run([claim])
    found = next(c for c in derivation.claims if c.id == claim)
    assert isinstance(found, InvariantRelations)
    known = Bench("flint", session.texts, shelf=session.shelf, stages=session.stages)
    matrix = found.matrix(known)
    assert matrix is not None
    if kind is None:
        stage: Stage = ProgramStage(known.stage(found.scene))
        words = session.texts.vocabulary
        matrix = [[scalar(formula_of(e, words), stage) for e in row] for row in matrix]
    else:
        stage = Stage(found.scene, kind, session.texts)
        matrix = [[stage.ring.from_neutral(e.neutral()) for e in row] for row in matrix]
    return Growth(stage, found.functions(stage), matrix)


def steps(growth: Growth, most: int) -> Iterator[float]:
    """The seconds from the start to each step; ends where the identity fails.

    The vector field is derived before the clock starts.
    """
    growth.stage.field  # noqa: B018 (it is made when it is first asked for)
    start = perf_counter()
    for _ in range(most):
        if not growth.step():
            return
        yield perf_counter() - start


def main(arithmetic: str, claim: str, most: str) -> None:
    """Tell the seconds of each step."""
    if arithmetic == "direct":
        from study.direct import direct

        found = direct(claim, int(most))
    else:
        kind = None if arithmetic in POINTS else arithmetics.load(arithmetic)
        found = steps(growth(claim, kind), int(most))
    for k, seconds in enumerate(found, 1):
        print(f"step {k} {seconds:.6f}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
