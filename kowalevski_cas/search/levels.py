"""Systems of levels of polynomials, and their solutions in small whole numbers.

The equations have to be solved for some variables at once; what is left has to set polynomials
in the other variables equal to expressions in the constants.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import prod

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import coefficients
from kowalevski_cas.algebra.numbers import square_root
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Point, Solutions
from kowalevski_cas.problem.goals import Count
from kowalevski_cas.search.place import PointFinder
from kowalevski_cas.search.points import eliminate

LARGEST = 4
"""The largest coordinate of the points that are tried."""

Values = tuple[Fraction, ...]


@dataclass
class System:
    """Levels :math:`P_j(x) = p_j`: polynomials in the unknowns, and values in the constants.

    ``solved`` gives the other variables through the unknowns.
    """

    at: Evaluation
    unknowns: list[str]
    levels: list[fmpq_mpoly]
    values: list[Element]
    solved: list[tuple[str, fmpq_mpoly]]

    def terms(self, polynomial: fmpq_mpoly) -> Terms:
        """A polynomial in neutral form, in the unknowns."""
        places = [self.at.names.index(name) for name in self.unknowns]
        terms = self.at.ring.polynomials.terms(polynomial)
        return {tuple(e[k] for k in places): v for e, v in terms.items()}


def system_of(goal: Count, at: Evaluation) -> System | None:
    """The system for the unknowns; ``None`` if the equations are of another form."""
    elements = at.differences(goal.equations)
    if any(e.denominator or e.parts.keys() - {0} for e in elements):
        return None
    polynomials = [e.parts[0] for e in elements if not e.is_zero]
    places = {name: at.names.index(name) for name in goal.names}
    rest, solved = eliminate(polynomials, list(places.values()))
    gone = {place for place, _ in solved}
    unknowns = [name for name, place in places.items() if place not in gone]
    levels, values = [], []
    own = [places[name] for name in unknowns]
    for polynomial in rest:
        parts = coefficients(polynomial, own)
        outer = parts.pop((0,) * len(own), polynomial.context().constant(0))
        if not all(part.is_constant() for part in parts.values()):
            return None
        levels.append(polynomial - outer)
        values.append(at.ring.element({0: -outer}, {}))
    back = [(at.names[place], expression) for place, expression in solved]
    return System(at, unknowns, levels, values, _through(back, at))


def _through(solved: list[tuple[str, fmpq_mpoly]], at: Evaluation) -> list[tuple[str, fmpq_mpoly]]:
    """Variables that were solved for in turn, all through the unknowns."""
    images = list(at.ring.polynomials.zero.context().gens())
    found = []
    for name, expression in reversed(solved):
        images[at.names.index(name)] = expression.compose(*images)
        found.append((name, images[at.names.index(name)]))
    return found[::-1]


def constants_for(system: System, values: Values) -> dict[str, Fraction] | None:
    """Constants for which the levels have these values: each names one constant, or its square."""
    found = {}
    for element, number in zip(system.values, values, strict=True):
        ((exponents, lead),) = element.terms()[0].items()
        name, power = next((system.at.names[k], e) for k, e in enumerate(exponents) if e)
        size = number / lead
        root = size if power == 1 else square_root(size) if power == 2 else None
        if root is None or sum(exponents) != power:
            return None
        found[name] = root
    return found


def solution(system: System, point: Values, constants: dict[str, Fraction]) -> dict[str, Fraction]:
    """All names at a point of the unknowns."""
    own = dict(zip(system.unknowns, point, strict=True))
    for name, expression in system.solved:
        own[name] = value(system.terms(expression), point)
    return own | constants


def written_point(values: dict[str, Fraction]) -> Point:
    """The point as evidence."""
    return Point({name: fraction_formula(number) for name, number in values.items()})


def value(terms: Mapping[tuple[int, ...], Fraction], at: Sequence[Fraction | int]) -> Fraction:
    """The value of a polynomial."""
    values = (prod(map(pow, at, exponents), start=c) for exponents, c in terms.items())
    return sum(values, Fraction(0))


def small_points(levels: Sequence[Terms], size: int) -> Iterator[tuple[Values, Values]]:
    """Points with small integer coordinates, and what the levels are there; small ones first."""
    numbers = [Fraction(n) for n in range(-LARGEST, LARGEST + 1)]
    grid = product(numbers, repeat=size)
    for point in sorted(grid, key=lambda p: (max(map(abs, p)), sum(map(abs, p)))):
        yield point, tuple(value(level, point) for level in levels)


def many(
    levels: Sequence[Terms], size: int, count: int, usable: Callable[[Values], bool]
) -> list[Values] | None:
    """``count`` points with the same usable values of the levels."""
    groups: dict[Values, list[Values]] = {}
    for point, values in small_points(levels, size):
        if usable(values):
            group = groups.setdefault(values, [])
            group.append(point)
            if len(group) == count:
                return group
    return None


def more_solutions(
    goal: Count, finder: PointFinder, zero: Sequence[Element] = ()
) -> Solutions | None:
    """One solution too many, all in small whole numbers, for constants where ``zero`` vanish."""
    at = finder.of(goal.space)
    system = system_of(goal, at)
    if system is None:
        return None
    granted = at.granted

    def usable(values: Values) -> bool:
        constants = constants_for(system, values)
        if constants is None:
            return False
        row = [constants.get(name, Fraction(0)) for name in at.names]
        return all(value(g.terms().get(0, {}), row) for g in granted) and not any(
            value(z.terms().get(0, {}), row) for z in zero
        )

    levels = [system.terms(level) for level in system.levels]
    points = many(levels, len(system.unknowns), goal.number + 1, usable)
    if points is None:
        return None
    values = tuple(value(level, points[0]) for level in levels)
    constants = constants_for(system, values)
    assert constants is not None
    return Solutions(tuple(written_point(solution(system, p, constants)) for p in points))
