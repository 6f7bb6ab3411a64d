"""Polynomial equations solved by cases: one factor after another, and what is linear eliminated."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import terms_of
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.squares import sum_of_squares

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
        polynomial = replace_solved(polynomial, self.solved)
        for one in self.rest:
            polynomial = divmod(polynomial, one)[1]
        return polynomial.is_zero()

    def is_part(self, other: Branch) -> bool:
        """Whether the equations of another branch are seen to hold here, and to be solved."""
        own = dict(self.solved)
        others = [(k, equation) for k, equation in other.solved if own.get(k) != equation]
        equations = (*(equation for _, equation in others), *other.rest)
        slopes = (equation.derivative(place) for place, equation in others)
        return all(map(self.vanishes, equations)) and not any(map(self.vanishes, slopes))


def branches(
    equations: Iterable[fmpq_mpoly], places: Sequence[int], nonzero: Iterable[fmpq_mpoly] = ()
) -> Iterator[Branch]:
    """Cases that are all real solutions together; none is seen to be a part of another one.

    Of two unknowns the one whose place comes first is rather solved for. In what is left no unknown
    is linear; it need not have a solution. Names that stand at no place are in general position.
    """
    granted = tuple(factor for polynomial in nonzero for factor in _factors(polynomial))
    groups = [_factors(equation) for equation in equations if not equation.is_zero()]
    yield from maximal([*_split_cases(groups, tuple(places), granted, ())])


def maximal(found: Sequence[Branch]) -> Iterator[Branch]:
    """Those that are not seen to be a part of another one; of equal ones the first."""
    for k, branch in enumerate(found):
        others = ((j, other) for j, other in enumerate(found) if j != k and branch.is_part(other))
        if not any(j < k or not other.is_part(branch) for j, other in others):
            yield branch


def solve_by_cases(
    task: tuple[Iterable[fmpq_mpoly], Sequence[int], Iterable[fmpq_mpoly]],
) -> list[Branch]:
    """The cases of :func:`branches` for its arguments: a task for a pool."""
    return [*branches(*task)]


class _Factor:
    """An irreducible polynomial with leading coefficient 1."""

    def __init__(self, polynomial: fmpq_mpoly, degrees: tuple[int, ...]) -> None:
        self.polynomial, self.size, self.degrees = polynomial, len(polynomial), degrees
        self._hash = hash((self.size, self.degrees))

    @cached_property
    def key(self) -> str:
        """What puts factors of one size in order."""
        return str(self.polynomial)

    @cached_property
    def linear(self) -> list[int]:
        """The places of unknowns of which a number is the coefficient."""
        places = (k for k, degree in enumerate(self.degrees) if degree == 1)
        return [k for k in places if self.polynomial.derivative(k).is_constant()]

    @cached_property
    def _is_definite(self) -> bool:
        """Whether it is seen to vanish at no real point; no degree is odd then."""
        odd = any(map((1).__and__, self.degrees))
        return not odd and _is_positive(terms_of(self.polynomial))

    def may_vanish(self, places: Sequence[int]) -> bool:
        """Whether it has an unknown in it, and is not seen to vanish at no real point."""
        return any(map(self.degrees.__getitem__, places)) and not self._is_definite

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Factor) and bool(self.polynomial == other.polynomial)

    def __hash__(self) -> int:
        return self._hash


def _is_positive(terms: Terms) -> bool:
    """Whether a polynomial is seen to be a sum of squares of which one is a number."""
    if min(terms) != (0,) * len(min(terms)):
        return False
    squares = sum_of_squares(terms) or ()
    return any(not any(exponents) for _, base in squares for exponents in base if len(base) == 1)


_Group = tuple[_Factor, ...]
"""The factors of an equation, of which one has to vanish."""


def _factors(polynomial: fmpq_mpoly) -> _Group:
    """The irreducible factors, each once; none of a number."""
    degrees = _degrees(polynomial)
    factors = _irreducible(polynomial, degrees)
    if factors == [polynomial]:
        return (_Factor(_monic(polynomial), degrees),)
    return tuple(_Factor(_monic(factor), _degrees(factor)) for factor in factors)


def _degrees(polynomial: fmpq_mpoly) -> tuple[int, ...]:
    return tuple(map(int, polynomial.degrees()))


def _monic(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    leading = polynomial.leading_coefficient()
    return polynomial if leading == 1 else polynomial / leading


def _irreducible(polynomial: fmpq_mpoly, degrees: tuple[int, ...]) -> list[fmpq_mpoly]:
    """The irreducible factors, each once, but for numbers.

    What is linear in an unknown is irreducible, but for what divides both of its coefficients.
    """
    if 1 not in degrees:
        return [factor for factor, _ in polynomial.factor()[1]]
    slope = polynomial.derivative(degrees.index(1))
    if slope.is_constant() or (content := slope.gcd(polynomial)).is_constant():
        return [polynomial]
    return [*(factor for factor, _ in content.factor()[1]), polynomial / content]


def _split_cases(
    equations: Iterable[_Group], places: tuple[int, ...], nonzero: _Group, solved: Solved
) -> Iterator[Branch]:
    groups = _clear_factors(equations, places, nonzero)
    if groups is None:
        return
    single = [group[0] for group in groups if len(group) == 1]
    several = [group for group in groups if len(group) > 1]
    choice = _linear(single, places, nonzero)
    if choice is not None and not (several and choice[2]):
        equation, place, unknown = choice
        left = [group for group in groups if group != (equation,)]
        yield from _eliminate(equation, place, unknown, left, places, nonzero, solved)
    elif several:
        first = min(several, key=lambda group: (sum(factor.size for factor in group), len(group)))
        left = [group for group in groups if group is not first]
        for k, factor in enumerate(first):
            yield from _split_cases([(factor,), *left], places, (*nonzero, *first[:k]), solved)
    else:
        known = tuple(factor.polynomial for factor in nonzero)
        yield Branch(reduce_solutions(solved), tuple(factor.polynomial for factor in single), known)


def _clear_factors(
    equations: Iterable[_Group], places: tuple[int, ...], nonzero: _Group
) -> list[_Group] | None:
    """Equations without factors that cannot vanish; ``None`` if one has no other."""
    known = {*nonzero}
    groups: dict[_Group, None] = {}
    for group in equations:
        left = tuple(
            factor for factor in group if factor not in known and factor.may_vanish(places)
        )
        if not left:
            return None
        groups[left] = None
    single = {group[0] for group in groups if len(group) == 1}
    several = [group for group in groups if len(group) > 1 and not single & {*group}]
    alone = _coprime(single, places)
    return None if alone is None else [*((factor,) for factor in alone), *several]


def _coprime(single: Iterable[_Factor], places: Sequence[int]) -> list[_Factor] | None:
    """Equations, of which two in one and the same unknown alone have no solution."""
    found: list[_Factor] = sorted(single, key=lambda factor: (factor.size, factor.key))
    unknowns = ([place for place in places if factor.degrees[place]] for factor in found)
    alone = [own[0] for own in unknowns if len(own) == 1]
    return None if len({*alone}) < len(alone) else found


_Linear = tuple[_Factor, int, _Group]
"""An equation, the place of an unknown, and the factors of its coefficient that may vanish."""


def _linear(single: Sequence[_Factor], places: Sequence[int], nonzero: _Group) -> _Linear | None:
    """The equation and the unknown that is best solved for."""
    in_order = sorted(single, key=lambda factor: factor.size)
    for equation in in_order:
        for place in places:
            if place in equation.linear:
                return equation, place, ()
    best: _Linear | None = None
    for equation in in_order:
        for place in places:
            if equation.degrees[place] == 1:
                slope = _factors(equation.polynomial.derivative(place))
                unknown = tuple(
                    factor
                    for factor in slope
                    if factor not in nonzero and factor.may_vanish(places)
                )
                if not unknown:
                    return equation, place, ()
                best = best or (equation, place, unknown)
    return best


def _eliminate(
    equation: _Factor,
    place: int,
    unknown: _Group,
    left: Sequence[_Group],
    places: tuple[int, ...],
    nonzero: _Group,
    solved: Solved,
) -> Iterator[Branch]:
    """The cases in which the coefficient of an unknown vanishes, and where it does not."""
    eliminate = Elimination(place, equation.polynomial)
    others = [_factors(-eliminate.value)] if unknown and not eliminate.value.is_zero() else []
    for factor in unknown:
        yield from _split_cases([(factor,), *others, *left], places, nonzero, solved)
        nonzero = (*nonzero, factor)
    kept = [_substitute_factor(factor, eliminate) for factor in nonzero]
    if any(group is None for group in kept):
        return
    granted = tuple(factor for group in kept for factor in group or ())
    further: list[_Group] = []
    for group in left:
        parts = [_substitute_factor(factor, eliminate) for factor in group]
        if None not in parts:
            further.append(tuple(dict.fromkeys(factor for part in parts for factor in part or ())))
    rest_of_places = tuple(other for other in places if other != place)
    yield from _split_cases(
        further, rest_of_places, granted, (*solved, (place, equation.polynomial))
    )


def _substitute_factor(factor: _Factor, eliminate: Elimination) -> _Group | None:
    """The factors of a factor in which an unknown is replaced; ``None`` if it vanishes."""
    if not (degree := factor.degrees[eliminate.place]):
        return (factor,)
    polynomial = eliminate(factor.polynomial, degree)
    return None if polynomial.is_zero() else _factors(polynomial)


def reduce_solutions(solved: Solved) -> Solved:
    """Equations for unknowns without those that later equations are solved for."""
    found: list[tuple[int, fmpq_mpoly]] = []
    for place, equation in reversed(solved):
        if len(equation) > 1:  # else the unknown is zero
            equation = replace_solved(equation, found)
            own = next(factor for factor in _factors(equation) if factor.degrees[place])
            equation = own.polynomial
        found.insert(0, (place, equation))
    return tuple(found)


def coefficients(polynomial: fmpq_mpoly, place: int) -> Iterator[fmpq_mpoly]:
    """The coefficients of the powers of the unknown at a place, the lowest first."""
    context = polynomial.context()
    name, unknown = context.name(place), context.gen(place)
    while not polynomial.is_zero():
        lowest = polynomial.subs({name: 0})
        yield lowest
        polynomial = (polynomial - lowest) / unknown


class Elimination:
    """An unknown is replaced by what an equation says of it, which is linear in it."""

    def __init__(self, place: int, equation: fmpq_mpoly) -> None:
        self.place, self.slope = place, equation.derivative(place)
        if self.slope.is_constant():
            equation = equation / self.slope.leading_coefficient()
            self.slope = equation.context().constant(1)
        self.equation = equation

    @cached_property
    def value(self) -> fmpq_mpoly:
        """The coefficient times the unknown."""
        return self.slope * self.equation.context().gen(self.place) - self.equation

    def __call__(self, polynomial: fmpq_mpoly, degree: int) -> fmpq_mpoly:
        """A polynomial of some degree in the unknown, times as many coefficients of it."""
        if degree == 1:
            less = polynomial.derivative(self.place) * self.equation
            return (polynomial if self.slope.is_one() else self.slope * polynomial) - less
        context = polynomial.context()
        total, power = context.constant(0), context.constant(1)
        for coefficient in reversed([*coefficients(polynomial, self.place)]):
            total, power = total * self.value + coefficient * power, power * self.slope
        return total


def replace_solved(polynomial: fmpq_mpoly, solved: Iterable[tuple[int, fmpq_mpoly]]) -> fmpq_mpoly:
    """A polynomial times coefficients of unknowns, which are replaced one after the other."""
    degrees = _degrees(polynomial)
    for place, equation in solved:
        if (degree := degrees[place]) > 0:  # it is −1 of what vanishes
            polynomial = Elimination(place, equation)(polynomial, degree)
            degrees = _degrees(polynomial)
    return polynomial


def without(polynomial: fmpq_mpoly, place: int, equation: fmpq_mpoly) -> fmpq_mpoly:
    """A polynomial times a power of the coefficient of an unknown, which is replaced.

    If the coefficient is a number, nothing is multiplied.
    """
    return replace_solved(polynomial, [(place, equation)])
