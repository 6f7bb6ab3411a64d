r"""That all polynomial invariants of a map up to a degree are known.

A polynomial that is invariant has the same value at points and at their images: that is linear in
its coefficients, and at enough points nothing else satisfies it than what is known.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import product
from math import prod

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.paper.claims.forms import function, vanishes
from kowalevski_cas.paper.claims.maps import Images, OfMap, expand_definitions
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Follows, Goal
from kowalevski_cas.problem.polynomial_fields import Exponents, Terms, monomials
from kowalevski_cas.problem.space import Meaningless

Values = dict[str, Fraction]
Step = tuple[tuple[Fraction, ...], tuple[Fraction, ...]]
"""A point with its image."""

MOST = 4000
"""How many points are tried."""
MORE = 8
"""How many points in a row have to say nothing new."""


class AllInvariantsOfMap(OfMap):
    """The polynomial invariants up to a degree are polynomials in those that are printed.

    It is so at some ``values`` of the constants, and hence for almost all: there are no more
    invariants with coefficients that depend on the constants than at special ones.
    """

    invariants: tuple[Printed, ...]
    degree: int
    values: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        values = {name: Fraction(value) for name, value in self.values}
        if self.degree < 0 or {*values} != {*self.scene.constants}:
            raise Meaningless("a degree is not negative, and all constants have values")
        map_ = MapAt(space, self.images, values)
        known = [map_.polynomial(function(on, space, place)) for place in self.invariants]
        exponents = map_.exponents(self.degree)
        names = [f"c_{k}" if k < 10 else f"c_{{{k}}}" for k in range(1, len(exponents) + 1)]
        unknown = on(Scene("the coefficients", variables=tuple(names)))
        rows = [*map_.conditions(self.degree)]
        left = annihilators(span(known, len(self.images), self.degree), exponents)
        if left:
            given = tuple(vanishes(_linear(row, names, unknown.finder)) for row in rows)
            conclusion = tuple(vanishes(_linear(row, names, unknown.finder)) for row in left)
            yield Follows(unknown, (conclusion,), given)

    def establishes(self) -> Iterator[Printed]:
        yield from self.invariants


class MapAt:
    """A map by rational functions, at values of its constants."""

    def __init__(self, space: Elaboration, images: Images, values: Values) -> None:
        if space.roots or space.transcendental.groups:
            raise Meaningless("invariants of a map with functions or roots are not looked for")
        self.space, self.values = space, values
        self.names = [name for name, _ in images]
        self.images = [space.plain(expand_definitions(space, Name(new))) for _, new in images]

    def exponents(self, degree: int) -> list[Exponents]:
        """The monomials up to a degree, the constant one first."""
        ones = (1,) * len(self.names)
        return [one for size in range(degree + 1) for one in monomials(ones, size)]

    def image(self, point: Sequence[Fraction]) -> tuple[Fraction, ...]:
        """The image of a point; raises :class:`Meaningless` if it has none."""
        at = self._at({**self.values, **dict(zip(self.names, point, strict=True))})
        return tuple(_number(at, image) for image in self.images)

    def _at(self, values: Values) -> Evaluation:
        at = self.space.free([])
        return at.binding({name: at.ring.number(value) for name, value in values.items()})

    def steps(self) -> Iterator[Step]:
        """Points in general position with their images, as far as they have some."""
        numbers = small_numbers()
        for _ in range(MOST):
            point = tuple(next(numbers) for _ in self.names)
            with suppress(Meaningless):
                yield point, self.image(point)

    def conditions(self, degree: int) -> Iterator[list[Fraction]]:
        """The independent conditions on coefficients, as far as points give them."""
        from kowalevski_cas.algebra.elimination import Echelon
        from kowalevski_cas.algebra.kernels import residue

        exponents, found, idle = self.exponents(degree), Echelon(), 0
        for point, image in self.steps():
            row = [power_of(image, one) - power_of(point, one) for one in exponents]
            new = found.extend({k: residue(value) for k, value in enumerate(row) if value})
            idle = 0 if new else idle + 1
            if new:
                yield row
            if idle == MORE:
                return

    def polynomial(self, formula: Formula) -> Terms:
        """The coefficients of a function; raises :class:`Meaningless` if it is no polynomial."""
        at = self._at(self.values)
        element = at.scalar(self.space.plain(expand_definitions(self.space, formula)))
        if element.denominator or {*element.terms()} - {0}:
            raise Meaningless("an invariant that is no polynomial")
        places = [at.ring.names.index(name) for name in self.names]
        terms = element.terms().get(0, {})
        return {tuple(key[k] for k in places): Fraction(value) for key, value in terms.items()}


def span(known: Sequence[Terms], width: int, degree: int) -> list[Terms]:
    """The products of polynomials in some variables up to a degree, 1 among them."""
    sizes = [max(map(sum, one), default=0) for one in known]
    if not all(sizes):
        raise Meaningless("a constant is no invariant")
    ranges = (range(degree // size + 1) for size in sizes)
    found = []
    for powers in product(*ranges):
        if sum(k * size for k, size in zip(powers, sizes, strict=True)) <= degree:
            whole = {(0,) * width: Fraction(1)}
            for one, k in zip(known, powers, strict=True):
                for _ in range(k):
                    whole = _times(whole, one)
            found.append(whole)
    return found


def annihilators(vectors: Sequence[Terms], exponents: Sequence[Exponents]) -> list[list[Fraction]]:
    """The linear forms of coefficients that vanish on some polynomials."""
    from kowalevski_cas.algebra.kernels import kernel

    columns = [{k: one[key] for k, one in enumerate(vectors) if key in one} for key in exponents]
    return kernel(columns)


def small_numbers() -> Iterator[Fraction]:
    """Small numbers without a rule, always the same ones."""
    state = 1
    while True:
        state = (state * 1103515245 + 12345) % 2**31
        yield Fraction((state >> 16) % 41 - 20, 1 + (state >> 24) % 3)


def _times(left: Terms, right: Terms) -> Terms:
    found: Terms = {}
    for (a, x), (b, y) in product(left.items(), right.items()):
        key = tuple(map(sum, zip(a, b, strict=True)))
        found[key] = found.get(key, Fraction(0)) + x * y
    return {key: value for key, value in found.items() if value}


def power_of(point: Sequence[Fraction], exponents: Exponents) -> Fraction:
    """A monomial at a point."""
    return prod((x**k for x, k in zip(point, exponents, strict=True)), start=Fraction(1))


def _number(at: Evaluation, formula: Formula) -> Fraction:
    """The value of a formula in which all names have values."""
    element = at.scalar(formula)
    terms = element.terms().get(0, {})
    whole = sum((Fraction(value) for value in terms.values()), Fraction(0))
    below = at.ring.divisor_product(element.denominator)
    if below is None:
        return whole
    rest = [*at.ring.polynomials.terms(below).values()]
    return whole / sum(map(Fraction, rest), Fraction(0))


def _linear(row: Sequence[Fraction], names: Sequence[str], at: Evaluation) -> Formula:
    """A linear form of names."""
    total = at.ring.zero
    for value, name in zip(row, names, strict=True):
        total = total + at.ring.number(value) * at.ring.generator(name)
    return formula_in(total)
