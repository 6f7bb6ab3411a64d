"""Partial derivatives, also of functions of which nothing is known but their derivatives."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Quotient,
    times,
    total,
)
from kowalevski_cas.paper.differentiate import derivative
from kowalevski_cas.paper.directions import directions, without_direction
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import Adjoined, Let, Meaningless, Raised, Step


class Partials:
    """The partial derivatives of what is written out in the operations of a space."""

    def __init__(self, setting: Meaning) -> None:
        self.setting = setting

    def __call__(self, formula: Formula, name: str) -> Formula:
        """The derivative of a formula by a name."""
        above = {j: slopes[name] for j, slopes in self.slopes.items() if name in slopes}
        parts = [times(self._partial(formula, jet), slope) for jet, slope in above.items()]
        if not parts:
            return self._partial(formula, name)
        # The time may stand nowhere but in these functions.
        own = [self._partial(formula, name)] if name in self.setting.scene.names() else []
        return total((*own, *parts))

    @cached_property
    def slopes(self) -> dict[str, dict[str, Formula]]:
        """The derivatives of the values of functions by what moves, and by the time.

        An argument may be a name for something that moves, as r for a length.
        """
        found: dict[str, dict[str, list[Formula]]] = {}
        for jet, next, by in self.setting.scene.jets:
            for name, slope in self._slopes(by):
                found.setdefault(jet, {}).setdefault(name, []).append(times(Name(next), slope))
        return {
            jet: {name: total(terms) for name, terms in slopes.items()}
            for jet, slopes in found.items()
        }

    def _slopes(self, argument: str) -> Iterator[tuple[str, Formula]]:
        """The derivatives of an argument of a function by all that it depends on."""
        if argument == self.setting.scene.time or self.setting.step(argument) is None:
            yield argument, Number(1)
            return
        reach = Reach(self.setting)
        reach.formula(Name(argument))
        for name in sorted(reach.names.intersection(self.setting.scene.variables)):
            if self.setting.step(name) is None:
                yield name, self._partial(Name(argument), name)

    def _partial(self, formula: Formula, name: str) -> Formula:
        """The derivative by a name, of which no function without a formula is one."""
        if name in self.setting.scene.definitions and name in self.coordinates:
            return self._by_coordinate(formula, name)
        if name in self.setting.radicals:
            return Quotient(
                Partial(formula, self.setting.radicals.root(name)),
                self.setting.radicals.slope(name),
            )
        if isinstance(formula, Name) and formula.name in self.setting.transcendental:
            return Number(int(formula.name == name))
        known = directions(self.setting.transcendental, name)
        unknown = without_direction(self.setting.transcendental, name)
        if not known and not unknown:
            return Partial(formula, name)

        def step(moving: str) -> Step | None:
            if moving in unknown:
                raise Meaningless(f"print the derivative of {moving} by {name}", name)
            return self.setting.step(moving)

        reach = Reach(self.setting)
        reach.formula(formula)
        moving = reach.names.intersection(known) - unknown
        rates = {step: self.setting.plain(known[step]) for step in sorted(moving)}
        return derivative(formula, {name: Number(1), **rates}, step)

    @cached_property
    def coordinates(self) -> frozenset[str]:
        """The names of which the printed equations of motion give the rates, with components."""
        rows, vectors = self.setting.printed_field, self.setting.scene.vectors
        nodes = (node for row in rows for node in row.nodes() if isinstance(node, Derivative))
        names = [inner.name for node in nodes if isinstance(inner := node.argument, Name)]
        return frozenset(part for name in names for part in (name, *vectors.get(name, ())))

    def _by_coordinate(self, formula: Formula, name: str) -> Formula:
        """The derivative by a coordinate of the equations of motion, which new variables give.

        The formula has to be one of these coordinates and of constants: what the others are is
        not looked at. Raises :class:`Meaningless` if anything else that moves stands in it.
        """
        met, waiting = set[str](), {*formula.names()}
        while waiting:
            met.add(one := waiting.pop())
            if one in self.coordinates:
                continue
            match self.setting.step(one):
                case Let(_, body) | Adjoined(_, body):
                    waiting |= body.names() - met
                case Raised(_, base, exponent):
                    waiting |= {*base.names(), exponent} - met
                case None if one not in self.setting.scene.constants:
                    raise Meaningless(f"the derivative by {name} of what has {one} in it", name)
        return derivative(formula, {name: Number(1)}, self.setting.step)
