"""Polynomial equations solved by cases: one factor after another, and what is linear eliminated."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import mul

from flint import fmpq_mpoly

Solved = tuple[tuple[int, fmpq_mpoly], ...]


@dataclass(frozen=True)
class Branch:
    """Solutions of equations, by some unknowns as fractions of the others.

    Each of ``solved`` is linear in the unknown at its place, which stands in no other equation, not
    in the ``rest`` either. Nothing in ``nonzero`` vanishes, and the coefficients of these unknowns
    are products of it.
    """

    solved: Solved
    rest: tuple[fmpq_mpoly, ...]
    nonzero: tuple[fmpq_mpoly, ...]

    @property
    def equations(self) -> tuple[fmpq_mpoly, ...]:
        """All equations."""
        return (*(equation for _, equation in self.solved), *self.rest)

    def vanishes(self, polynomial: fmpq_mpoly) -> bool:
        """Whether a polynomial is seen to be zero on the branch."""
        for place, equation in self.solved:
            polynomial = _without(polynomial, place, equation)
        for one in self.rest:
            polynomial = divmod(polynomial, one)[1]
        return polynomial.is_zero()

    def is_part(self, other: Branch) -> bool:
        """Whether the equations of another branch are seen to hold here, and to be solved."""
        slopes = (_part(equation, place, 1) for place, equation in other.solved)
        return all(map(self.vanishes, other.equations)) and not any(map(self.vanishes, slopes))


def branches(
    equations: Iterable[fmpq_mpoly], places: Sequence[int], nonzero: Iterable[fmpq_mpoly] = ()
) -> Iterator[Branch]:
    """Cases that are all solutions together; none is seen to be a part of another one.

    Of two unknowns the one whose place comes first is rather solved for. In what is left no unknown
    is linear; it need not have a solution.
    """
    found = [*_split([*equations], tuple(places), _all_factors(nonzero), ())]
    for k, one in enumerate(found):
        others = ((j, other) for j, other in enumerate(found) if j != k and one.is_part(other))
        if not any(j < k or not other.is_part(one) for j, other in others):
            yield one


def _split(
    equations: Sequence[fmpq_mpoly],
    places: tuple[int, ...],
    nonzero: tuple[fmpq_mpoly, ...],
    solved: Solved,
) -> Iterator[Branch]:
    groups: list[list[fmpq_mpoly]] = []
    for equation in equations:
        factors = [factor for factor in _factors(equation) if factor not in nonzero]
        if not factors and not equation.is_zero():
            return
        if factors and factors not in groups:
            groups.append(factors)
    left = [reduce(mul, group) for group in groups]
    single = [one for one, group in zip(left, groups, strict=True) if len(group) == 1]
    several = [group for group in groups if len(group) > 1]
    linear = [
        (bool(_unknown_factors(one, place, nonzero)), len(one), order, one)
        for one in single
        for order, place in enumerate(places)
        if one.degrees()[place] == 1
    ]
    best = min(linear, key=lambda choice: choice[:3], default=None)
    if best is not None and not (best[0] and several):
        _, _, order, equation = best
        yield from _eliminated(equation, left, places[order], places, nonzero, solved)
    elif several:
        first = min(several, key=lambda group: (len(group), len(reduce(mul, group))))
        others = [one for one, group in zip(left, groups, strict=True) if group is not first]
        for k, factor in enumerate(first):
            yield from _split([factor, *others], places, (*nonzero, *first[:k]), solved)
    else:
        yield Branch(_reduced(solved), tuple(left), nonzero)


def _eliminated(
    equation: fmpq_mpoly,
    left: Sequence[fmpq_mpoly],
    place: int,
    places: tuple[int, ...],
    nonzero: tuple[fmpq_mpoly, ...],
    solved: Solved,
) -> Iterator[Branch]:
    """The cases in which the coefficient of an unknown vanishes, and where it does not."""
    others = [one for one in left if one != equation]
    for factor in _unknown_factors(equation, place, nonzero):
        without = [factor, _part(equation, place, 0), *others]
        yield from _split(without, places, nonzero, solved)
        nonzero = (*nonzero, factor)
    kept = [_without(one, place, equation) for one in nonzero]
    if any(one.is_zero() for one in kept):
        return
    further = [_without(one, place, equation) for one in others]
    rest = tuple(one for one in places if one != place)
    yield from _split(further, rest, _all_factors(kept), (*solved, (place, equation)))


def _factors(polynomial: fmpq_mpoly) -> list[fmpq_mpoly]:
    """The irreducible factors with leading coefficient 1, each once; none of a number."""
    if polynomial.is_zero():
        return []
    return [factor / factor.leading_coefficient() for factor, _ in polynomial.factor()[1]]


def _reduced(solved: Solved) -> Solved:
    """Equations for unknowns without those that later equations are solved for."""
    found: list[tuple[int, fmpq_mpoly]] = []
    for place, equation in reversed(solved):
        for other in found:
            equation = _without(equation, *other)
        (own,) = (factor for factor in _factors(equation) if factor.degrees()[place])
        found.insert(0, (place, own))
    return tuple(found)


def _unknown_factors(
    equation: fmpq_mpoly, place: int, nonzero: Sequence[fmpq_mpoly]
) -> list[fmpq_mpoly]:
    """The factors of the coefficient of an unknown that may vanish."""
    return [f for f in _factors(_part(equation, place, 1)) if f not in nonzero]


def _all_factors(polynomials: Iterable[fmpq_mpoly]) -> tuple[fmpq_mpoly, ...]:
    """The factors of polynomials, each once."""
    found: list[fmpq_mpoly] = []
    for polynomial in polynomials:
        found += [factor for factor in _factors(polynomial) if factor not in found]
    return tuple(found)


def _part(polynomial: fmpq_mpoly, place: int, power: int) -> fmpq_mpoly:
    """The coefficient of a power of the unknown at a place."""
    terms = {
        (*exponents[:place], 0, *exponents[place + 1 :]): value
        for exponents, value in polynomial.to_dict().items()
        if exponents[place] == power
    }
    return polynomial.context().from_dict(terms)


def _without(polynomial: fmpq_mpoly, place: int, equation: fmpq_mpoly) -> fmpq_mpoly:
    """A polynomial times a power of the coefficient of an unknown, which is replaced."""
    slope, rest = _part(equation, place, 1), _part(equation, place, 0)
    degree = int(polynomial.degrees()[place])
    total = polynomial.context().constant(0)
    for power in range(degree + 1):
        total += _part(polynomial, place, power) * (-rest) ** power * slope ** (degree - power)
    return total
