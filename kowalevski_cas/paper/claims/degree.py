"""Degree: how a variable enters the derivative of everything that is free of it."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Name, Partial
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import rate, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.goals import Goal, identity


class Degree(Claim):
    r"""The derivative of any expression free of ``variable`` has at most this degree in it.

    By the chain rule this is so exactly if every component of the field but the
    variable's own has at most this degree: the derivative is
    :math:`\sum_v \partial f/\partial v\; \dot v`, in which f may be any v.
    """

    variable: str
    degree: int

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        others = (name for name in space.own_variables if name != self.variable)
        yield identity(space, *(vanishes(self._partial(rate(Name(name)))) for name in others))

    def _partial(self, formula: Formula) -> Formula:
        for _ in range(self.degree + 1):
            # of degree d at most is what vanishes when derived d + 1 times
            formula = Partial(formula, self.variable)
        return formula
