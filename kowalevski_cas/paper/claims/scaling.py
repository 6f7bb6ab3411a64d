"""Scalings: units in which the equations have no parameters."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Name, Quotient, times
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import expression, rate
from kowalevski_cas.paper.components import row_components
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.goals import Goal, identity
from kowalevski_cas.problem.space import Let

Measure = tuple[tuple[str, ...], int, str]
"""Variables, the power of the unit of time in their unit, and the rest of that unit."""


class Scaling(Claim):
    """In units built on the printed unit of time the equations become those of ``simple``.

    Each variable is divided by its unit, and each time by its; the equations of motion of the
    simple scene have to hold for these quotients.
    """

    simple: Scene
    measures: tuple[Measure, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space, simple = on(self.scene), on(self.simple)
        time = expression(on, space, self.own)
        measured: dict[str, Formula] = {
            name: self._over_unit(Name(name), time, power, space.formula(rest))
            for names, power, rest in self.measures
            for name in names
        }
        equations = []
        for row in simple.field:
            for name, factor, force in row_components(row, simple):
                force = _measure(force, measured, simple)
                factor = _measure(factor, measured, simple)
                per_time = Quotient(force, time)
                equations.append((times(factor, rate(measured[name])), per_time))
        yield identity(space, *equations)

    @staticmethod
    def _over_unit(variable: Formula, time: Formula, power: int, rest: Formula) -> Formula:
        """A variable divided by its unit."""
        # a list is empty a negative number of times: only one of the two stands there
        return Quotient(times(variable, *[time] * -power), times(rest, *[time] * power))


def _measure(formula: Formula, values: dict[str, Formula], simple: Elaboration) -> Formula:
    """A formula of the simple scene, its variables measured, its definitions written out."""
    if isinstance(formula, Name):
        if formula.name in values:
            return values[formula.name]
        step = simple.step(formula.name)
        return _measure(step.formula, values, simple) if isinstance(step, Let) else formula
    return formula.map_children(lambda child: _measure(child, values, simple))
