"""First integrals: an expression does not move, everywhere or on an invariant set."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kowalevski_cas.notation import Formula, Name, Power, Relation
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equations, members, rate, vanishes
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Fails, Follows, Goal, identity
from kowalevski_cas.problem.space import Meaningless


@dataclass(frozen=True, eq=False)
class FirstIntegral(Claim):
    """The printed expression is constant along every motion on the set ``given``.

    With a set, the claim includes that it is not constant off the set.
    """

    given: tuple[Printed, ...] = ()
    main: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        still = tuple(vanishes(rate(space.plain(m))) for m in self.constants(on, space))
        if not self.given:
            yield identity(space, *still)
            return
        yield Follows(space, (still,), equations(on, space, self.given), self.main)
        yield Fails(space, (still,))

    def constants(self, on: Elaborations, space: Elaboration) -> list[Formula]:
        """The members that have to be constant; not names that are defined by the others."""
        formula = on.texts.formula(self.own)
        chain = members(formula) if isinstance(formula, Relation) else [formula]
        here = {n for n, place in self.scene.definitions.items() if place == self.own}
        chain = [m for m in chain if not (isinstance(m, Name) and m.name in here)] or chain
        return [member for member in chain if not _is_level(member, space)] or chain


def _is_level(formula: Formula, space: Elaboration) -> bool:
    """Whether a member is a name, or its power, for the value of the integral only."""
    if isinstance(formula, Power):
        formula = formula.base
    if not isinstance(formula, Name):
        return False
    try:
        space.step(formula.name)
    except Meaningless:
        return True
    return False
