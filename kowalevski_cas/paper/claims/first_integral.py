"""First integrals: an expression does not move, everywhere or on an invariant set."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

from kowalevski_cas.notation import Derivative, Formula, Name, Partial, Power, Relation
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equations, members, rate, vanishes
from kowalevski_cas.paper.claims.invariant_relations import InvariantRelations
from kowalevski_cas.paper.components import parts
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.logarithms import derived, has_logarithm
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Fails, Follows, Goal, Rank
from kowalevski_cas.problem.space import Equation, Meaningless


@dataclass(frozen=True, eq=False)
class FirstIntegral(Claim):
    """The printed expression is constant along every motion on the invariant set ``given``.

    All members of a printed chain are the same function, which is not constant by itself (nor is
    any component of it, if it is a vector): its differential is independent of those of the set at
    a real point. With a set, the claim includes that the set is invariant, and that the function
    is not constant off the set. Of logarithms, which stand with constant factors, it is the
    derivatives that are stated.
    """

    given: tuple[Printed, ...] = ()
    main: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        printed = self.constants(on, space)
        if any(map(has_logarithm, printed)):
            yield from self._of_logarithms(space, printed)
            return
        chain = [parts(space.plain(member), space) for member in printed]
        for same in zip(*chain, strict=True):
            yield from self._goals(on, space, same)

    def _goals(
        self, on: Elaborations, space: Elaboration, same: tuple[Formula, ...]
    ) -> Iterator[Goal]:
        """What is claimed of one function, or of a component of a vector."""
        still = tuple(vanishes(rate(member)) for member in same)
        given = equations(on, space, self.given)
        yield Follows(space, ((*still, *pairwise(same)),), given, self.main)
        if self.given:
            yield Fails(space, (still,))
            invariant = InvariantRelations(self.id, self.scene, None, "", self.given, self.main)
            yield from invariant.goals(on)
        yield Rank(space, (same[-1],), given, 1 + len(space.finder.differences(given)))

    def _of_logarithms(self, space: Elaboration, printed: list[Formula]) -> Iterator[Goal]:
        """The rate of a function with logarithms vanishes, and its differential does not."""
        if len(printed) > 1 or self.given:
            raise Meaningless("a function with logarithms is claimed by itself, on no set")

        def vanishing(by: Callable[[Formula], Formula]) -> Equation:
            return vanishes(space.plain(derived(printed[0], by, space)))

        mark = "dot" if self.scene.time == "t" else "prime"
        yield Follows(space, ((vanishing(lambda one: Derivative(one, mark)),),), ())
        names = (*self.scene.variables, *space.velocities.values())
        yield Fails(space, (tuple(vanishing(partial(Partial, by=name)) for name in names),))

    def constants(self, on: Elaborations, space: Elaboration) -> list[Formula]:
        """The members that have to be constant; not names that are defined by the others."""
        formula = on.texts.formula(self.own)
        chain = members(formula) if isinstance(formula, Relation) else [formula]
        here = {n for n, place in self.scene.definitions.items() if place == self.own}
        chain = [m for m in chain if not (isinstance(m, Name) and m.name in here)] or chain
        return [member for member in chain if not _is_level(member, space)] or chain


def _is_level(formula: Formula, space: Elaboration) -> bool:
    """Whether a member is a name, or its power, for the value of the integral only.

    Then it is a constant of the scene, or has no meaning there.
    """
    if isinstance(formula, Power):
        formula = formula.base
    if not isinstance(formula, Name):
        return False
    try:
        return space.step(formula.name) is None and formula.name in space.constants
    except Meaningless:
        return True
