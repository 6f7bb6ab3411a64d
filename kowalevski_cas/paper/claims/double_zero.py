"""Double zeros: an expression vanishes with its gradient wherever given equations hold.

Of an equation that is the difference of its sides: it holds there to the first order, or to higher
ones as well.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from itertools import combinations_with_replacement

from kowalevski_cas.notation import Formula, Relation
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import (
    equation,
    equations,
    expression,
    minus,
    moving,
    slope,
    vanishes,
)
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows, Goal


class DoubleZero(Claim):
    """The printed expression vanishes with its partial derivatives where ``given`` hold.

    They are all those of some ``orders``.
    """

    given: tuple[Printed, ...]
    main: tuple[tuple[str, ...], ...] = ()
    orders: tuple[int, ...] = (1,)

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        value = self._value(on, space)
        names = moving(space, value)
        gradient = (
            vanishes(reduce(lambda one, name: slope(space, one, name), chosen, value))
            for order in self.orders
            for chosen in combinations_with_replacement(names, order)
        )
        yield Follows(
            space, ((vanishes(value), *gradient),), equations(on, space, self.given), self.main
        )

    def _value(self, on: Elaborations, space: Elaboration) -> Formula:
        """The printed expression, or the difference of the sides of the printed equation."""
        if isinstance(on.texts.formula(self.own), Relation):
            return minus(equation(on, space, self.own))
        return expression(on, space, self.own)
