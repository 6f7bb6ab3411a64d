"""Identities: the members of a printed chain of equalities are equal."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import chain
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.goals import Goal, identity


class Identity(Claim):
    """All members of a printed chain are equal; ``= const`` says that they do not move."""

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        yield identity(space, *chain(on, space, self.own))
