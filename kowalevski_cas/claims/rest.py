"""States of rest: the equations of motion where some variables vanish, solved as far as linear."""

from __future__ import annotations

from kowalevski_cas.arithmetic.derivation import along
from kowalevski_cas.arithmetic.numbers import Substitution, rational
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.stage import Stage, StageError


class Rest:
    """The states of a stage in which the ``fixed`` variables and the field vanish.

    Every component of the field that is left is linear in some variable with a
    number as coefficient, and is solved for it: an equation for an equation.
    ``solution`` gives the variables through those that stay ``free``. Raises
    :class:`StageError` where that is impossible.
    """

    def __init__(self, stage: Stage, fixed: tuple[str, ...]) -> None:
        self.stage = stage
        ring = stage.ring
        own = {name: ring.generator(name) for name in ring.polynomials.generators}
        image = own | {name: ring.zero for name in fixed}
        first = Substitution(ring, image, ring)
        rates = [first(rate) for rate in stage.field.values()]
        free = [name for name in stage.scene.variables if name not in fixed]
        while rates := [rate for rate in rates if not rate.is_zero]:
            name, value = self._solved(rates[0], free)
            free.remove(name)
            step = Substitution(ring, own | {name: value}, ring)
            image = {n: step(old) for n, old in image.items()}
            rates = [step(rate) for rate in rates]
        self.solution = image
        self.free = tuple(free)

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
