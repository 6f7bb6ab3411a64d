"""Last multipliers: densities of measures that the flow preserves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kowalevski_cas.notation import Formula, Name, Partial, times, total
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.dimension import check_conjugates
from kowalevski_cas.paper.claims.forms import equations, matrix, minus, names_in, rate, vanishes
from kowalevski_cas.paper.claims.invariant_relations import InvariantRelations
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import trace
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.problem.goals import Exists, Follows, Goal, Rank, identity


class LastMultiplier(Claim):
    r"""``density`` is a last multiplier, on the whole space and on an invariant set.

    On the whole space: :math:`\mu' + \mu\,\mathrm{div}X = 0`, and :math:`\mu` vanishes nowhere.
    On the set F = 0 with F' = M F the form :math:`\mu\,dV/dF` (Gelfand, Leray) is preserved
    exactly if moreover :math:`\mathrm{tr}M=0` there, for an M that is regular on the set, and
    with differentials dF that are independent at a real point of it: else there is no such form,
    or M is not determined on the set. Geometric integrals among the functions add nothing to the
    trace.
    """

    relations: InvariantRelations
    density: str = "1"

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space, density = on(self.scene), on(self.scene).formula(self.density)
        divergence = total(Partial(rate(Name(name)), name) for name in space.own_variables)
        yield identity(space, vanishes(total((rate(density), times(density, divergence)))))
        yield Follows(space, (), (vanishes(density),))
        cofactors = matrix("M", len(self.relations.relations))
        there = on(self.relations.scene)
        given = equations(on, there, self.relations.relations)
        on_set = Follows(there, ((vanishes(trace(cofactors)),),), given)
        check_conjugates([*map(minus, given)], there)
        yield Exists((*self.relations.moves_by(cofactors, on), on_set), names_in(cofactors))
        # NF = 0 gives N dF = 0 on the set: M is unique there if the differentials are independent
        yield Rank(there, (), given, len(given))

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        variable = self.scene.variables[0]
        yield Neighbour(f"the density {variable}", replace(self, density=variable), texts)
