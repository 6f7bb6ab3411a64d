"""Equivalent equations: each holds wherever the other one does."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows, Goal


class Equivalence(Claim):
    """The printed equation says the same as the equation ``to``."""

    to: Printed

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        stated, other = equation(on, space, self.own), equation(on, space, self.to)
        yield Follows(space, ((stated,),), (other,))
        yield Follows(space, ((other,),), (stated,))
