"""Solved exponents: for which exponents a sum of two symbolic powers vanishes identically."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kowalevski_cas.arithmetic.derivation import along, gradient
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, green, refuted
from kowalevski_cas.claims.formulas import equal, show
from kowalevski_cas.notation import Name
from kowalevski_cas.proof.outcome import Counterexample, Point, Step
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.stage.change import solve
from kowalevski_cas.paper.texts import Printed

LARGEST = 4
"""The largest whole power of the base that may stand between the two terms."""


@dataclass(frozen=True, eq=False)
class SolvedExponents(Claim):
    r"""A coefficient vanishes for the printed exponents and for no others.

    The coefficient of ``variable`` in the derivative of the ansatz is
    :math:`c_1\theta^m + c_2\theta^n`. If :math:`c_1/c_2=\kappa\theta^k` with
    :math:`\kappa` free of the variables, it vanishes
    identically exactly if :math:`m+k-n=0` and :math:`\kappa+1=0`, two
    equations for the exponents, which are solved.
    """

    values: tuple[Printed, ...]
    ansatz: Printed
    variable: str

    beyond_points = "that no other exponents do cannot be seen at points"

    def decide(self, bench: Bench) -> Finding:
        """Generate the coefficient, set up the two equations, solve, and compare."""
        stage = bench.stage(self.scene)
        solution = self.solution(stage)
        steps: list[Step] = []
        if bench.explain:
            steps.append(
                Step("The coefficient, as generated:", (show(self._coefficient(stage), stage),))
            )
            shown = tuple(
                equal(stage.formula(name), show(value, stage)) for name, value in solution.items()
            )
            steps.append(Step("Solved for the exponents, without substituting any:", shown))
        for printed in self.values:
            relation = stage.relation(printed)
            name = relation.members[0]
            if not isinstance(name, Name) or name.name not in solution:
                raise StageError(f"{printed.place} gives no value to an exponent")
            value = scalar(relation.members[1], stage)
            if not (value - solution[name.name]).is_zero:
                point = Point({stage.formula(n): show(v, stage) for n, v in solution.items()})
                words = f"the exponent {name.name} as printed, and as solved for"
                left, right = show(value, stage), show(solution[name.name], stage)
                return refuted(Counterexample(point, left, right, words), steps)
        return green((), steps)

    def solution(self, stage: Stage) -> dict[str, Element]:
        """The exponents, as solved for; raises :class:`StageError` if they are not determined."""
        (first, second) = stage.powers.items()
        coefficient = self._coefficient(stage)
        ((_, m), p), ((_, n), q) = first, second
        c1, c2 = gradient(coefficient, (p, q))
        base = scalar(stage.formula(first[0][0]), stage)
        ratio = c1 / c2
        variables = stage.scene.variables
        for whole in range(-LARGEST, LARGEST + 1):
            kappa = ratio * base**-whole
            if all(partial.is_zero for partial in gradient(kappa, variables)):
                break
        else:
            raise StageError("the two terms do not differ by a whole power of the base")
        one = stage.ring.one
        equations = [
            scalar(stage.formula(m), stage)
            + stage.ring.number(whole)
            - scalar(stage.formula(n), stage),
            Element(stage.ring, kappa.parts, {}) + self._numerator_one(kappa),
        ]
        rows, right = [], []
        for equation in equations:
            row = gradient(equation, (m, n))
            at_zero = equation
            for entry, name in zip(row, (m, n), strict=True):
                if any(not along(entry, {e: one}).is_zero for e in (m, n)):
                    raise StageError("the equations for the exponents are not linear")
                at_zero = at_zero - entry * scalar(stage.formula(name), stage)
            rows.append(row)
            right.append(-at_zero)
        return dict(zip((m, n), solve(rows, right), strict=True))

    @staticmethod
    def _numerator_one(element: Element) -> Element:
        """The denominator of an element, that is, one over the same denominator."""
        ring = element.ring
        return Element(ring, ring.one.parts, element.denominator).inverse()

    def _coefficient(self, stage: Stage) -> Element:
        expression = stage.texts.formula(self.ansatz)
        derivative = stage.derivative(scalar(expression, stage))
        return along(derivative, {self.variable: stage.ring.one})

    def establishes(self) -> Iterator[Printed]:
        yield from self.values

    def places(self) -> Iterator[Printed]:
        yield from self.values
        yield self.ansatz
