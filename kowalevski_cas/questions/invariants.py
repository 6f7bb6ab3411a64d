"""Find the polynomial invariants of a map, up to a degree, and that there are no others.

The coefficients are polynomials in the constants. That there are no others is claimed where it is
so at some values of the constants: then it is so at almost all.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import islice
from math import prod

from kowalevski_cas.algebra.elimination import Echelon
from kowalevski_cas.algebra.kernels import kernel, residue
from kowalevski_cas.algebra.polynomials import primitive
from kowalevski_cas.algebra.present import formula_in, fraction_formula
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name, to_latex
from kowalevski_cas.paper.claims import AllInvariantsOfMap, InvariantOfMap
from kowalevski_cas.paper.claims.all_invariants import (
    at_values,
    exponents_up_to,
    products_of,
    terms_of,
)
from kowalevski_cas.paper.claims.maps import expand_definitions
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.names import Images
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.polynomial_fields import Exponents, Terms, monomials
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.finding import Attribute, Finding

Point = tuple[Fraction, ...]

DEGREE = 4
"""The highest degree, if none is given."""
CONSTANTS = 2
"""The largest degree of coefficients in the constants."""
VALUES = (2, 3, 5, 7, 11, 13)
"""For constants, one after the other."""
TRIES = 3
"""How many values of the constants are looked at."""
MOST = 4000
"""How many points are tried."""
MORE = 8
"""How many points in a row have to say nothing new."""


def search(
    elaborations: Elaborations, scene: Scene, pool: Pool = HERE, *, images: Images, degree: int = 0
) -> Iterator[Finding]:
    """The invariants, the lowest degrees first, and that these are all."""
    space, degree = elaborations(scene), degree or DEGREE
    numbers = len(scene.constants)
    maps = [
        MapAt(space, images, _values(scene.constants, shift))
        for shift in range(TRIES if numbers else 1)
    ]
    found: list[Formula] = []
    for size in range(1, degree + 1):
        missing = min(_dimension(one, size) - len(_span(one, found, size)) for one in maps)
        for formula in _candidates(space, images, size) if missing else ():
            if any(_is_new(one, found, formula, size) for one in maps):
                found.append(formula)
                says = "it is the same at each point and at its image"
                own: dict[str, Attribute] = {"images": images}
                yield Finding(InvariantOfMap, scene, says, to_latex(formula), own)
    for one in maps:
        if _dimension(one, degree) == len(_span(one, found, degree)):
            yield _all(scene, images, found, degree, one)
            return


def _all(scene: Scene, images: Images, found: Sequence[Formula], degree: int, at: MapAt) -> Finding:
    """That there are no others."""
    known = "a polynomial in these" if found else "a constant"
    words = f"each polynomial invariant up to degree {degree} is {known}"
    if scene.constants:
        words += ", for almost all values of the constants"
    attributes: dict[str, Attribute] = {
        "images": images,
        "invariants": tuple(map(to_latex, found)),
        "degree": degree,
        "values": tuple((name, str(value)) for name, value in at.values.items()),
    }
    return Finding(AllInvariantsOfMap, scene, words, attributes=attributes, steps=True)


def _values(names: Sequence[str], shift: int) -> dict[str, Fraction]:
    return {
        name: Fraction(VALUES[(k + shift) % len(VALUES)], 1 + k // len(VALUES))
        for k, name in enumerate(names)
    }


def _dimension(at: MapAt, degree: int) -> int:
    """How many polynomials up to a degree satisfy the conditions of points, at values."""
    return len(exponents_up_to(len(at.names), degree)) - len([*at.conditions(degree)])


def _span(at: MapAt, known: Sequence[Formula], degree: int) -> Echelon:
    """The products of known invariants up to a degree, at values of the constants."""
    found = Echelon()
    for terms in products_of(at.polynomials(known), len(at.names), degree).values():
        found.extend(_residues(terms))
    return found


def _residues(terms: Terms) -> dict[Exponents, int]:
    return {key: residue(value) for key, value in terms.items()}


def _is_new(at: MapAt, known: Sequence[Formula], formula: Formula, degree: int) -> bool:
    """Whether a formula is no polynomial in known invariants."""
    (terms,) = at.polynomials([formula])
    return _span(at, known, degree).extend(_residues(terms))


def _candidates(space: Elaboration, images: Images, degree: int) -> Iterator[Formula]:
    """Polynomials that points do not tell from invariants, those with short coefficients first."""
    names = [name for name, _ in images]
    ones, still = (1,) * len(names), space.constants
    own = [one for size in range(1, degree + 1) for one in monomials(ones, size)]
    for most in range(CONSTANTS + 1 if still else 1):
        powers = [e for size in range(most + 1) for e in monomials((1,) * len(still), size)]
        columns: list[dict[int, Fraction]] = [{} for _ in range(len(own) * len(powers))]
        every = _steps(space, images)
        for row, (point, image, values) in enumerate(islice(every, len(columns) + len(own))):
            place = 0
            for exponents in own:
                change = power_of(image, exponents) - power_of(point, exponents)
                for power in powers:
                    if value := change * power_of(values, power):
                        columns[place][row] = value
                    place += 1
        both = [(*a, *b) for a in own for b in powers]
        solutions = [
            {key: value for key, value in zip(both, solution, strict=True) if value}
            for solution in kernel(columns)
        ]
        for terms in sorted(solutions, key=lambda one: (max(map(sum, one)), len(one))):
            yield formula_in(_element(terms, (*names, *still), space.finder))


def _steps(space: Elaboration, images: Images) -> Iterator[tuple[Point, Point, Point]]:
    """Points with their images, and with values of the constants."""
    numbers = small_numbers()
    for _ in range(MOST):
        values = {name: next(numbers) for name in space.constants}
        point = tuple(next(numbers) for _ in images)
        with suppress(Meaningless):
            yield point, MapAt(space, images, values).image(point), (*values.values(),)


def _element(terms: Terms, names: Sequence[str], at: Evaluation) -> Element:
    """A polynomial with whole coefficients that have no common factor."""
    generators = at.ring.polynomials.generators
    order = [names.index(name) if name in names else -1 for name in generators]
    padded = (((*e, 0), value) for e, value in primitive(terms).items())
    return at.ring.from_terms({0: {tuple(e[k] for k in order): v for e, v in padded}})


class MapAt:
    """A map by rational functions, at values of its constants."""

    def __init__(self, space: Elaboration, images: Images, values: Mapping[str, Fraction]) -> None:
        if space.roots or space.transcendental.groups:
            raise Meaningless("invariants of a map with functions or roots are not looked for")
        self.space, self.values = space, values
        self.names = [name for name, _ in images]
        self.images = [space.plain(expand_definitions(space, Name(new))) for _, new in images]

    def image(self, point: Point) -> Point:
        """The image of a point; raises :class:`Meaningless` if it has none."""
        at = self._at({**self.values, **dict(zip(self.names, point, strict=True))})
        return tuple(_number(at, image) for image in self.images)

    def _at(self, values: Mapping[str, Fraction]) -> Evaluation:
        at = self.space.free([])
        return at.binding({name: at.ring.number(value) for name, value in values.items()})

    def steps(self) -> Iterator[tuple[Point, Point]]:
        """Points in general position with their images, as far as they have some."""
        numbers = small_numbers()
        for _ in range(MOST):
            point = tuple(next(numbers) for _ in self.names)
            with suppress(Meaningless):
                yield point, self.image(point)

    def conditions(self, degree: int) -> Iterator[list[Fraction]]:
        """The independent conditions on coefficients, as far as points give them."""
        exponents, found, idle = exponents_up_to(len(self.names), degree), Echelon(), 0
        for point, image in self.steps():
            row = [power_of(image, one) - power_of(point, one) for one in exponents]
            new = found.extend({k: residue(value) for k, value in enumerate(row) if value})
            idle = 0 if new else idle + 1
            if new:
                yield row
            if idle == MORE:
                return

    def polynomials(self, known: Sequence[Formula]) -> list[Terms]:
        """The coefficients of functions; raises :class:`Meaningless` if one is no polynomial."""
        numbers = {name: fraction_formula(value) for name, value in self.values.items()}
        plain = at_values(self.space, known, numbers)
        return [terms_of(self.space, one, [*map(Name, self.names)]) for one in plain]


def small_numbers() -> Iterator[Fraction]:
    """Small numbers without a rule, always the same ones."""
    state = 1
    while True:
        state = (state * 1103515245 + 12345) % 2**31
        yield Fraction((state >> 16) % 41 - 20, 1 + (state >> 24) % 3)


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
