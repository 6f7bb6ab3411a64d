"""Independence at every point: no differential of a map is degenerate anywhere."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations

from kowalevski_cas.notation import Name, Partial
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import first_member, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import determinant
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.evidence import Evidence
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Follows, Goal
from kowalevski_cas.problem.space import Meaningless


class EverywhereIndependent(Claim):
    """The differentials of the printed functions are independent at every real point.

    With ``origin`` the point is left aside at which all variables vanish.
    """

    functions: tuple[Printed, ...]
    origin: bool = False

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        functions = [first_member(on, space, place) for place in self.functions]
        if not 0 < len(functions) <= len(space.variables):
            raise Meaningless("there are more functions than variables, or none")
        minors = (
            determinant(tuple(tuple(Partial(f, name) for name in names) for f in functions))
            for names in combinations(space.variables, len(functions))
        )
        given = tuple(map(vanishes, minors))
        rest = (tuple(vanishes(Name(name)) for name in space.variables),) if self.origin else ()
        yield Follows(space, rest, given)

    def search(self, goals: Sequence[Goal]) -> Mapping[int, Evidence]:
        """A point on an axis of the phase space at which the differentials depend."""
        from kowalevski_cas.search.follows import FollowsFinder

        (goal,) = goals
        assert isinstance(goal, Follows)
        at, finder = finder_of(goal.space), FollowsFinder(finder_of)
        for axis in goal.space.variables:
            others = (vanishes(Name(name)) for name in goal.space.variables if name != axis)
            if point := finder.failure(replace(goal, given=(*goal.given, *others)), at):
                return {0: point}
        return {}

    def establishes(self) -> Iterator[Printed]:
        """Nothing: the functions are what they are, however they depend on each other."""
        yield from ()
