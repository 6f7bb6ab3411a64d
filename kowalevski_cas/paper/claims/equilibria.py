r"""Equilibria: how many states of rest there are for given values of the integrals."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Name
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equations, rate, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Count, Goal


class Equilibria(Claim):
    r"""For given values of the ``levels`` there are exactly ``count`` states of rest.

    ``fixed`` are the variables that vanish at rest.
    """

    fixed: tuple[str, ...]
    levels: tuple[Printed, ...]
    count: int

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        still = (vanishes(Name(name)) for name in self.fixed)
        rest = (vanishes(rate(Name(name))) for name in space.own_variables)
        levels = equations(on, space, self.levels)
        yield Count(space, (*still, *rest, *levels), space.variables, self.count)
