"""Roots that a printed equation gives by their square."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.derivation import along
from kowalevski_cas.algebra.numbers import prime_factors, rational
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Constant,
    Formula,
    Name,
    Number,
    Power,
    Quotient,
    times,
    to_latex,
)
from kowalevski_cas.paper.denominators import factors_below, factors_of, granted_factors
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Adjoined, Meaningless, Space


def root_of_number(radicand: Formula) -> tuple[Fraction, tuple[int, ...]] | None:
    r"""The root of a positive number, as a rational number and the primes of which roots are left.

    So roots of numbers depend on each other no more: :math:`\sqrt8` is :math:`2\sqrt2`. ``None``
    for the root of anything else.
    """
    try:
        value = rational(rationals().scalar(radicand))
    except Meaningless:
        return None
    if value is None or value <= 0:
        return None
    # √(p/q) is √(pq)/q: no root is left below the line
    factors = [*prime_factors(value.numerator * value.denominator)]
    factor = Fraction(1, value.denominator)
    for prime, exponent in factors:
        factor *= prime ** (exponent // 2)
    return factor, tuple(prime for prime, exponent in factors if exponent % 2)


@cache
def rationals() -> Evaluation:
    """The rational numbers."""
    return Evaluation(Space((), ("",)), load("flint"))


def solve_for_root(setting: Meaning, name: str, printed: Printed) -> Adjoined:
    r"""A root by a printed equation in which its square stands.

    The equation is solved for the square: ``a^2`` in :math:`(\alpha,\alpha)=a^2`,
    ``z_1^2`` in :math:`z_1^2+x_1y_2=c_1`. Members with names that the scene does
    not have are passed over; all others have to give the same square, exactly.
    """
    setting.places[name] = (printed,)
    members = [m for m in setting.texts.relation(printed).members if not isinstance(m, Constant)]
    squared = Power(Name(name), Number(2))
    if len(members) == 2 and squared in members:
        other = members[members[0] == squared]
        if name not in other.names():
            return Adjoined(name, setting.plain(other))
    at = setting.free([name])
    sides = [plain for m in members if (plain := _expand_known(at, setting, m)) is not None]
    if len(sides) < 2:
        raise Meaningless(f"the equation at {printed.place} does not give {name}^2", name)
    right = sides[-1]
    parts = [_even(at.scalar(left) - at.scalar(right), name) for left in sides[:-1]]
    factor, rest = next((part for part in parts if not part[0].is_zero), (at.ring.zero,) * 2)
    for above, below in parts:
        if factor.is_zero or not (above * rest - below * factor).is_zero:
            raise Meaningless(f"the equation at {printed.place} does not give {name}^2", name)
    granted = granted_factors(map(at.scalar, setting.nonzero))
    # where the factor of the square vanishes, the equation would leave the root free
    if factors_below(factor.inverse()).keys() - granted - factors_below(factor).keys():
        shown = to_latex(formula_in(factor))
        raise Meaningless(
            f"the equation at {printed.place} gives {name}^2 only where {shown} is not zero: "
            f"take that for granted on the scene “{setting.scene.name}”, as in nonzero=(…,)",
            name,
        )
    square = formula_in(-rest / factor)
    left = granted.union(*map(factors_of, at.ring.divisors_of([at.scalar(square)])))
    divisors = at.ring.divisors_of(rest for _, rest in parts)
    gone = [formula_in(divisor) for divisor in divisors if factors_of(divisor).keys() - left]
    if gone:  # what cancels is remembered
        square = Quotient(times(*gone, square), times(*gone))
    return Adjoined(name, square, (sides[0], right))


def _even(element: Element, name: str) -> tuple[Element, Element]:
    """The factor of the square of a generator, and the rest, if it occurs to these powers only."""
    ring = element.ring
    by = {name: ring.one}
    factor = along(along(element, by), by) * ring.number(Fraction(1, 2))
    rest = element - factor * ring.generator(name) ** 2
    without = (factor, rest, *ring.divisors_of([element]))
    # a root in odd powers, or below the line, is not given by an equation for its square
    even = all(along(term, by).is_zero for term in without)
    return (factor, rest) if even else (ring.zero, ring.one)


def _expand_known(at: Evaluation, setting: Meaning, member: Formula) -> Formula | None:
    """A member written out; ``None`` if the scene does not know what it is."""
    try:
        plain = setting.plain(member)
        at.scalar(plain)
    except Meaningless:
        return None
    return plain
