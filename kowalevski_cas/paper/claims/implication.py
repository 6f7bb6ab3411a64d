"""Implications: an equation holds wherever given equations hold."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Negative, Relation
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equation, equations, expression, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows, Goal


class Implication(Claim):
    """The printed equation (or expression, equal to zero) follows from the ``given`` ones.

    With a ``root``, it follows for one of the two values of this root, and for
    the same one as the equations in ``together``.
    """

    given: tuple[Printed, ...]
    root: str | None = None
    together: tuple[Printed, ...] = ()
    main: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        is_equation = isinstance(on.texts.formula(self.own), Relation)
        own = (
            equation(on, space, self.own)
            if is_equation
            else vanishes(expression(on, space, self.own))
        )
        stated = (*equations(on, space, self.together), own)
        conclusions = [stated]
        if self.root is not None:
            root = space.formula(self.root)
            other = ((_flipped(a, root), _flipped(b, root)) for a, b in stated)
            conclusions.append(tuple(other))
        given = equations(on, space, self.given)
        yield Follows(space, tuple(conclusions), given, self.main)


def _flipped(formula: Formula, root: Formula) -> Formula:
    """The formula with the other value of a root."""
    if formula == root:
        return Negative(root)
    return formula.mapped(lambda child: _flipped(child, root))
