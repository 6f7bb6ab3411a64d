"""What is written out where it is used, and leaves no name in a space: on what places it rests."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    PoissonBracket,
    Root,
    once,
)
from kowalevski_cas.notation.vocabulary import MATRIX
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.plain import Plain
from kowalevski_cas.paper.texts import Printed


class InlinedDefinitions:
    """The places of the functions, brackets, matrices, values of roots, and times in a place.

    Those that stand in their definitions are among them.
    """

    def __init__(self, plain: Plain) -> None:
        self.plain = plain
        self.setting = plain.setting
        self._functions: dict[str, list[str]] = {}
        scene, words = self.setting.scene, self.setting.texts.vocabulary
        for name in scene.definitions:
            function, arguments = head(name)
            if arguments:
                self._functions.setdefault(function, []).append(name)
        self._matrices = {name for name in scene.definitions if words.rank(name) == MATRIX}
        written_out = self._functions or self._matrices or [*scene.branches()] or scene.clock
        self._nothing = not written_out
        self._known: dict[Printed, tuple[Printed, ...]] = {}

    def __call__(self, place: Printed) -> tuple[Printed, ...]:
        """What a printed formula writes out."""
        if self._nothing:
            return ()
        if place not in self._known:
            self._known[place] = tuple(self._of(self.setting.texts.as_printed(place)))
        return self._known[place]

    def _of(self, formula: Formula) -> Iterator[Printed]:
        found: set[Printed] = set()
        waiting = [formula]
        while waiting:
            for defined in _heads(waiting.pop()):
                for name, place in self._definitions_on_top(defined):
                    if place not in found:
                        found.add(place)
                        waiting.append(self.setting.definition(name))
                        yield place
                clock = self._clock(defined)
                if clock is not None and clock not in found:
                    found.add(clock)
                    waiting.append(self.setting.texts.as_printed(clock))
                    yield clock

    def _clock(self, formula: Formula) -> Printed | None:
        """What gives the time by which a derivative is one, if it is another than the scene's."""
        own = not isinstance(formula, Derivative) or self.plain.is_by_own_time(formula.mark)
        return None if own else self.setting.scene.clock

    def _definitions_on_top(self, formula: Formula) -> Sequence[tuple[str, Printed]]:
        """The definitions of what stands on top of a formula."""
        match formula:
            case Name(name):
                named = [name] if name in self._matrices else []
            case Application(function):
                named = self._functions.get(function, [])
            case PoissonBracket():
                named = self._functions.get(BRACKET, [])
            case Root() if (value := self.plain.printed_root(formula)) is not None:
                return (value,)
            case _:
                return ()
        return [(name, self.setting.scene.definitions[name]) for name in named]


@once
def _heads(formula: Formula) -> list[Formula]:
    """What in a formula may be the head of a definition."""
    heads = (Name, Application, PoissonBracket, Root, Derivative)
    return [node for node in formula.nodes() if isinstance(node, heads)]
