"""Identities: the members of a printed chain of equalities are equal."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import chain
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.logarithms import with_real_logarithms
from kowalevski_cas.problem.goals import Goal, identity


class Identity(Claim):
    """All members of a printed chain are equal; ``= const`` says that they do not move."""

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(with_real_logarithms(self.scene, (on.texts.formula(self.own),)))
        yield identity(space, *chain(on, space, self.own))
