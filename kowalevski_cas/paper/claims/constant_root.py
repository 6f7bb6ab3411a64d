"""Constant roots: a root of an equation that is a combination of constants of the motion."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Name, substitute, times, total
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equation, rate, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.goals import Exists, Goal, identity


class ConstantRoot(Claim):
    """The printed equation for ``unknown`` has a root that is constant on the scene.

    It is a combination with rational coefficients of ``basis``, expressions that do not move.
    """

    unknown: str
    basis: tuple[str, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        numbers = tuple(f"q_{{{k}}}" for k in range(1, len(self.basis) + 1))
        basis = [space.formula(tex) for tex in self.basis]
        root = total(times(Name(q), b) for q, b in zip(numbers, basis, strict=True))
        left, right = equation(on, space, self.own)
        values = {self.unknown: root}
        sides = (substitute(left, values), substitute(right, values))
        yield Exists((identity(space, sides),), numbers=numbers)
        yield identity(space, *(vanishes(rate(b)) for b in basis))
