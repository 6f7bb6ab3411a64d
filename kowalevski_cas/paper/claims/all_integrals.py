"""That all polynomial first integrals up to a degree are known."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kowalevski_cas.notation import Number
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import function
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Goal, Kernel
from kowalevski_cas.problem.space import Meaningless


@dataclass(frozen=True, eq=False)
class AllIntegrals(Claim):
    """The polynomial first integrals up to a degree are polynomials in those that are printed.

    Their coefficients may depend on the constants, and so it is for almost all values of these.
    The degree counts each variable of the scene with its weight, or once if there are no weights.
    """

    integrals: tuple[Printed, ...]
    degree: int
    weights: tuple[int, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        integrals = tuple(space.plain(function(on, space, place)) for place in self.integrals)
        weights = self.weights or (1,) * len(space.own_variables)
        if self.degree < 0 or min(weights) < 1 or len(weights) != len(space.own_variables):
            raise Meaningless("a degree is not negative, and each variable has a positive weight")
        yield Kernel(space, Number(0), (Number(1),), integrals, weights, self.degree)

    def establishes(self) -> Iterator[Printed]:
        yield from self.integrals
