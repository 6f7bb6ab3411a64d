"""Coefficients: what multiplies a variable in an expression that is linear in it."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Partial, Relation, Sum, Unwritten, total
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import expression, members, rate, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Goal, identity


class Coefficient(Claim):
    """The coefficient of ``variable``.

    Either the printed equation holds up to unwritten terms that are free of the
    variable; or, with ``derivative_of``, the derivative of the expression printed
    there is linear in the variable, with the printed coefficient.
    """

    variable: str
    derivative_of: Printed | None = None

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        read = on.texts.relation if self.derivative_of is None else on.texts.formula
        formula = read(self.own)
        chain = members(formula) if isinstance(formula, Relation) else [formula]
        sides = [space.plain(_without_ellipsis(member)) for member in chain]
        if self.derivative_of is None:
            if any(_without_ellipsis(member) is not member for member in chain):
                sides = [Partial(side, self.variable) for side in sides]
            yield identity(space, (sides[0], sides[1]))
            return
        generated = Partial(rate(expression(on, space, self.derivative_of)), self.variable)
        linear = vanishes(Partial(generated, self.variable))
        yield identity(space, *((generated, side) for side in sides), linear)


def _without_ellipsis(formula: Formula) -> Formula:
    """A sum without the terms that the author does not print."""
    if isinstance(formula, Sum) and any(isinstance(term, Unwritten) for term in formula.terms):
        return total(term for term in formula.terms if not isinstance(term, Unwritten))
    return formula
