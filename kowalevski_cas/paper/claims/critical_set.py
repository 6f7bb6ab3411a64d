r"""Critical sets: where all derivatives of a function along a level surface vanish."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations

from kowalevski_cas.notation import Formula, Negative, Number, Product, Sum, edits, equal
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.forms import (
    equation,
    equations,
    expression,
    moving,
    slope,
    vanishes,
)
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.evidence import Evidence
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Follows, Goal
from kowalevski_cas.problem.space import Equation


class CriticalSet(Claim):
    r"""``equations`` define exactly the critical points of the printed function on a surface.

    ``level`` is the printed equation g = v of the surface; the gradient of g does not vanish
    on it. So the critical points of f are those where :math:`\partial_i f=0` for each
    variable of which g is free, and :math:`\partial_i g\,\partial_j f=\partial_j g\,\partial_i f`
    for each pair of the others. With ``zero_level`` only those are meant at which f vanishes.
    """

    equations: tuple[Printed, ...]
    level: Printed
    zero_level: bool = False

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        level, goals = equation(on, space, self.level), equations(on, space, self.equations)
        value = expression(on, space, self.own)
        critical = self._critical(space, value, level[0])
        yield Follows(space, (critical,), (*goals, level))
        yield Follows(space, (goals,), (*critical, level))
        slopes = (vanishes(slope(space, level[0], name)) for name in moving(space, level[0]))
        # where the surface has no tangent plane the criterion by products of slopes says nothing
        yield Follows(space, (), (level, *slopes))

    def search(self, goals: Sequence[Goal]) -> Mapping[int, Evidence]:
        """That both directions hold off the loci, or a point there where one fails."""
        from kowalevski_cas.search.follows import FollowsFinder
        from kowalevski_cas.search.proof_steps import in_turn

        finder, found = FollowsFinder(finder_of), dict[int, Evidence]()
        for place, goal in enumerate(goals[:2]):
            assert isinstance(goal, Follows)
            at = finder_of(goal.space)
            conditions = [at.scalar(condition) for _, condition in goal.space.loci]
            if shown := in_turn(goal, at, conditions):
                found[place] = shown
            elif point := finder.failure(goal, at, conditions):
                return {place: point}
        return found

    def _critical(
        self, space: Elaboration, function: Formula, surface: Formula
    ) -> tuple[Equation, ...]:
        on, beside = moving(space, surface), space.transcendental.functions_beside
        by = partial(slope, space)
        rates = [by(function, n) for n in space.variables if n not in {*on, *beside}]
        for a, b in combinations(on, 2):
            product = Product((by(surface, a), by(function, b)))
            other = Product((by(surface, b), by(function, a)))
            rates.append(Sum((product, Negative(other))))
        return tuple(map(vanishes, [*rates, *([function] if self.zero_level else [])]))

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        if not self.zero_level:
            words = "the zeros are exactly the critical points at which the function vanishes"
            yield Neighbour(words, replace(self, zero_level=True), texts)
        for edit in edits(texts.statement(self.own), texts.vocabulary, wanted=wanted):
            yield Neighbour(edit.words, self, texts, self.own, edit)

    def formulas(self, texts: Texts) -> tuple[Formula, ...]:
        function = texts.formula(self.own)
        return (equal(function, Number(0)),) if self.zero_level else (function,)

    def establishes(self) -> Iterator[Printed]:
        """Nothing: the function is what it is, whatever its critical points are."""
        yield from ()
