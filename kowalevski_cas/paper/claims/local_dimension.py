"""The dimension of a set near one of its points."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.dimension import check_conjugates
from kowalevski_cas.paper.claims.forms import equations, minus
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.evidence import At, Denial
from kowalevski_cas.problem.goals import Goal, Rank


class LocalDimension(Claim):
    """Near some real point the set is a manifold of this dimension.

    The differentials of its equations are independent at the point, and so many that the
    dimension is left. Of other points nothing is said.
    """

    equations: tuple[Printed, ...]
    dimension: int

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        given = equations(on, space, self.equations)
        check_conjugates([*map(minus, given)], space)
        yield Rank(space, (), given, len(space.variables) - self.dimension)

    def refuted_by(self, denial: Denial) -> bool:
        """Only by a point: where differentials are dependent, a set may yet be a manifold."""
        return isinstance(denial.evidence, At)

    def establishes(self) -> Iterator[Printed]:
        yield from self.equations
