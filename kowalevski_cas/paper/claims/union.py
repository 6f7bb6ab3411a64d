"""Unions of sets: whatever obeys some equations lies on one of several sets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.forms import equations
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.goals import Follows, Goal


class Union(Claim):
    """Where the ``given`` equations hold all those of one of the ``sets`` do."""

    sets: tuple[tuple[Printed, ...], ...]
    given: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        conclusions = tuple(equations(on, space, part) for part in self.sets)
        yield Follows(space, conclusions, equations(on, space, self.given))

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        for k, part in enumerate(self.sets):
            kept = self.sets[:k] + self.sets[k + 1 :]
            words = f"without ${part[0].tex}$"
            yield Neighbour(words, replace(self, sets=kept), texts)
