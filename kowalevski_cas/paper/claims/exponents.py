"""Solved exponents: for which exponents a sum of two symbolic powers vanishes identically."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from kowalevski_cas.arithmetic.present import fraction_formula
from kowalevski_cas.notation import Formula, Name, Number, Partial, Power
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import ONE, equations, expression, rate, times, vanishes
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.evaluate import Meaningless, rational_terms
from kowalevski_cas.problem.goals import Fails, Follows, Goal
from kowalevski_cas.problem.space import Equation


@dataclass(frozen=True, eq=False)
class SolvedExponents(Claim):
    r"""A coefficient vanishes for the printed exponents and for no others.

    It is the coefficient of ``variable`` in the derivative of the ``ansatz``. If it vanishes
    identically, then with its derivatives also where the base, and so each power of it, is 1:
    there the exponents have to follow one after the other, at points at which the base moves.
    With the printed exponents p/q, on the other hand, the powers obey :math:`P^q=\theta^p`, and
    the coefficient has to vanish.
    """

    values: tuple[Printed, ...]
    ansatz: Printed
    variable: str

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        values = equations(self.values, space)
        coefficient = Partial(self.variable, rate(expression(self.ansatz, space)))
        powers = [space.raised(name) for name in space.powers]
        bases = dict.fromkeys(power.base for power in powers)
        still = tuple(vanishes(rate(base)) for base in bases)
        at_one = [(formula, ONE) for formula in (*bases, *(Name(power.name) for power in powers))]
        yield Fails(space, (still,), tuple(at_one))
        derivative = coefficient
        for k, value in enumerate(values):
            given = (*at_one, *values[:k], vanishes(derivative))
            yield Follows(space, ((value,), still), given)
            derivative = rate(derivative)
        roots = [self._root(space, power.name, power.base, power.exponent) for power in powers]
        yield Follows(space, ((vanishes(coefficient),),), (*values, *roots))

    def _root(self, space: Elaboration, name: str, base: Formula, exponent: str) -> Equation:
        """What a power with the printed exponent obeys, in whole powers."""
        value = self._value(space, exponent)
        top, below = abs(value.numerator), value.denominator
        left, right = _whole(Name(name), below), _whole(base, top)
        return (times(left, right), ONE) if value < 0 else (left, right)

    def _value(self, space: Elaboration, exponent: str) -> Fraction:
        for printed in self.values:
            left, right = space.equation(printed)
            if left == Name(exponent):
                value = rational_terms(space.finder.scalar(right))
                if value is not None:
                    return value
        raise Meaningless(f"no number is printed for the exponent {exponent}", exponent)

    def establishes(self) -> Iterator[Printed]:
        yield from self.values


def _whole(base: Formula, exponent: int) -> Formula:
    if exponent == 0:
        return fraction_formula(Fraction(1))
    return base if exponent == 1 else Power(base, Number(exponent))
