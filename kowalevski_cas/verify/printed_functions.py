"""Functions as they are printed, for what is computed in the generators of their families."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import cached_property
from itertools import chain

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Application, Formula, Negative, NotationError
from kowalevski_cas.notation.functions import FAMILY_OF, canonical
from kowalevski_cas.paper.denominators import Shape
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.families import applications
from kowalevski_cas.problem.space import Meaningless


class PrintedFunctions:
    """The functions in formulas that are ``printed``, and in what a setting defines."""

    def __init__(self, setting: Elaboration, printed: Iterable[Formula]) -> None:
        self.setting = setting
        formulas = [*printed, *setting.printed_field]
        for place in setting.scene.definitions.values():
            with suppress(NotationError):  # what a change of the paper leaves without a meaning
                formulas.append(setting.texts.formula(place))
        self.printed = dict.fromkeys(
            application for formula in formulas for application in applications(formula)
        )

    @cached_property
    def _by_generators(self) -> dict[Formula, Formula]:
        found: dict[Formula, Formula] = {}
        for application in self.printed:
            with suppress(Meaningless):  # of a scene that a change leads from
                found[self.setting.plain(application)] = application
        return found

    @cached_property
    def _numerators(self) -> dict[Shape, Formula]:
        """The functions of the families at the same arguments, by where they vanish."""
        found: dict[Shape, Formula] = {}
        for function in dict.fromkeys(chain.from_iterable(map(_relatives, self.printed))):
            with suppress(Meaningless, NotationError, ZeroDivisionError):
                element = self.setting.finder.scalar(self.setting.plain(function))
                found.setdefault(Shape(element), function)
        return found

    def put_in(self, formula: Formula) -> Formula:
        """A formula in generators, in the functions that are printed."""
        if formula in self._by_generators:
            return self._by_generators[formula]
        return formula.map_children(self.put_in)

    def vanishing_with(self, element: Element) -> Formula | None:
        """The function that vanishes where an element does, as cosh u where tanh u has a pole."""
        return self._numerators.get(Shape(element))


def _relatives(application: Application) -> Iterator[Application]:
    """The functions of its family at the same arguments."""
    first, *others = application.arguments  # where it vanishes, it does at the opposite too
    arguments = (first.argument if isinstance(first, Negative) else first, *others)
    for names in FAMILY_OF[application.function].functions:
        yield Application(canonical(names.split()[0]), arguments)
