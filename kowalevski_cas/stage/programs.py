"""A stage on which formulas become straight-line programs, to be evaluated at points.

What the scene says (its generators, roots, conjugation and field) is taken from the
exact stage, where it is derived; everything else is evaluated here and never expanded.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING

from kowalevski_cas.arithmetic.programs import Program, Programs
from kowalevski_cas.notation import Formula
from kowalevski_cas.stage.evaluate import StageError, Triple, Value, scalar
from kowalevski_cas.stage.poisson import Structure
from kowalevski_cas.stage.stage import Stage

if TYPE_CHECKING:
    from kowalevski_cas.arithmetic.derivation import Field
    from kowalevski_cas.arithmetic.tower import Element


class ProgramStage(Stage):
    """The stage ``exact`` with programs for elements.

    Values of subformulas are remembered, by identity, so that a formula that
    shares most of its tree with earlier ones costs little.
    """

    def __init__(self, exact: Stage) -> None:
        self.exact = exact
        self.programs = Programs(exact.ring.polynomials.generators)
        self.memory = {}
        self.scene = exact.scene
        self.texts = exact.texts
        self.arithmetic = exact.arithmetic
        self.powers = exact.powers
        self.generators = exact.generators
        self.ring = self.programs  # type: ignore[assignment]
        self.half = self.programs.one / self.programs.number(2)
        self._values: dict[tuple[str, bool], Value] = {}
        self._open: set[tuple[str, bool]] = set()
        self._field: list[Field] = []
        for name, radicand in zip(exact.ring.roots, exact.ring.radicands, strict=True):
            self.programs.adjoin(name, self.carry(radicand))
        self._roots = [(self.carry(r), self.carry(s)) for r, s in exact.declared_roots()]

    def value(self, name: str, conjugated: bool = False) -> Value:
        key = (name, conjugated)
        if key not in self._values:
            scene = self.scene
            own = {*scene.variables, *scene.constants, *scene.undefined, *scene.roots, "i"}
            if name not in own and (name in scene.vectors or name in scene.definitions):
                return super().value(name, conjugated)
            exact = self.exact.value(name, conjugated)
            self._values[key] = (
                Triple(self.carry(e) for e in exact)
                if isinstance(exact, Triple)
                else self.carry(exact)
            )
        return self._values[key]

    def _old_value(self, name: str) -> Element | None:
        return None

    def carry(self, element: Element) -> Program:
        """An exact element as a program."""
        if isinstance(element, Program):
            return element
        image = self._image(element, self.programs.generator)
        assert isinstance(image, Program)
        return image

    @property
    def field(self) -> Field:
        if not self._field:
            exact = self.exact.field
            self._field.append({name: self.carry(rate) for name, rate in exact.items()})
        return self._field[0]

    @cached_property
    def structure(self) -> Structure:
        return {pair: self.carry(value) for pair, value in self.exact.structure.items()}

    def root(self, radicand: Formula, conjugated: bool = False) -> Element:
        value = scalar(radicand, self, conjugated)
        for square, root in self._roots:
            if (square - value).is_zero:
                return root
        raise StageError(f"the scene “{self.scene.name}” declares no such root")

    def symbolic_power(self, base: Formula, exponent: str) -> Element:
        return self.carry(self.exact.symbolic_power(base, exponent))

    def time_factor(self, mark: str, conjugated: bool) -> Element:
        return self.carry(self.exact.time_factor(mark, conjugated))


def programs(elements: Iterable[Element]) -> list[Program]:
    """Elements of a stage of programs, which they all are."""
    return [element for element in elements if isinstance(element, Program)]
