"""States of rest: the equations of motion where some variables vanish, solved as far as linear."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from kowalevski_cas.arithmetic.derivation import along
from kowalevski_cas.arithmetic.numbers import Substitution, rational
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.stage import Stage, StageError


@dataclass
class Rest:
    """The states of a stage in which the ``fixed`` variables and the field vanish.

    Every component of the field that is left is linear in some variable with a
    number as coefficient, and is solved for it: an equation for an equation.
    Raises :class:`StageError` where that is impossible.
    """

    stage: Stage
    fixed: tuple[str, ...]

    @cached_property
    def solution(self) -> dict[str, Element]:
        """The variables through those that stay free."""
        ring, names = self.stage.ring, self.stage.scene.variables
        image = {name: ring.generator(name) for name in ring.polynomials.generators}
        image |= {name: ring.zero for name in self.fixed}
        rates = [Substitution(ring, image, ring)(rate) for rate in self.stage.field.values()]
        free = [name for name in names if name not in self.fixed]
        while rates := [rate for rate in rates if not rate.is_zero]:
            name, value = self._solved(rates[0], free)
            free.remove(name)
            step = Substitution(ring, {n: ring.generator(n) for n in image} | {name: value}, ring)
            image = {n: step(old) for n, old in image.items()}
            rates = [step(rate) for rate in rates]
        self.free = tuple(free)
        return image

    def _solved(self, rate: Element, free: list[str]) -> tuple[str, Element]:
        ring = self.stage.ring
        for name in reversed(free):
            slope = along(rate, {name: ring.one})
            if rational(slope):
                return name, ring.generator(name) - rate * slope.inverse()
        raise StageError("the equations of rest are not linear")

    def at(self, ring: Ring, values: dict[str, Element]) -> Substitution:
        """The homomorphism to another ring that gives values to the free variables."""
        own = self.stage.ring
        numbers = {name: values.get(name, ring.zero) for name in own.polynomials.generators}
        inner = Substitution(own, numbers, ring)
        return Substitution(own, {n: inner(e) for n, e in self.solution.items()}, ring)
