"""That all polynomial first integrals, or Darboux polynomials, up to a degree are known."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Number
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import function
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Goal, Kernel
from kowalevski_cas.problem.space import Meaningless


class AllIntegrals(Claim):
    """The polynomial first integrals up to a degree are polynomials in those that are printed.

    Their coefficients may depend on the constants, and so it is for almost all values of these.
    The degree counts each variable of the scene with its weight, or once if there are no weights.
    """

    integrals: tuple[Printed, ...]
    degree: int
    weights: tuple[int, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        integrals = tuple(space.plain(function(on, space, place)) for place in self.integrals)
        weights = self.weights or (1,) * len(space.own_variables)
        if self.degree < 0 or min(weights) < 1 or len(weights) != len(space.own_variables):
            raise Meaningless("a degree is not negative, and each variable has a positive weight")
        yield Kernel(space, *self.known(on, space), integrals, weights, self.degree)

    def known(self, on: Elaborations, space: Elaboration) -> tuple[Formula, tuple[Formula, ...]]:
        """The cofactor, and the solutions that are multiplied by integrals."""
        # a first integral is a solution for the cofactor 0: 1, times polynomials in the integrals
        return Number(0), (Number(1),)

    def establishes(self) -> Iterator[Printed]:
        yield from self.integrals


class AllDarboux(AllIntegrals, kw_only=True):
    """The polynomials F up to a degree with F' = KF are known, for the ``cofactor`` K.

    They are combinations of those that are printed with coefficients that are polynomials in the
    integrals; there is none but zero, if none are printed.
    """

    cofactor: Printed
    solutions: tuple[Printed, ...]

    def known(self, on: Elaborations, space: Elaboration) -> tuple[Formula, tuple[Formula, ...]]:
        cofactor, *solutions = (
            space.plain(function(on, space, place)) for place in (self.cofactor, *self.solutions)
        )
        return cofactor, tuple(solutions)

    def establishes(self) -> Iterator[Printed]:
        yield from (*self.solutions, *self.integrals)
