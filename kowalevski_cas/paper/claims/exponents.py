"""Solved exponents: for which exponents a sum of two symbolic powers vanishes identically."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations
from math import gcd

from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.notation import Formula, Name, Partial, power, times
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import ONE, equation, equations, expression, rate, vanishes
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Fails, Follows, Goal
from kowalevski_cas.problem.space import Equation, Meaningless


class SolvedExponents(Claim):
    r"""A coefficient vanishes for the printed exponents and for no others.

    It is the coefficient of ``variable`` in the derivative of the ``ansatz``. If it vanishes
    identically, then with its derivatives also where the base, and so each power of it, is 1:
    there the exponents have to follow one after the other, at points at which the base moves.
    With the printed exponents p/q, on the other hand, the powers are positive and obey
    :math:`P^q=\theta^p` and what follows for two of them, and the coefficient has to vanish.
    """

    values: tuple[Printed, ...]
    ansatz: Printed
    variable: str

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        values = equations(on, space, self.values)
        coefficient = Partial(rate(expression(on, space, self.ansatz)), self.variable)
        powers = [space.raised(name) for name in space.powers]
        bases = dict.fromkeys(power.base for power in powers)
        still = tuple(vanishes(rate(base)) for base in bases)
        at_one = [(formula, ONE) for formula in (*bases, *(Name(power.name) for power in powers))]
        # if each base stood still where it is 1, nothing would follow there, and any exponents
        # would do
        yield Fails(space, (still,), tuple(at_one))
        derivative: Formula = coefficient
        for k, value in enumerate(values):
            given = (*at_one, *values[:k], vanishes(derivative))
            yield Follows(space, ((value,), still), given)
            derivative = rate(derivative)
        exponents = [(power, self._value(on, space, power.exponent)) for power in powers]
        obeyed = [_one((Name(p.name), v.denominator), (p.base, -v.numerator)) for p, v in exponents]
        for (p, v), (q, w) in combinations(exponents, 2):
            if p.base == q.base:  # both are powers of the same positive root
                top = v.numerator * w.denominator, w.numerator * v.denominator
                common = gcd(*top) or 1
                obeyed.append(
                    _one((Name(p.name), top[1] // common), (Name(q.name), -top[0] // common))
                )
        yield Follows(space, ((vanishes(coefficient),),), (*values, *obeyed))

    def _value(self, on: Elaborations, space: Elaboration, exponent: str) -> Fraction:
        for printed in self.values:
            left, right = equation(on, space, printed)
            if left == Name(exponent):
                value = rational(space.finder.scalar(right))
                if value is not None:
                    return value
        raise Meaningless(f"no number is printed for the exponent {exponent}", exponent)

    def establishes(self) -> Iterator[Printed]:
        yield from self.values


def _one(*powers: tuple[Formula, int]) -> Equation:
    """The equation that a product of whole powers is 1, without negative ones."""
    sides = [
        times(*(power(base, sign * exponent) for base, exponent in powers if sign * exponent > 0))
        for sign in (1, -1)
    ]
    return sides[0], sides[1]
