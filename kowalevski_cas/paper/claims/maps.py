r"""Maps :math:`x_{n+1}=\ldots`: invariants, measures and brackets that a map preserves.

The scene defines the image of each variable by a name of its own, as :math:`x_{n+1}` of
:math:`x_n`; ``images`` says which belong together. What a function is at the image is read with
the one name in the place of the other.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Partial,
    PoissonBracket,
    Relation,
    substitute,
    times,
)
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.equilibria import RestPoints
from kowalevski_cas.paper.claims.first_integral import FirstIntegral
from kowalevski_cas.paper.claims.forms import equations, function, members, vanishes
from kowalevski_cas.paper.claims.invariant_relations import InvariantRelations
from kowalevski_cas.paper.claims.poisson import Jacobi, commutation, pfaffian
from kowalevski_cas.paper.components import parts, sides
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import determinant
from kowalevski_cas.paper.names import Images
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Fails, Follows, Goal, Rank, identity
from kowalevski_cas.problem.space import Equation, Meaningless


class OfMap(Claim):
    """A claim about the images of a scene."""

    images: Images

    def settings(self, on: Elaborations) -> Elaborations:
        on = super().settings(on)
        return on.meeting((*on.met, *(Name(new) for _, new in self.images)))


class InvariantOfMap(OfMap):
    """The printed function is the same at a point and at its image, and is not constant."""

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        printed = _printed_function(on, space, self.own)
        yield identity(space, invariance(space, printed, self.images))
        yield Rank(space, (space.plain(printed),), (), 1)


class InvariantSetOfMap(OfMap):
    """The image of each point at which the printed equations hold is one; there is a real one."""

    relations: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        if not self.relations:
            raise Meaningless("no equations are given")
        space = on(self.scene)
        given = equations(on, space, self.relations)
        printed = (members(on.texts.relation(place)) for place in self.relations)
        images = tuple(
            (self._image(left, space), self._image(right, space))
            for chain in printed
            for left, right in pairwise(chain)
        )
        # of an empty set everything is invariant
        yield Fails(space, (), given)
        yield Follows(space, (tuple(_components(images, space)),), given)

    def _image(self, formula: Formula, space: Elaboration) -> Formula:
        return _at_image(expand_definitions(space, formula), self.images)

    def establishes(self) -> Iterator[Printed]:
        yield from self.relations


class FixedPointsOfMap(OfMap):
    """The map leaves each point at which the printed equations hold; there is a real one."""

    relations: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        if not self.relations:
            raise Meaningless("no equations are given")
        space = on(self.scene)
        given = equations(on, space, self.relations)
        yield Fails(space, (), given)
        yield Follows(space, (tuple((Name(new), Name(x)) for x, new in self.images),), given)

    def establishes(self) -> Iterator[Printed]:
        yield from (self.printed,) if self.printed is not None else self.relations


OF_MAPS: dict[type[Claim], type[Claim]] = {
    FirstIntegral: InvariantOfMap,
    InvariantRelations: InvariantSetOfMap,
    RestPoints: FixedPointsOfMap,
}
"""What is claimed of a map for what is claimed of a motion."""


class MeasureOfMap(OfMap):
    """The map preserves the measure with the printed density, which vanishes nowhere.

    The determinant of the derivatives of the map, times the density at the image, is the density
    or its opposite, the same on the whole space.
    """

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        density = expand_definitions(space, _printed_function(on, space, self.own))
        plain = space.plain(density)
        rows = (
            [space.plain(Partial(Name(new), x)) for x, _ in self.images] for _, new in self.images
        )
        jacobian = determinant(tuple(map(tuple, rows)))
        there = times(jacobian, space.plain(_at_image(density, self.images)))
        yield Follows(space, (((there, plain),), ((there, Negative(plain)),)))
        # the density 0 is preserved by every map
        yield Follows(space, (), (vanishes(plain),))


class PoissonMap(OfMap):
    """The bracket of the images of two variables is their bracket at the image."""

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        if len(self.images) < 2:
            raise Meaningless("one variable alone has no bracket")
        yield identity(on(self.scene), *_brackets(on(self.scene), self.images))

    def establishes(self) -> Iterator[Printed]:
        for _, new in self.images:
            if new in self.scene.definitions:
                yield self.scene.definitions[new]


class IntegrableMap(OfMap):
    """A map with as many invariants in involution as pairs of variables, that preserves a bracket.

    The bracket obeys Jacobi's identity, and is regular at a real point, where the differentials of
    the invariants are independent.
    """

    invariants: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        functions = [function(on, space, place) for place in self.invariants]
        variables = [Name(name) for name in space.variables]
        if len(variables) != 2 * len(functions):
            raise Meaningless(
                f"{len(variables)} variables and {len(functions)} invariants: there are to be half "
                "as many"
            )
        yield identity(space, *_brackets(space, self.images))
        if len(variables) > 2:
            yield from Jacobi(self.id, self.scene, "").goals(on)
            yield identity(space, *commutation(space, functions))
        yield identity(space, *(invariance(space, function, self.images) for function in functions))
        plain = tuple(map(space.plain, functions))
        yield Rank(space, plain, (), len(plain))
        yield Fails(space, ((vanishes(pfaffian(space, variables)),),))

    def establishes(self) -> Iterator[Printed]:
        yield from self.invariants


def _printed_function(on: Elaborations, space: Elaboration, printed: Printed) -> Formula:
    """A printed function, or the one that is said to be constant."""
    formula = on.texts.formula(printed)
    if isinstance(formula, Relation) and len(members(formula)) == 1:
        return members(formula)[0]  # it is said to be constant
    return function(on, space, printed)


def _at_image(formula: Formula, images: Images) -> Formula:
    """A formula at the image of a point."""
    return substitute(formula, {x: Name(new) for x, new in images})


def invariance(space: Elaboration, formula: Formula, images: Images) -> Equation:
    """That a function, in which no defined name stands any more, has its value at the image."""
    whole = expand_definitions(space, formula)
    return space.plain(_at_image(whole, images)), space.plain(whole)


def expand_definitions(space: Elaboration, formula: Formula) -> Formula:
    """A formula in variables and constants, for the names in it that are defined by others."""
    if isinstance(formula, Name) and formula.name in space.scene.definitions:
        return expand_definitions(space, space.definition(formula.name))
    return formula.map_children(lambda child: expand_definitions(space, child))


def _components(pairs: Sequence[Equation], space: Elaboration) -> Iterator[Equation]:
    """The components of equations between vectors, and equations between scalars."""
    for pair in pairs:
        left, right = sides(pair, space)
        yield from zip(parts(left, space), parts(right, space), strict=True)


def _brackets(space: Elaboration, images: Images) -> Iterator[Equation]:
    """That the bracket of each two images is that of the variables at the image."""
    for (x, new_x), (y, new_y) in combinations(images, 2):
        here = space.plain(PoissonBracket(Name(x), Name(y)))
        there = space.plain(PoissonBracket(Name(new_x), Name(new_y)))
        yield there, space.plain(_at_image(here, images))
