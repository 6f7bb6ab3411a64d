"""What is written out where it is used, and leaves no name in a space: on what places it rests."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kowalevski_cas.notation import Application, Formula, Name, PoissonBracket, Root
from kowalevski_cas.notation.vocabulary import MATRIX
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.plain import Plain
from kowalevski_cas.paper.texts import Printed


class WrittenOut:
    """The places of the functions, brackets, matrices and values of roots that places print.

    Those that stand in their definitions are among them.
    """

    def __init__(self, plain: Plain) -> None:
        self.plain = plain
        self.setting = setting = plain.setting
        self._known: dict[Printed, tuple[Printed, ...]] = {}
        self._functions: dict[str, list[str]] = {}
        """The heads of the definitions of functions and of brackets, by the function."""
        for name in setting.scene.definitions:
            function, arguments = head(name)
            if arguments:
                self._functions.setdefault(function, []).append(name)
        rank = setting.texts.vocabulary.rank
        self._matrices = {name for name in setting.scene.definitions if rank(name) == MATRIX}
        self._roots = any(setting.scene.roots.values())

    def __call__(self, places: Iterable[Printed]) -> Iterator[Printed]:
        """What printed formulas write out."""
        if self._functions or self._matrices or self._roots:
            for place in places:
                if place not in self._known:
                    self._known[place] = tuple(self._of(self.setting.texts.formula(place)))
                yield from self._known[place]

    def _of(self, formula: Formula) -> Iterator[Printed]:
        found: set[Printed] = set()
        waiting = [formula]
        while waiting:
            for one in waiting.pop().nodes():
                for name, place in self._meant(one):
                    if place not in found:
                        found.add(place)
                        waiting.append(self.setting.definition(name))
                        yield place

    def _meant(self, formula: Formula) -> Sequence[tuple[str, Printed]]:
        """The definitions of what stands on top of a formula."""
        names: Sequence[str] = ()
        match formula:
            case Application(function):
                names = self._functions.get(function, ())
            case PoissonBracket():
                names = self._functions.get(BRACKET, ())
            case Name(name) if name in self._matrices:
                names = (name,)
            case Root() if (value := self.plain.printed_root(formula)) is not None:
                return (value,)
        return [(name, self.setting.scene.definitions[name]) for name in names]
