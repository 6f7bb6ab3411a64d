"""Eigenvalues of the linear part of a vector field at a point of rest."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Name, Negative, Quotient, Relation, total
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import ONE, equations, members, rate, vanishes
from kowalevski_cas.paper.components import row_components
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import determinant
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Fails, Follows, Goal
from kowalevski_cas.problem.space import Meaningless


class Eigenvalue(Claim):
    r"""The printed number is an eigenvalue of the linear part of the field at a point of rest.

    The point is where ``relations`` hold: they give all variables. With the matrix J of the
    derivatives of the rates by the variables :math:`\det(J-\lambda E)=0` there.
    """

    relations: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        if space.velocities:
            raise Meaningless("the linear part of equations of higher order is not known")
        printed = on.texts.formula(self.own)
        value = space.plain(members(printed)[-1] if isinstance(printed, Relation) else printed)
        given = equations(on, space, self.relations)
        names = space.scene.variables
        rates = _rates(space)
        matrix = tuple(
            tuple(
                total((entry, Negative(value))) if x == y else entry
                for y in names
                for entry in [space.partial(rates[x], y)]
            )
            for x in names
        )
        rest = (vanishes(rate(Name(name))) for name in names)
        yield Fails(space, (), given)
        yield Follows(space, ((vanishes(determinant(matrix)), *rest),), given)


def _rates(space: Elaboration) -> dict[str, Formula]:
    """The right sides of the equations of motion, by the variables."""
    rows = [entry for row in space.field for entry in row_components(row, space)]
    if {name for name, _, _ in rows} != {*space.scene.variables}:
        raise Meaningless("not all rates are printed by themselves")
    return {
        name: space.plain(force if below == ONE else Quotient(force, below))
        for name, below, force in rows
    }
