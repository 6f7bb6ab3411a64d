r"""Equilibria: states of rest, and how many there are for given values of the integrals."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Name
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equations, rate, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Count, Follows, Goal
from kowalevski_cas.problem.space import Meaningless


class Equilibria(Claim):
    r"""For given values of the ``levels`` there are exactly ``count`` states of rest.

    ``fixed`` are the variables that vanish at rest. A name by which a level is printed is its
    value: a constant here, whatever the scene has it for.
    """

    fixed: tuple[str, ...]
    levels: tuple[Printed, ...]
    count: int

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene.fixing(self.levels))
        still = (vanishes(Name(name)) for name in self.fixed)
        rest = (vanishes(rate(Name(name))) for name in space.own_variables)
        levels = equations(on, space, self.levels)
        yield Count(space, (*still, *rest, *levels), space.variables, self.count)


class RestPoints(Claim):
    """The points where the printed equations hold are states of rest.

    Velocities, which are variables where higher derivatives are printed, are zero at rest.
    """

    relations: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        if not self.relations:
            raise Meaningless("no equations are given")
        # the equations may not say so: x = 0 of ẍ = −x is a state of rest only with ẋ = 0
        still = (vanishes(Name(name)) for name in space.velocities.values())
        given = (*equations(on, space, self.relations), *still)
        rest = (vanishes(rate(Name(name))) for name in space.variables)
        yield Follows(space, (tuple(rest),), given)

    def establishes(self) -> Iterator[Printed]:
        yield from self.relations
