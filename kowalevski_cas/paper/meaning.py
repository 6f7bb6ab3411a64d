"""What the parts of an elaboration need of it."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property

from kowalevski_cas.notation import Formula, Name, Number, Partial, Quotient, times, total
from kowalevski_cas.paper.differentiate import derivative
from kowalevski_cas.paper.directions import directions, without_direction
from kowalevski_cas.paper.radicals import Radicals
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.paper.transcendental import Transcendental
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import EquationOfMotion, Meaningless, Setting, Step


class Meaning(Setting):
    """A setting that a scene means; what a name rests on is noted in ``places``."""

    scene: Scene
    texts: Texts
    places: dict[str, tuple[Printed, ...]]
    turning: dict[str, Formula] | None
    """The rates of variables in whose place others stand, when the field has been looked at."""

    met: tuple[Formula, ...]
    """The formulas of a claim with functions that the scene itself does not print."""

    @abstractmethod
    def components(self, row: EquationOfMotion) -> Iterator[tuple[str, Formula, Formula]]:
        """An equation of motion by components: name, factor of its rate, right side."""

    @property
    @abstractmethod
    def finder(self) -> Evaluation:
        """The setting in FLINT."""

    @property
    @abstractmethod
    def plain(self) -> Callable[[Formula], Formula]:
        """What writes a formula out in the operations of a space."""

    @property
    @abstractmethod
    def printed_field(self) -> list[Formula]:
        """The equations of motion as they are printed."""

    @property
    @abstractmethod
    def velocities(self) -> dict[str, str]:
        """The variables of which higher derivatives are printed, and those derivatives' names."""

    @property
    @abstractmethod
    def transcendental(self) -> Transcendental:
        """The variables that stand under sines, cosines and exponentials."""

    @property
    @abstractmethod
    def radicals(self) -> Radicals:
        """The variables and constants of which fractional powers stand here."""

    def partial(self, formula: Formula, name: str) -> Formula:
        """The partial derivative of what is written out in the operations of a space."""
        above = {j: slopes[name] for j, slopes in self.slopes_of_jets.items() if name in slopes}
        parts = [times(self._partial(formula, jet), slope) for jet, slope in above.items()]
        if not parts:
            return self._partial(formula, name)
        # The time may stand nowhere but in these functions.
        own = [self._partial(formula, name)] if name in self.scene.names() else []
        return total((*own, *parts))

    @cached_property
    def slopes_of_jets(self) -> dict[str, dict[str, Formula]]:
        """The derivatives of the values of functions by what moves, and by the time.

        An argument may be a name for something that moves, as r for a length.
        """
        found: dict[str, dict[str, list[Formula]]] = {}
        for jet, next, by in self.scene.jets:
            for name, slope in self._slopes(by):
                found.setdefault(jet, {}).setdefault(name, []).append(times(Name(next), slope))
        return {
            jet: {name: total(terms) for name, terms in slopes.items()}
            for jet, slopes in found.items()
        }

    def _slopes(self, argument: str) -> Iterator[tuple[str, Formula]]:
        """The derivatives of an argument of a function by all that it depends on."""
        if argument == self.scene.time or self.step(argument) is None:
            yield argument, Number(1)
            return
        reach = Reach(self)
        reach.formula(Name(argument))
        for name in sorted(reach.names.intersection(self.scene.variables)):
            if self.step(name) is None:
                yield name, self._partial(Name(argument), name)

    def _partial(self, formula: Formula, name: str) -> Formula:
        """The derivative by a name, of which no function without a formula is one."""
        if name in self.radicals:
            return Quotient(Partial(formula, self.radicals.root(name)), self.radicals.slope(name))
        if isinstance(formula, Name) and formula.name in self.transcendental:
            return Number(int(formula.name == name))
        known = directions(self.transcendental, name)
        unknown = without_direction(self.transcendental, name)
        if not known and not unknown:
            return Partial(formula, name)

        def step(moving: str) -> Step | None:
            if moving in unknown:
                raise Meaningless(f"print the derivative of {moving} by {name}", name)
            return self.step(moving)

        reach = Reach(self)
        reach.formula(formula)
        moving = reach.names.intersection(known) - unknown
        rates = {step: self.plain(known[step]) for step in sorted(moving)}
        return derivative(formula, {name: Number(1), **rates}, step)

    @abstractmethod
    def definition(self, name: str) -> Formula:
        """The expression for which a name stands."""

    @abstractmethod
    def free(self, names: Sequence[str]) -> Evaluation:
        """The setting in FLINT with more variables, bound by nothing; a root may be one."""
