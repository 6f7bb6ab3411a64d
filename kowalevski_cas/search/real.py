r"""Exact points of a space that a real motion can pass through.

Variables that are each other's conjugates get values :math:`u\pm iv`, all
others real ones.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from itertools import islice
from math import prod

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.numbers import square_root
from kowalevski_cas.algebra.points import ExactPoint
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.search.points import Assignment, constant, distinct, points
from kowalevski_cas.search.positive import positive_points

RATIONAL_ROOTS = 100
"""How many points are looked at for one at which all roots are rational."""

LARGE = 2000
"""A polynomial with so many terms is put in last: few points are left then."""

MANY = 12
"""So many roots are hardly ever real all at once at a point in general position."""


class RealCoordinates:
    """Real coordinates for the generators of a space, and its elements in them.

    Of the roots only those in ``names`` matter. Those on which others rest are coordinates, too,
    if these are ``inner_roots`` that matter.
    """

    def __init__(
        self,
        at: Evaluation,
        constraints: Sequence[Element],
        names: Sequence[str],
        inner_roots: bool = True,
    ) -> None:
        self.ring = ring = at.ring
        pairs = dict(at.setting.conjugates)
        partners = {b: a for a, b in pairs.items()}
        # A root is one as well if it has a conjugate, if others rest on it, or if a constraint
        # has terms with it and without it.
        roots = {
            name: radicand
            for name, radicand in zip(ring.roots, ring.radicands, strict=True)
            if name in names and (name != "i" or not self._has_unit)
        }
        inner = {bit for r in roots.values() for mask in r.parts for bit in _bits(mask)}
        inner |= {bit for element in constraints for bit in _roots_in_some(element)}
        if not inner_roots:
            unit = {bit for bit, name in enumerate(ring.roots) if name == "i"}
            over = {name: {b for mask in r.parts for b in _bits(mask)} for name, r in roots.items()}
            roots, inner = {name: r for name, r in roots.items() if over[name] <= unit}, set()
        moving = {*at.setting.coordinates, *pairs, *partners, *(ring.roots[bit] for bit in inner)}
        self.moving = [name for name in roots if name in moving]
        self.radicands = [roots[name] for name in roots if name not in moving]
        self.names = [n for n in (*ring.polynomials.generators, *self.moving)]
        self.context = fmpq_mpoly_ctx.get(
            tuple(f"g{k}" for k in range(len(self.names) + 1)), Ordering.lex
        )
        *coordinates, self.unit = self.context.gens()
        place = {name: coordinates[k] for k, name in enumerate(self.names)}
        self.images: dict[str, fmpq_mpoly] = {}
        for name in self.names:
            if name in pairs:
                self.images[name] = place[name] + self.unit * place[pairs[name]]
            elif name in partners:
                self.images[name] = place[partners[name]] - self.unit * place[name]
            else:
                self.images[name] = place[name]
        if self._has_unit:
            self.images["i"] = self.unit
        self.pairs = pairs

    @property
    def _has_unit(self) -> bool:
        """Whether i is the imaginary unit; with another square it is a root like others."""
        squares = dict(zip(self.ring.roots, self.ring.radicands, strict=True))
        return "i" in squares and (squares["i"] + self.ring.one).is_zero

    def equations(self, element: Element) -> list[fmpq_mpoly]:
        """Real polynomials whose vanishing makes the element vanish."""
        return [part for value in self.by_roots(element).values() for part in self.split(value)]

    def by_roots(self, element: Element) -> dict[frozenset[str], fmpq_mpoly]:
        """The numerator in the real coordinates, by the roots that are none of them."""
        ring, groups = self.ring, dict[frozenset[str], fmpq_mpoly]()
        values = [self.images[name] for name in ring.polynomials.generators]
        for mask, part in element.parts.items():
            names = frozenset(ring.roots[bit] for bit in _bits(mask))
            rest = names.difference(self.images)
            known = (self.images[name] for name in names - rest)
            value = prod(known, start=part.compose(*values, ctx=self.context))
            groups[rest] = groups.get(rest, self.context.constant(0)) + value
        return groups

    def split(self, polynomial: fmpq_mpoly) -> list[fmpq_mpoly]:
        """The real and the imaginary part, where they do not vanish."""
        if not polynomial.degrees()[-1]:  # i stands nowhere
            return [] if polynomial.is_zero() else [polynomial]
        parts: list[dict[tuple[int, ...], fmpq]] = [{}, {}]
        for exponents, value in polynomial.to_dict().items():
            power = exponents[-1]
            part = parts[power % 2]
            key = (*exponents[:-1], 0)
            part[key] = part.get(key, fmpq(0)) + (-value if power % 4 >= 2 else value)
        polynomials = [self.context.from_dict(part) for part in parts]
        return [p for p in polynomials if not p.is_zero()]

    def relations(self) -> list[fmpq_mpoly]:
        """The equations that the roots among the variables satisfy."""
        ring = self.ring
        found = []
        for name in self.moving:
            radicand = ring.radicands[ring.roots.index(name)]
            (value,) = self.by_roots(radicand).values()
            found.extend(self.split(self.images[name] ** 2 - value))
        return found

    def point(self, assignment: Assignment) -> ExactPoint:
        """The exact point with these coordinates."""
        value = {name: assignment[k] for k, name in enumerate(self.names)}
        result: dict[str, tuple[Fraction, Fraction]] = {}
        for name in self.names:
            result[name] = (value[name], Fraction(0))
        for a, b in self.pairs.items():
            if a in value:
                result[a] = (value[a], value[b])
                result[b] = (value[a], -value[b])
        return result


def _bits(mask: int) -> Iterator[int]:
    return (bit for bit in range(mask.bit_length()) if mask >> bit & 1)


def _roots_in_some(element: Element) -> Iterator[int]:
    """The roots that stand in some parts of an element and not in others."""
    for bit in range(len(element.ring.roots)):
        if len({mask >> bit & 1 for mask in element.parts}) == 2:
            yield bit


def real_points(
    at: Evaluation,
    names: Sequence[str],
    zero: Sequence[Element] = (),
    nonzero: Sequence[Element] = (),
) -> Iterator[ExactPoint]:
    """Exact points where some elements vanish and others do not, with rational roots first.

    ``names`` are those to which a point has to give values. Roots that are variables are rational.
    """
    coordinates = RealCoordinates(at, zero, names)
    constraints = [e for element in zero for e in coordinates.equations(element)]
    constraints = distinct([*constraints, *coordinates.relations()])
    avoid = sorted(_to_avoid(nonzero, coordinates), key=lambda part: len(part) > LARGE)
    small = sum(len(part) <= LARGE for part in avoid)
    found = points(constraints, range(len(coordinates.names)), avoid[:small])
    radicands = [*map(coordinates.equations, coordinates.radicands)]

    def usable(assignments: Iterable[Assignment]) -> Iterator[tuple[bool, Assignment]]:
        """Points at which no radicand is negative, and whether all are squares."""
        for assignment in assignments:
            values = list[Fraction]()
            for parts in radicands:
                values.append(sum((constant(part, assignment) for part in parts), Fraction(0)))
                if values[-1] < 0:
                    break
            else:
                rational = all(square_root(value) is not None for value in values)
                yield rational, assignment

    def there(assignments: Iterable[Assignment]) -> Iterator[ExactPoint]:
        """The points where large polynomials do not vanish either."""
        for assignment in assignments:
            if all(constant(part, assignment) for part in avoid[small:]):
                yield coordinates.point(assignment)

    yield from there(_rational_first(usable(islice(found, RATIONAL_ROOTS))))
    if constraints or len(radicands) <= MANY:
        yield from there(assignment for _, assignment in usable(found))
    if not any(map(coordinates.equations, zero)):
        alone = RealCoordinates(at, zero, names, inner_roots=False)
        yield from () if alone.moving else _by_steps(alone, nonzero)


def _rational_first(found: Iterable[tuple[bool, Assignment]]) -> Iterator[Assignment]:
    """The points at which all roots are rational, and then the others."""
    others = []
    for rational, assignment in found:
        if rational:
            yield assignment
        else:
            others.append(assignment)
    yield from others


def _by_steps(coordinates: RealCoordinates, nonzero: Sequence[Element]) -> Iterator[ExactPoint]:
    """Points at which no root is taken of what is negative, by steps towards them."""
    parts = [part for one in coordinates.radicands for part in coordinates.equations(one)]
    avoid = _to_avoid(nonzero, coordinates)
    yield from map(coordinates.point, positive_points(parts, len(coordinates.names), avoid))


def _to_avoid(nonzero: Sequence[Element], coordinates: RealCoordinates) -> list[fmpq_mpoly]:
    """What vanishes where some of these elements does, without the factors that others have."""
    found = []
    for element in nonzero:
        equations = coordinates.equations(element)
        if len(equations) == 1:
            found.append(equations[0])
        elif equations:
            found.append(sum((e * e for e in equations), coordinates.context.constant(0)))
    shorter: list[fmpq_mpoly] = []
    for polynomial in sorted(found, key=len):
        shorter.append(reduce(_without, shorter, polynomial))
    return shorter


def _without(polynomial: fmpq_mpoly, factor: fmpq_mpoly) -> fmpq_mpoly:
    """A polynomial divided by a factor as often as it has it."""
    if factor.is_constant():
        return polynomial
    while not (divided := divmod(polynomial, factor))[1]:
        polynomial = divided[0]
    return polynomial


def points_with_squares(
    at: Evaluation,
    names: Sequence[str],
    zero: Sequence[Element] = (),
    nonzero: Sequence[Element] = (),
) -> Iterator[tuple[ExactPoint, dict[str, Fraction]]]:
    """Points as of :func:`real_points`, and the rational squares of the other variables.

    These are those of which all equations have even powers only; not all that does not vanish is
    looked at. There is no such point where there is no such variable.
    """
    coordinates = RealCoordinates(at, zero, names)
    constraints = [e for element in zero for e in coordinates.equations(element)]
    constraints = distinct([*constraints, *coordinates.relations()])
    radicands = [
        part for radicand in coordinates.radicands for part in coordinates.equations(radicand)
    ]
    squared = {
        place
        for place, name in enumerate(coordinates.names)
        if name not in {*coordinates.moving, *coordinates.pairs, *coordinates.pairs.values()}
        and any(constraint.degrees()[place] for constraint in constraints)
        and _is_even([*constraints, *radicands], place)
    }
    if not squared:
        return
    halves = [_halved(polynomial, squared) for polynomial in (*constraints, *radicands)]
    avoid = [
        _halved(equation, squared)
        for element in nonzero
        for equation in coordinates.equations(element)[:1]
        if all(_is_even([equation], place) for place in squared)
    ]
    positive = [coordinates.context.gens()[place] for place in squared]
    positive += halves[len(constraints) :]
    for values in points(halves[: len(constraints)], range(len(coordinates.names)), avoid):
        if all(constant(polynomial, values) >= 0 for polynomial in positive):
            point = {**coordinates.point(values)}
            found = {coordinates.names[place]: values[place] for place in squared}
            yield {name: point[name] for name in point.keys() - found.keys()}, found


def _is_even(polynomials: Sequence[fmpq_mpoly], place: int) -> bool:
    return not any(
        int(exponents[place]) % 2 for polynomial in polynomials for exponents in polynomial.monoms()
    )


def _halved(polynomial: fmpq_mpoly, places: Container[int]) -> fmpq_mpoly:
    """A polynomial in the squares of some variables, by these."""
    return polynomial.context().from_dict(
        {
            tuple(int(e) // 2 if k in places else int(e) for k, e in enumerate(exponents)): value
            for exponents, value in polynomial.to_dict().items()
        }
    )
