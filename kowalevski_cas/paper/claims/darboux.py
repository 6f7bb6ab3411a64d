"""Darboux polynomials: polynomials that divide their derivatives."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, times, to_latex
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import function, rate
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Goal, Rank, identity
from kowalevski_cas.problem.space import Meaningless


class DarbouxPolynomial(Claim):
    """The printed polynomial F in the variables satisfies F' = KF with a polynomial K.

    K, the ``cofactor``, is printed; F is not constant. Both are a formula, or the equation that
    defines a name for it.
    """

    cofactor: Printed

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        value, cofactor = (polynomial(on, space, place) for place in (self.own, self.cofactor))
        yield identity(space, (rate(value), times(cofactor, value)))
        yield Rank(space, (value,), (), 1)

    def establishes(self) -> Iterator[Printed]:
        yield from (self.own, self.cofactor)


def polynomial(on: Elaborations, space: Elaboration, place: Printed) -> Formula:
    """The polynomial at a place; raises :class:`Meaningless` for a quotient and the like."""
    formula = function(on, space, place)
    value = space.plain(formula)
    variables, at = space.own_variables, space.finder
    element = at.scalar(value)
    used = (bit for bit, _ in enumerate(at.ring.roots) if any(m >> bit & 1 for m in element.parts))
    # a root of constants is a number here, one of variables is no polynomial
    under = [at.ring.radicands[bit] for bit in used]
    for divisor in (*at.ring.divisors_of([element]), *under):
        if any(not at.partial(divisor, name).is_zero for name in variables):
            shown = to_latex(formula)
            raise Meaningless(f"{shown} at {place.place} is no polynomial in the variables")
    return value
