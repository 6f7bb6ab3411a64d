"""Definitions: what a printed formula defines makes an equation true."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import chain, equations
from kowalevski_cas.paper.claims.identity import Identity
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.names import head
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows, Goal, identity


class Definition(Claim):
    """With the printed definition, on which the scene rests, ``equation`` holds.

    So a closed form solves a differential equation, or new variables separate one.
    """

    equation: Printed

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        found = chain(on, space, self.equation)
        names = (n for n, place in self.scene.definitions.items() if place == self.own)
        if not any(head(name)[1] for name in names):  # a function has values for arguments only
            found += chain(on, space, self.own)
        yield identity(space, *found)


class Solution(Claim):
    """With the printed functions of the time, on which the scene rests, ``equations`` hold.

    They are those of the law, or else each of them is claimed as well: ``resting`` says so. At
    the ``start``, as where t=0, the equations of the ``beginning`` hold.
    """

    equations: tuple[Printed, ...]
    resting: tuple[Identity, ...] = ()
    beginning: tuple[Printed, ...] = ()
    start: tuple[Printed, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        places = (self.own, *self.equations)
        yield identity(space, *(pair for one in places for pair in chain(on, space, one)))
        for one in self.resting:
            yield from one.goals(on)
        if self.beginning:
            begins = equations(on, space, self.start)
            yield Follows(space, (equations(on, space, self.beginning),), begins)
