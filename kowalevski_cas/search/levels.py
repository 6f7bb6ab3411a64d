"""Systems of levels of polynomials, and their solutions in small whole numbers.

The equations have to be solved for some variables at once; what is left has to set polynomials
in the other variables equal to expressions in the constants.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
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

    def value(self, element: Element, found: Mapping[str, Fraction]) -> Fraction:
        """The value of an element at a solution."""
        row = [found.get(name, Fraction(0)) for name in self.at.names]
        return value(element.terms().get(0, {}), row)


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


def solutions(system: System) -> Iterator[dict[str, Fraction]]:
    """Solutions in small whole numbers, where the scene makes sense; the smallest first."""
    numbers = [Fraction(n) for n in range(-LARGEST, LARGEST + 1)]
    levels = [system.terms(level) for level in system.levels]
    solved = [(name, system.terms(expression)) for name, expression in system.solved]
    grid = product(numbers, repeat=len(system.unknowns))
    for point in sorted(grid, key=lambda p: (max(map(abs, p), default=0), sum(map(abs, p)))):
        constants = _constants(system, [value(level, point) for level in levels])
        if constants is not None:
            own = dict(zip(system.unknowns, point, strict=True))
            found = own | {name: value(terms, point) for name, terms in solved} | constants
            if all(system.value(element, found) for element in system.at.granted):
                yield found


def _constants(system: System, values: Sequence[Fraction]) -> dict[str, Fraction] | None:
    """Constants for which the levels have these values: each names one constant, or its square."""
    found: dict[str, Fraction] = {}
    for element, number in zip(system.values, values, strict=True):
        if element.is_zero:
            if number:
                return None
            continue
        (exponents, lead), *more = element.terms()[0].items()
        match [(n, e) for n, e in zip(system.at.names, exponents, strict=True) if e]:
            case [(name, 1)]:
                root: Fraction | None = number / lead
            case [(name, 2)]:
                root = square_root(number / lead)
            case _:
                return None
        if more or root is None or found.setdefault(name, root) != root:
            return None
    return found


def written_point(values: dict[str, Fraction]) -> Point:
    """The point as evidence."""
    return Point({name: fraction_formula(number) for name, number in values.items()})


def value(terms: Mapping[tuple[int, ...], Fraction], at: Sequence[Fraction | int]) -> Fraction:
    """The value of a polynomial."""
    values = (prod(map(pow, at, exponents), start=c) for exponents, c in terms.items())
    return sum(values, Fraction(0))


def more_solutions(
    goal: Count, finder: PointFinder, zero: Sequence[Element] = ()
) -> Solutions | None:
    """One solution too many, all in small whole numbers, for constants where ``zero`` vanish."""
    system = system_of(goal, finder.of(goal.space))
    if system is None:
        return None
    groups: dict[tuple[Fraction, ...], list[dict[str, Fraction]]] = {}
    for found in solutions(system):
        if not any(system.value(element, found) for element in zero):
            still = (found.get(name, Fraction(0)) for name in system.at.setting.constants)
            group = groups.setdefault(tuple(still), [])
            group.append(found)
            if len(group) > goal.number:
                return Solutions(tuple(map(written_point, group)))
    return None
