"""Exact rational points on polynomial constraints."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import chain, count, islice, product
from math import prod

from flint import fmpq, fmpq_mpoly

from kowalevski_cas.algebra.flint import to_flint, to_fraction
from kowalevski_cas.algebra.numbers import square_root

Assignment = dict[int, Fraction]

ATTEMPTS = 400
"""How many starting values are tried with each choice of variables."""

FIRST = 6
"""How many of these are tried with all choices, before the others are tried with any."""

RATIOS = 100
"""How many are tried after these among the ratios of the sides of right triangles."""

CHOICES = 6
"""How many choices of variables to be solved for are tried."""

TRIED = 100
"""Among how many choices these are looked for."""

KEPT = 16
"""Of how many sets of constraints the points are kept."""

DENOMINATORS = (1, 2, 3, 3, 7)
"""Denominators of the coordinates that are chosen, in turn."""


def points(
    constraints: Sequence[fmpq_mpoly], variables: Sequence[int], avoid: Sequence[fmpq_mpoly] = ()
) -> Iterator[Assignment]:
    """Rational points where the constraints vanish and the expressions to avoid do not.

    ``variables`` are indices of generators. Variables that a constraint gives at
    once are eliminated. For the constraints that remain, one variable each is
    solved for, while all others get small values from a fixed sequence: where the
    equations are linear, or have rational roots.
    """
    rest, eliminated = eliminate([c for c in constraints if not c.is_zero()], variables, False)
    avoided = [_substitute_found(a, eliminated) for a in avoid]
    if any(c.is_constant() for c in rest) or any(a.is_zero() for a in avoided):
        return
    gone = {v for v, _ in eliminated}
    for values in _known_completions(rest, [v for v in variables if v not in gone]):
        if not any(constant(a, values) == 0 for a in avoided):
            yield _with_eliminated({**values}, eliminated)


class _Kept:
    """What comes out of an iterator, for all who ask for it: each is found once."""

    def __init__(self, begin: Callable[[], Iterator[Assignment]]) -> None:
        self._begin, self._found, self._kept = begin, begin(), list[Assignment]()

    def __iter__(self) -> Iterator[Assignment]:
        for place in count():
            if place == len(self._kept):
                try:
                    following = next(self._found, None)
                except BaseException:  # as an interruption: there may be more than these
                    self._found = islice(self._begin(), place, None)
                    raise
                if following is None:
                    return
                self._kept.append(following)
            yield self._kept[place]


_kept: OrderedDict[object, _Kept] = OrderedDict()
"""The last points of some constraints: goals that have the same hypotheses ask for the same."""


def _known_completions(constraints: list[fmpq_mpoly], variables: list[int]) -> Iterable[Assignment]:
    """The points of :func:`_completions`, if need be those that were found before."""
    key = (*map(str, constraints), *variables)
    if key not in _kept:
        _kept[key] = _Kept(partial(_completions, constraints, variables))
    _kept.move_to_end(key)
    while len(_kept) > KEPT:
        _kept.popitem(last=False)
    return _kept[key]


def _completions(constraints: list[fmpq_mpoly], variables: Sequence[int]) -> Iterator[Assignment]:
    """One point for each choice of starting values, then the other roots for these."""
    tried = islice(_choices(constraints, variables), TRIED)
    choices = [*islice((one for one in tried if _is_solvable(constraints, one)), CHOICES)]
    others = []
    ways = ((small_numbers, 0, FIRST), (small_numbers, FIRST, ATTEMPTS), (_ratios, 0, RATIOS))
    for (numbers, first, last), solved in product(ways, choices):
        free = [v for v in variables if v not in solved]
        for sequence in islice(numbers(), first, last if free else 1):
            found = _complete(constraints, len(solved), {v: next(sequence) for v in free})
            yield from islice(found, 1)
            others.append(found)
    yield from chain.from_iterable(others)


def constant(polynomial: fmpq_mpoly, values: Mapping[int, Fraction]) -> Fraction:
    """The value of a polynomial at a point."""
    places = range(polynomial.context().nvars())
    return to_fraction(polynomial(*(to_flint(values.get(k, Fraction(0))) for k in places)))


def eliminate(
    constraints: list[fmpq_mpoly], variables: Sequence[int], powers: bool = True
) -> tuple[list[fmpq_mpoly], list[tuple[int, fmpq_mpoly]]]:
    """Solve constraints that are linear in a variable with a constant coefficient.

    Without ``powers`` each factor stands once: the zeros are the same, and the ideal is not.
    """
    eliminated: list[tuple[int, fmpq_mpoly]] = []
    while True:
        found = next(((c, v) for c in constraints for v in variables if _gives(c, v)), None)
        if found is None:
            return distinct(constraints), eliminated
        constraint, variable = found
        context = constraint.context()
        generators = list(context.gens())
        expression = generators[variable] - constraint / constraint.derivative(variable)
        generators[variable] = expression
        eliminated.append((variable, expression))
        substituted = (c.compose(*generators, ctx=context) for c in constraints)
        constraints = [c for c in substituted if not c.is_zero()]
        if not powers:
            constraints = [*map(_without_powers, constraints)]


def _without_powers(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """What has the zeros of a polynomial, each once: of r² = 0 none would be found."""
    factors = polynomial.factor_squarefree()[1]
    if all(exponent == 1 for _, exponent in factors):
        return polynomial
    return prod((base for base, _ in factors), start=polynomial.context().constant(1))


def _substitute_found(
    polynomial: fmpq_mpoly, eliminated: Sequence[tuple[int, fmpq_mpoly]]
) -> fmpq_mpoly:
    """A polynomial with what was found for the eliminated variables."""
    context = polynomial.context()
    for variable, expression in eliminated:
        generators = list(context.gens())
        generators[variable] = expression
        polynomial = polynomial.compose(*generators, ctx=context)
    return polynomial


def distinct(polynomials: Sequence[fmpq_mpoly]) -> list[fmpq_mpoly]:
    """Polynomials of which none is another one times a number."""
    return list({str(p / p.leading_coefficient()): p for p in polynomials}.values())


def _gives(constraint: fmpq_mpoly, variable: int) -> bool:
    return constraint.degrees()[variable] == 1 and constraint.derivative(variable).is_constant()


def _choices(constraints: list[fmpq_mpoly], variables: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """A variable for each constraint, of low degree in it; those that occur in few come first.

    No constraint is of a higher degree than 2 in it, unless there is no such choice.
    """
    occurring = [{v: int(c.degrees()[v]) for v in variables if c.degrees()[v]} for c in constraints]
    shared = {v: sum(v in degrees for degrees in occurring) for v in variables}
    usable = [{v for v, degree in degrees.items() if degree <= 2} for degrees in occurring]
    if not _has_matching(usable):
        usable = [{*degrees} for degrees in occurring]

    def extend(chosen: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
        if len(chosen) == len(constraints):
            yield chosen
            return
        if not _has_matching([columns.difference(chosen) for columns in usable[len(chosen) :]]):
            return
        degrees = occurring[len(chosen)]
        own = usable[len(chosen)].difference(chosen)
        for v in sorted(own, key=lambda v: (degrees[v], shared[v], v)):
            yield from extend((*chosen, v))

    return extend(())


def _is_solvable(constraints: list[fmpq_mpoly], unknowns: tuple[int, ...]) -> bool:
    """Whether equations can be solved in turn, or one is linear, for any values of the others."""
    left = [{v for v in unknowns if c.degrees()[v]} for c in constraints]
    while any(left):
        single = next((own for own in left if len(own) == 1), None)
        if single is None:
            pairs = zip(constraints, left, strict=True)
            return any(_is_linear(c, v, own) for c, own in pairs for v in own)
        left = [own - single for own in left]
    return True


def _is_linear(constraint: fmpq_mpoly, variable: int, unknowns: set[int]) -> bool:
    """Whether a constraint is linear in an unknown, and no other one stands before that."""
    if constraint.degrees()[variable] != 1:
        return False
    degrees = constraint.derivative(variable).degrees()
    return not any(degrees[v] for v in unknowns)


def _has_matching(sets: Sequence[set[int]]) -> bool:
    """Whether an element can be chosen from each set, all of them different."""
    owner: dict[int, int] = {}

    def place(k: int, tried: set[int]) -> bool:
        for v in sets[k] - tried:
            tried.add(v)
            if v not in owner or place(owner[v], tried):
                owner[v] = k
                return True
        return False

    return all(place(k, set()) for k in range(len(sets)))


def _complete(
    constraints: list[fmpq_mpoly], unknowns: int, values: Assignment
) -> Iterator[Assignment]:
    """The values with those of the unknown variables, which are solved for one after another."""
    left, single = _first_to_solve(values, constraints)
    if not unknowns:
        yield from [] if left else [values]
        return
    if single is not None:
        for found in _solve_one(single):
            yield from _complete(left, unknowns - 1, {**values, **found})
        return
    occurring = sorted({k for c in left for k, d in enumerate(c.degrees()) if d})
    rest, eliminated = eliminate(left, occurring, False)
    if eliminated:
        for found in _complete(rest, unknowns - len(eliminated), {}):
            yield values | _with_eliminated(found, eliminated)


def _with_eliminated(
    values: Assignment, eliminated: Sequence[tuple[int, fmpq_mpoly]]
) -> Assignment:
    """Values with those of the eliminated variables."""
    for variable, expression in reversed(eliminated):
        values[variable] = constant(expression, values)
    return values


def _solve_one(polynomial: fmpq_mpoly) -> Iterator[Assignment]:
    """The rational roots of a polynomial in one variable, in the order of the quadratic formula."""
    variable, degree = next((k, d) for k, d in enumerate(polynomial.degrees()) if d)
    if degree == 2 and square_root(_discriminant(polynomial, variable)) is None:
        return iter(())
    roots = [
        -constant(factor, {}) / to_fraction(factor.derivative(variable).leading_coefficient())
        for factor, _ in polynomial.factor()[1]
        if factor.total_degree() == 1
    ]
    upwards = polynomial.leading_coefficient() < 0
    return ({variable: root} for root in sorted(roots, reverse=not upwards))


def _discriminant(polynomial: fmpq_mpoly, variable: int) -> Fraction:
    """The discriminant of a quadratic polynomial in one variable."""
    by_degree = {int(m[variable]): to_fraction(c) for m, c in polynomial.to_dict().items()}
    c, b, a = (by_degree.get(degree, Fraction(0)) for degree in range(3))
    return b * b - 4 * a * c


def _first_to_solve(
    values: Assignment, constraints: list[fmpq_mpoly]
) -> tuple[list[fmpq_mpoly], fmpq_mpoly | None]:
    """What constraints say of the other variables, and the first that says it of one alone.

    Those behind it are left as they are: if it has no root nobody needs them.
    """
    entered: dict[str | int, fmpq] = {k: to_flint(value) for k, value in values.items()}
    left: list[fmpq_mpoly] = []
    for place, constraint in enumerate(constraints):
        condition = constraint.subs(entered)
        if not condition.is_zero():
            left.append(condition)
            if sum(1 for degree in condition.degrees() if degree) == 1:
                return [*left, *constraints[place + 1 :]], condition
    return left, None


def _ratios() -> Iterator[Iterator[Fraction]]:
    """Sequences of ratios of the sides of right triangles with small sides, and their inverses.

    With them 1 - x² is a square, and products of them are such ratios again more often than not.
    """
    sides = ((3, 4, 5), (5, 12, 13), (8, 15, 17))
    pairs = [(a, b) for side in sides for a in side for b in side if a != b]
    for attempt in count(1):
        state = attempt * 69069 & 0x7FFFFFFF
        yield _choose(state, [Fraction(a, b) for a, b in pairs])


def _choose(state: int, numbers: Sequence[Fraction]) -> Iterator[Fraction]:
    while True:
        state = state * 1103515245 + 12345 & 0x7FFFFFFF
        sign = 1 if state >> 12 & 1 else -1
        yield sign * numbers[(state >> 16) % len(numbers)]


def small_numbers() -> Iterator[Iterator[Fraction]]:
    """Sequences of small non-zero rationals, irregular and the same in every run.

    Each sequence has one denominator, sometimes doubled: points of spheres and
    cones lie there.
    """
    state = 1
    for attempt in count():
        denominator = DENOMINATORS[attempt % len(DENOMINATORS)]
        state = state * 69069 + 1 & 0x7FFFFFFF
        yield _sequence(state, denominator, max(4, denominator - 1))


def _sequence(state: int, denominator: int, largest: int) -> Iterator[Fraction]:
    while True:
        state = state * 1103515245 + 12345 & 0x7FFFFFFF
        numerator = (state >> 16) % (2 * largest + 1) - largest
        if numerator:
            half = denominator > 2 and state >> 12 & 1
            yield Fraction(numerator, 2 * denominator if half else denominator)
