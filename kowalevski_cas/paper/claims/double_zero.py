"""Double zeros: an expression vanishes with its gradient wherever given equations hold."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Partial
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equations, expression, moving, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows, Goal


class DoubleZero(Claim):
    """The printed expression vanishes with all its partial derivatives where ``given`` hold."""

    given: tuple[Printed, ...]
    main: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        value = expression(on, space, self.own)
        gradient = (vanishes(Partial(value, name)) for name in moving(space, value))
        yield Follows(
            space, ((vanishes(value), *gradient),), equations(on, space, self.given), self.main
        )
