r"""Equilibria: states of rest, and how many there are for given values of the integrals."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Name, Relation, Vector
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equations, members, rate, vanishes
from kowalevski_cas.paper.elaborate import Elaboration
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
        given += _velocities(space)
        yield Follows(space, (_rest(space),), (*given, *values_at_zero(given, space)))


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
        still = _velocities(space)
        relations = equations(on, space, self.relations)
        rest = _rest(space)
        still += equations(on, space, self.given)
        yield Follows(space, (rest,), (*relations, *still))
        if self.are_all:
            yield Follows(space, (relations,), (*rest, *still))

    def establishes(self) -> Iterator[Printed]:
        yield from (self.printed,) if self.printed is not None else self.relations


def _rest(space: Elaboration) -> tuple[Equation, ...]:
    """That nothing moves; of an angle not its sine, which is at rest also where it turns round."""
    angles = [name for name in space.scene.variables if name in space.transcendental]
    generators = {one for name in angles for one in space.transcendental.instead(name)}
    moving = [rate(Name(name)) for name in space.variables if name not in generators]
    turning = [space.plain(rate(Name(name))) for name in angles]
    return tuple(map(vanishes, (*moving, *turning)))


def _velocities(space: Elaboration) -> list[Equation]:
    """That the velocities vanish which are variables where higher derivatives are printed."""
    return [vanishes(Name(name)) for name in space.velocities.values()]
