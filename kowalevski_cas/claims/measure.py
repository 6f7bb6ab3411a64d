"""Last multipliers: densities of measures that the flow preserves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from kowalevski_cas.arithmetic.derivation import along
from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import equal, show
from kowalevski_cas.claims.invariant_relations import InvariantRelations
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Name
from kowalevski_cas.proof.outcome import Step, Verdict
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Printed, Texts


@dataclass(frozen=True, eq=False)
class LastMultiplier(Claim):
    r"""``density`` is a last multiplier, on the whole space and on an invariant set.

    On the whole space: :math:`\mu' + \mu\,\mathrm{div}X = 0`. On the set F = 0
    with F' = M F the form :math:`\mu\,dV/dF` (Gelfand, Leray) is preserved exactly
    if moreover :math:`\mathrm{tr}M=0` there. Geometric integrals among the functions
    add nothing to the trace.
    """

    relations: InvariantRelations
    density: str = "1"

    def decide(self, bench: Bench) -> Finding:
        """Compute the divergence of the field and the trace of the cofactor matrix."""
        stage = bench.stage(self.scene)
        residual = self._rate(stage)
        matrix = self.relations.matrix(bench)
        if matrix is None:
            return Finding(Verdict.UNDECIDED, message="the set has no cofactor matrix")
        other = bench.stage(self.relations.scene)
        trace = other.ring.zero
        for k, row in enumerate(matrix):
            trace = trace + row[k]
        if residual.is_zero and trace.is_zero:
            entries = [entry for row in matrix for entry in row]
            steps = [Step(
                "The divergence of the field and the trace of the cofactor matrix:",
                (
                    equal(Name(r"\mathrm{div}"), show(self._divergence(stage), stage)),
                    equal(Name(r"\mathrm{tr}"), show(trace, other)),
                ),
            )] if bench.explain else ()  # fmt: skip
            return green(conditions_of(entries, other), steps)
        found = counterexample(
            bench, self.scene, (self.id, self.density),
            lambda finder: [(self._rate(finder), finder.ring.zero)],
            words="the rate at which the measure with this density changes, and zero",
        )  # fmt: skip
        return refuted(found) if found else Finding(Verdict.UNDECIDED)

    def questions(self, bench: Bench) -> Iterator[Question]:
        """The rate of the measure, and the trace of the cofactor matrix that FLINT found."""
        stage = bench.stage(self.scene)
        yield ask(stage, [self._rate(stage)])
        matrix = self.relations.matrix(bench.finder)
        if matrix is not None:
            other = bench.stage(self.relations.scene)
            trace = other.ring.zero
            for k, row in enumerate(matrix):
                trace = trace + other.carry(row[k])
            yield ask(other, [trace])

    def _divergence(self, stage: Stage) -> Element:
        total = stage.ring.zero
        for name, component in stage.field.items():
            total = total + along(component, {name: stage.ring.one})
        return total

    def _rate(self, stage: Stage) -> Element:
        density = scalar(stage.formula(self.density), stage)
        return stage.derivative(density) + density * self._divergence(stage)

    def scenes(self) -> Iterator[Scene]:
        yield from (self.scene, self.relations.scene)

    def places(self) -> Iterator[Printed]:
        yield from self.relations.places()

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        variable = self.scene.variables[0]
        yield Neighbour(f"the density {variable}", replace(self, density=variable), texts)
