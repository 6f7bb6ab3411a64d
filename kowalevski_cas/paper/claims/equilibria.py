r"""Equilibria: states of rest, and how many there are for given values of the integrals."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Name, Relation, Vector
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equations, members, rate, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.generators import values_at_zero
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Count, Follows, Goal
from kowalevski_cas.problem.space import Equation, Meaningless


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


class RestPoint(Claim):
    """The printed list has the coordinates of a state of rest; of an equation its last member.

    Velocities, which are variables where higher derivatives are printed, are zero there.
    """

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        printed = on.texts.formula(self.own)
        point = members(printed)[-1] if isinstance(printed, Relation) else printed
        variables = space.scene.variables
        if not isinstance(point, Vector) or len(point.components) != len(variables):
            raise Meaningless("a list of all coordinates is expected")
        given: list[Equation] = [
            (Name(name), space.plain(value))
            for name, value in zip(variables, point.components, strict=True)
        ]
        given += [vanishes(Name(name)) for name in space.velocities.values()]
        rest = (vanishes(rate(Name(name))) for name in space.variables)
        yield Follows(space, (tuple(rest),), (*given, *values_at_zero(given, space)))


class RestPoints(Claim):
    """The points where the printed equations hold are states of rest, and perhaps all of these.

    They satisfy what is ``given`` besides, as constraints of the motion. Velocities, which are
    variables where higher derivatives are printed, are zero at rest.
    """

    relations: tuple[Printed, ...]
    are_all: bool = False
    given: tuple[Printed, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        if not self.relations:
            raise Meaningless("no equations are given")
        # the equations may not say so: x = 0 of ẍ = −x is a state of rest only with ẋ = 0
        still = [vanishes(Name(name)) for name in space.velocities.values()]
        relations = equations(on, space, self.relations)
        rest = tuple(vanishes(rate(Name(name))) for name in space.variables)
        still += equations(on, space, self.given)
        yield Follows(space, (rest,), (*relations, *still))
        if self.are_all:
            yield Follows(space, (relations,), (*rest, *still))

    def establishes(self) -> Iterator[Printed]:
        yield from (self.printed,) if self.printed is not None else self.relations
