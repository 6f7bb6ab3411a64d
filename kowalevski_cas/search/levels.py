"""Systems of equations that are counted, and their solutions in small whole numbers.

The equations are solved for some variables at once; what is left may set polynomials in the
other variables equal to expressions in the constants, as first integrals do.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, count, islice, product
from math import prod

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import coefficients, terms_of
from kowalevski_cas.algebra.numbers import square_root
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Point, Solutions
from kowalevski_cas.problem.examine import is_real
from kowalevski_cas.problem.goals import Count
from kowalevski_cas.problem.space import all_names
from kowalevski_cas.search.place import PointFinder
from kowalevski_cas.search.points import Assignment, constant, eliminate

LARGEST = 4
"""The largest coordinate of the points that are tried."""

MOST = 60_000
"""The most points that are tried; in many names their coordinates are smaller."""

Solved = list[tuple[int, fmpq_mpoly]]
"""Names by their places, and polynomials in others to which they, or their squares, are equal."""


@dataclass
class LevelEquations:
    """Polynomials in the unknowns and the constants, which vanish.

    ``solved`` gives the other variables through both.
    """

    at: Evaluation
    unknowns: list[str]
    constants: list[str]
    equations: list[fmpq_mpoly]
    solved: Solved

    def terms(self, polynomial: fmpq_mpoly, names: Sequence[str]) -> Terms:
        """A polynomial in neutral form, in names of which it is one."""
        places = [self.at.names.index(name) for name in names]
        return {tuple(e[k] for k in places): v for e, v in terms_of(polynomial).items()}

    def levels(self) -> tuple[list[Terms], list[Element]] | None:
        r"""Levels :math:`P_j(x) = p_j`: polynomials in the unknowns, values in the constants.

        ``None`` if the equations are of another form.
        """
        levels, values = [], []
        own = [self.at.names.index(name) for name in self.unknowns]
        for polynomial in self.equations:
            parts = coefficients(polynomial, own)
            outer = parts.pop((0,) * len(own), polynomial.context().constant(0))
            if not all(part.is_constant() for part in parts.values()):
                return None
            sign = -1 if parts and parts[max(parts)].leading_coefficient() < 0 else 1
            levels.append(self.terms(sign * (polynomial - outer), self.unknowns))
            values.append(self.at.ring.element({0: -sign * outer}, {}))
        return levels, values

    def value(self, element: Element, found: Mapping[str, Fraction]) -> Fraction:
        """The value of an element at a solution."""
        row = [found.get(name, Fraction(0)) for name in self.at.names]
        return value(element.terms().get(0, {}), row)

    def makes_sense(self, found: Mapping[str, Fraction]) -> bool:
        """Whether what is granted of names that have values is not zero."""
        for element in self.at.granted:
            occurring = map(element.ring.polynomials.occurring_places, element.parts.values())
            names = {self.at.names[place] for places in occurring for place in places}
            if element.parts.keys() == {0} and names <= found.keys():
                if not self.value(element, found):
                    return False
        return True


def system_of(goal: Count, finder: PointFinder) -> LevelEquations | None:
    """The system; ``None`` if there are roots, quotients, or other names in it."""
    at, names = finder.of(goal.space), all_names(goal.space)
    constants = [name for name in names if name in at.setting.constants]
    elements = at.differences(goal.equations)
    if any(e.denominator or e.parts.keys() - {0} for e in elements):
        return None
    if not is_real(goal.space) or not {*names} <= {*goal.names, *constants}:
        return None
    polynomials = [e.parts[0] for e in elements if not e.is_zero]
    places = [at.names.index(name) for name in goal.names]
    rest, eliminated = eliminate(polynomials, places)
    solved = _through(eliminated)
    unknowns = [name for name in goal.names if at.names.index(name) not in dict(solved)]
    return LevelEquations(at, unknowns, constants, rest, solved)


def _through(eliminated: Solved) -> Solved:
    """What was solved for in turn, all through what was not."""
    found: Solved = []
    for place, expression in reversed(eliminated):
        images = list(expression.context().gens())
        for known, value in found:
            images[known] = value
        found.append((place, expression.compose(*images, ctx=expression.context())))
    return found[::-1]


def solutions(system: LevelEquations) -> Iterator[dict[str, Fraction]]:
    """Solutions in small whole numbers, where the scene makes sense; the smallest first."""
    names = system.at.names
    unknowns, constants = (
        [names.index(name) for name in own] for own in (system.unknowns, system.constants)
    )
    rest, given = eliminate(system.equations, constants)
    roots, checks = _roots(rest, [k for k in constants if k not in dict(given)])
    free = [k for k in constants if k not in dict(given + roots)]
    order = [*unknowns, *dict(system.solved), *constants]
    for point in small(len(unknowns) + len(free)):
        values = dict(zip((*unknowns, *free), map(Fraction, point), strict=True))
        if not _add_roots(values, roots) or any(constant(check, values) for check in checks):
            continue
        for place, expression in (*reversed(given), *system.solved):
            values[place] = constant(expression, values)
        found = {names[place]: values[place] for place in order}
        if system.makes_sense(found):
            yield found


def small(size: int) -> Iterator[tuple[int, ...]]:
    """Points in small whole numbers, those with the smallest coordinates first."""
    largest = max((n for n in range(2, LARGEST + 1) if (2 * n + 1) ** size <= MOST), default=1)
    grid = islice(product(range(-largest, largest + 1), repeat=size), MOST)
    yield from sorted(grid, key=lambda p: (max(map(abs, p), default=0), sum(map(abs, p))))


def _roots(
    equations: Sequence[fmpq_mpoly], constants: Sequence[int]
) -> tuple[Solved, list[fmpq_mpoly]]:
    """Squares of constants through what has values before, and the equations that give none."""
    roots: Solved = []
    checks = []
    used: set[int] = set()
    for polynomial in equations:
        new = (k for k in constants if k not in used and _is_single_square(polynomial, k))
        place = next(new, None)
        if place is None:
            checks.append(polynomial)
        else:
            lead = polynomial.derivative(place).derivative(place) / 2
            roots.append((place, polynomial.context().gen(place) ** 2 - polynomial / lead))
        used |= {k for k, degree in enumerate(polynomial.degrees()) if degree}
    return roots, checks


def _is_single_square(polynomial: fmpq_mpoly, place: int) -> bool:
    """Whether a name stands in a polynomial in one term only, a multiple of its square."""
    powers = coefficients(polynomial, [place])
    return powers.keys() <= {(0,), (2,)} and (2,) in powers and powers[2,].is_constant()


def _add_roots(values: Assignment, roots: Solved) -> bool:
    """Whether the squares that are given have rational roots, which are entered."""
    for place, square in roots:
        root = square_root(constant(square, values))
        if root is None:
            return False
        values[place] = root
    return True


def new_name(at: Evaluation) -> str:
    """A short name that has no meaning in a space."""
    taken = {*at.names, *at.setting.roots}
    return next(n for n in chain("srnpquvwxyz", map("s_{}".format, count())) if n not in taken)


def point_evidence(values: dict[str, Fraction]) -> Point:
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
    system = system_of(goal, finder)
    if system is None:
        return None
    groups: dict[tuple[Fraction, ...], list[dict[str, Fraction]]] = {}
    for found in solutions(system):
        if not any(system.value(element, found) for element in zero):
            group = groups.setdefault(tuple(found[name] for name in system.constants), [])
            group.append(found)
            if len(group) > goal.number:
                return Solutions(tuple(map(point_evidence, group)))
    return None
