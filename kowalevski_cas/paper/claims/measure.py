"""The divergence of the field, and densities of measures that the flow preserves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Partial,
    Power,
    Product,
    Quotient,
    Relation,
    power,
    times,
    total,
)
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.dimension import check_conjugates
from kowalevski_cas.paper.claims.forms import (
    ONE,
    equations,
    matrix,
    members,
    minus,
    names_in,
    rate,
    vanishes,
)
from kowalevski_cas.paper.claims.inequality import compared, told_apart
from kowalevski_cas.paper.claims.invariant_relations import InvariantRelations
from kowalevski_cas.paper.components import row_components
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.exponents import is_whole
from kowalevski_cas.paper.matrices import determinant, trace
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.problem.goals import Exists, Fails, Follows, Goal, Rank, identity
from kowalevski_cas.problem.space import Meaningless

DIVERGENCE = r"\mathrm{div}"
"""The name of the divergence of the field, where it is printed."""


def divergence(space: Elaboration) -> Formula:
    """The divergence of the field, by all that moves, also where functions of it are printed."""
    mark = "dot" if space.scene.time == "t" else "prime"
    rows = (entry for row in space.field for entry in row_components(row, space))
    known = {name: force if below == ONE else Quotient(force, below) for name, below, force in rows}
    rates = ((n, known.get(n) or space.plain(Derivative(Name(n), mark))) for n in moving(space))
    return total(space.partial(force, name) for name, force in rates)


def moving(space: Elaboration) -> tuple[str, ...]:
    """The variables and the velocities."""
    return (*space.scene.variables, *space.velocities.values())


class Divergence(Claim):
    r"""The printed expression, or what is printed as equal to “div”, is the field's divergence.

    What it is compared with behind that, as in :math:`\mathrm{div}=-2k<0`, is claimed as well.
    """

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        sides, chain = told_apart(on.texts.as_printed(self.own))
        if chain is not None:
            yield from compared(on, self.scene, chain)
        values = [space.plain(side) for side in sides if side != Name(DIVERGENCE)]
        if not values:
            raise Meaningless("the divergence is not printed")
        yield identity(space, *((value, divergence(space)) for value in values))


class PreservedMeasure(Claim):
    r"""The flow preserves the measure with the printed density, which does not vanish identically.

    The density is that in ``coordinates``, or in the variables themselves if none are named: with
    the Jacobian J of the coordinates :math:`(\mu J)'+\mu J\,\mathrm{div}X=0`.
    """

    coordinates: tuple[str, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space, printed = on(self.scene), on.texts.formula(self.own)
        density = members(printed)[-1] if isinstance(printed, Relation) else printed
        factors = [*_factors(density)]
        fixed = {*space.scene.constants, *space.scene.undefined}
        powers = [factor for factor in factors if not is_whole(factor[1])]
        if not fixed.issuperset(name for _, exponent in powers for name in exponent.names()):
            raise Meaningless("an exponent of the density is no constant")
        whole = [power(*factor) for factor in factors if factor not in powers]
        rest = times(*map(space.plain, whole), *self._jacobian(space))
        # (b^e)'/b^e = e b'/b, whatever the exponent is
        slopes = [
            times(exponent, Quotient(rate(space.plain(base)), space.plain(base)))
            for base, exponent in powers
        ]
        change = total(
            (rate(rest), *(times(rest, slope) for slope in (*slopes, divergence(space))))
        )
        for factor in (rest, *(space.plain(base) for base, _ in powers)):
            yield Fails(space, ((vanishes(factor),),))
        yield identity(space, vanishes(change))

    def _jacobian(self, space: Elaboration) -> Iterator[Formula]:
        """The determinant of the derivatives of the coordinates by the variables."""
        new = [name for name in self.coordinates if name not in moving(space)]
        old = [name for name in moving(space) if name not in self.coordinates]
        if not self.coordinates or not new:
            return
        if len(new) != len(old):
            raise Meaningless("there are not as many coordinates as variables")
        values = [space.plain(Name(name)) for name in new]
        yield determinant(
            tuple(tuple(space.partial(value, name) for name in old) for value in values)
        )


def _factors(formula: Formula) -> Iterator[tuple[Formula, Formula]]:
    """The bases with their exponents of which a formula is a product."""
    match formula:
        case Product(factors):
            for factor in factors:
                yield from _factors(factor)
        case Quotient(above, below):
            yield from _factors(above)
            yield from ((base, Negative(exponent)) for base, exponent in _factors(below))
        case Power(base, exponent):
            yield base, exponent
        case _:
            yield formula, ONE


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
