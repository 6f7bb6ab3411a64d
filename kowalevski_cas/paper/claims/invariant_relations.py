"""Invariant relations: the derivatives of some functions are combinations of these functions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equations, matrix, minus, names_in, rate
from kowalevski_cas.paper.claims.identity import Identity
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import Rows, matrix_times_column
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Exists, Follows, Goal
from kowalevski_cas.problem.space import Meaningless


class InvariantRelations(Claim):
    """The printed equations define an invariant set: (F)' = M F with a matrix M that is found.

    They have a common real point, at which M is regular.
    """

    relations: tuple[Printed, ...]
    main: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        cofactors = matrix("M", len(self.functions(on)))
        yield Exists(self.moves_by(cofactors, on), names_in(cofactors))

    def functions(self, on: Elaborations) -> list[Formula]:
        """The left minus the right sides of the equations; it takes one to define a set."""
        if not self.relations:
            raise Meaningless("no equations are given")
        return [minus(sides) for sides in equations(on, on(self.scene), self.relations)]

    def moves_by(self, cofactors: Rows, on: Elaborations) -> tuple[Follows, Follows]:
        """The goals that the functions move by this matrix, and that it is regular on the set."""
        functions = self.functions(on)
        right = matrix_times_column(cofactors, functions)
        rows = ((rate(f), side) for f, side in zip(functions, right, strict=True))
        moves = Follows(on(self.scene), (tuple(rows),), (), self.main)
        given = equations(on, on(self.scene), self.relations)
        # the same once more on the set: there what M divides by may vanish, and then it proves
        # nothing
        return moves, replace(moves, given=given)

    def establishes(self) -> Iterator[Printed]:
        yield from self.relations


class RelationsOfMotion(InvariantRelations):
    """Invariant relations that hold where a motion begins: they hold along it.

    What they say there, with the values in their places, is the ``beginning``.
    """

    beginning: tuple[Identity, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        yield from super().goals(on)
        for one in self.beginning:
            yield from one.goals(on)
