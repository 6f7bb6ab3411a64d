"""Dimension and independence, by independent differentials at a point."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.forms import equations, first_member
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.goals import Goal, Rank


@dataclass(frozen=True, eq=False)
class Dimension(Claim):
    """Near a point of it, the set has this dimension: its equations are independent there.

    ``levels`` are printed integrals whose values are fixed, ``equations`` the printed
    equations of the set.
    """

    levels: tuple[Printed, ...]
    equations: tuple[Printed, ...]
    dimension: int

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        levels = tuple(first_member(on, space, printed) for printed in self.levels)
        rank = len(space.variables) - self.dimension
        yield Rank(space, levels, equations(on, space, self.equations), rank)


@dataclass(frozen=True, eq=False)
class Independence(Claim):
    """Functions are independent on the set: their differentials and those of the set are.

    ``functions`` are the first members of printed equations.
    """

    levels: tuple[Printed, ...]
    equations: tuple[Printed, ...]
    functions: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        places = (*self.levels, *self.functions)
        functions = tuple(first_member(on, space, printed) for printed in places)
        rank = len(places) + len(self.equations)
        yield Rank(space, functions, equations(on, space, self.equations), rank)

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        first, *_ = self.functions
        claim = replace(self, functions=(*self.functions, first))
        yield Neighbour("with one of the functions taken twice", claim, texts)
