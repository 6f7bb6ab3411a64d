"""Linear changes of variables: their inverse, and the vector field in the new variables."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.notation import Name
from kowalevski_cas.paper.scene import Change
from kowalevski_cas.stage.evaluate import StageError, scalar
from kowalevski_cas.stage.field import printed_field, time_scale

if TYPE_CHECKING:
    from kowalevski_cas.stage.stage import Stage


class Carrier:
    """A change of variables at work on the stage of its new scene.

    The old and the new variables meet in the ring ``bridge``, which has the new
    variables as generators and the imaginary unit of the old scene adjoined.
    """

    def __init__(self, change: Change, stage: Stage) -> None:
        self.change = change
        self.stage = stage
        self.old = change.source.variables
        self.new = stage.scene.variables
        self.unit_square: Fraction | None = None
        if change.source.unit is not None:
            square = stage.square("i", change.source.unit)
            self.unit_square = sum(
                (v for t in square.terms().values() for v in t.values()), Fraction(0)
            )
        self.bridge = self._with_unit(self.new)

    def field(self) -> dict[str, Element]:
        """The field in the new variables, by the inverse change and the chain rule."""
        equations = self.change.source.field
        if isinstance(equations, Change):
            raise StageError(f"the scene “{self.change.source.name}” has no printed equations")
        image = self._image(self.inverse())
        old_field = printed_field(equations, image)
        per_time = time_scale(self.change.time, image).inverse()
        field = {}
        for name, row in zip(self.new, self.matrix, strict=True):
            total = self.bridge.zero
            for coefficient, old in zip(row, self.old, strict=True):
                total = total + coefficient * old_field[old]
            field[name] = self._transfer(total * per_time, name)
        return field

    def time_sign(self) -> int:
        """1 if the new time is real, -1 if it is imaginary."""
        image = self._image(self.inverse())
        scale = time_scale(self.change.time, image)
        conjugate = time_scale(self.change.time, image, conjugated=True)
        for sign in (1, -1):
            if (conjugate - scale * self.bridge.number(sign)).is_zero:
                return sign
        raise StageError("the new time is neither real nor imaginary")

    def old_variables(self) -> dict[str, Element]:
        """The old variables on the stage of the new scene, which needs the unit."""
        return {name: self._transfer(value, name) for name, value in self.inverse().items()}

    @cached_property
    def matrix(self) -> list[list[Element]]:
        """The matrix of the change: a row a new variable, a column an old one."""
        source = self._with_unit(self.old)
        image = self._image({name: source.generator(name) for name in self.old}, source)
        return [
            [
                self._number(partial, name)
                for partial in gradient(self._new_value(name, image), self.old)
            ]
            for name in self.new
        ]

    def _number(self, coefficient: Element, name: str) -> Element:
        """A coefficient of the change, in the ring of the new variables."""
        terms = coefficient.terms()
        if coefficient.denominator or any(any(e) for part in terms.values() for e in part):
            raise StageError(f"the change of variables is not linear for {name}", name)
        still = (0,) * len(self.bridge.polynomials.generators)
        return self.bridge.from_terms(
            {mask: {still: sum(part.values(), Fraction(0))} for mask, part in terms.items()}
        )

    def _with_unit(self, variables: tuple[str, ...]) -> Ring:
        """The ring of these variables and the constants, with i if the change needs it."""
        ring = Ring(self.stage.arithmetic((*variables, *self.stage.scene.constants)))
        if self.unit_square is not None:
            ring.adjoin("i", ring.number(self.unit_square))
        return ring

    def inverse(self) -> dict[str, Element]:
        """The old variables through the new ones.

        Raises :class:`StageError` if the change is not linear, or not invertible.
        """
        right = [self.bridge.generator(name) for name in self.new]
        inverse = dict(zip(self.old, solve(self.matrix, right), strict=True))
        image = self._image(inverse)
        for name, value in zip(self.new, right, strict=True):
            if not (self._new_value(name, image) - value).is_zero:
                raise StageError(f"the change of variables is not linear for {name}", name)
        return inverse

    def _image(self, values: dict[str, Element], ring: Ring | None = None) -> Stage:
        """The source scene in a ring, the bridge if none is given."""
        ring = ring or self.bridge
        stage, scene = self.stage, self.change.source
        kept = {n: ring.generator(n) for n in scene.constants if n in stage.scene.constants}
        unit = {name: ring.generator(name) for name in ring.roots}
        return type(stage)(scene, stage.arithmetic, stage.texts, ring, {**kept, **values, **unit})

    def _new_value(self, name: str, image: Stage) -> Element:
        for printed in self.change.formulas:
            relation = image.relation(printed)
            if relation.members[0] == Name(name):
                return scalar(relation.members[1], image)
        return scalar(Name(name), image)

    def _transfer(self, element: Element, name: str) -> Element:
        """An element of the bridge as an element of the stage's ring."""
        stage = self.stage
        unit = {0: stage.ring.one}
        if stage.scene.unit is not None:
            unit[1] = scalar(Name("i"), stage)
        if element.parts.keys() - unit.keys() or element.denominator:
            raise StageError(f"{name} is not free of the imaginary unit", name)
        generators = [scalar(Name(g), stage) for g in self.bridge.polynomials.generators]
        total = stage.ring.zero
        for mask, terms in element.terms().items():
            for exponents, value in terms.items():
                product = stage.ring.number(value) * unit[mask]
                for generator, exponent in zip(generators, exponents, strict=True):
                    product = product * generator**exponent if exponent else product
                total = total + product
        return total


def solve(matrix: list[list[Element]], right: list[Element]) -> list[Element]:
    """The solution of a square linear system, by elimination; ``StageError`` if it is singular."""
    rows = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    for column in range(len(rows)):
        pivot = next((row for row in rows[column:] if not row[column].is_zero), None)
        if pivot is None:
            raise StageError("the change of variables is not invertible")
        rows.remove(pivot)
        factor = pivot[column].inverse()
        pivot = [entry * factor for entry in pivot]
        rows = [
            row
            if row[column].is_zero
            else [a - row[column] * b for a, b in zip(row, pivot, strict=True)]
            for row in rows
        ]
        rows.insert(column, pivot)
    return [row[-1] for row in rows]
