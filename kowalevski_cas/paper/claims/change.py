"""Changes of variables: invertible, with the equations that they lead to, in the right unit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from kowalevski_cas.notation import Conjugate, Name, NotationError
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.forms import chain
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.inverse import SingularChange
from kowalevski_cas.paper.scene import Change, Scene
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.goals import Goal, Rank, identity
from kowalevski_cas.problem.space import Meaningless


@dataclass(frozen=True, eq=False)
class ChangedEquation(Claim):
    """A printed equation of motion holds in the new variables, and in the old ones.

    In the new scene the field is derived through the inverse change; in
    ``old``, where the new variables are defined by the change, the same
    equation is differentiated directly.
    """

    old: Scene

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        for space in map(on, (self.scene, self.old)):
            yield identity(space, *chain(on, space, self.own))


@dataclass(frozen=True, eq=False)
class InvertibleChange(Claim):
    """The change to ``scene`` has an inverse, and ``pairs`` are conjugates of each other.

    A linear change that has none is refuted by its rank.
    """

    old: Scene
    pairs: tuple[tuple[str, str], ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        old = on(self.old)
        try:
            inverse = on(self.scene).inverse
        except SingularChange:
            new = self.scene.variables
            yield Rank(old, tuple(map(old.formula, new)), (), len(new))
            return
        yield identity(old, *((Name(name), inverse[name]) for name in old.variables))
        bars = ((old.formula(b), Conjugate(old.formula(a))) for a, b in self.pairs)
        yield identity(old, *bars)

    def establishes(self) -> Iterator[Printed]:
        change = self.scene.field
        assert isinstance(change, Change)
        yield from change.formulas

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        for first, _ in self.pairs[:1]:
            claim = replace(self, pairs=((first, first),))
            yield Neighbour(f"{first} as its own conjugate", claim, texts)


@dataclass(frozen=True, eq=False)
class Unit(Claim):
    """The printed square of the imaginary unit makes the change lead to the printed ``rows``.

    A row may be misprinted itself: those have to hold that do so with one of the two units,
    with the one that makes more of them hold.
    """

    rows: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        others = (on.under(neighbour.texts) for neighbour in self.neighbours(on.texts))
        rows = max((self._rows_that_hold(one) for one in (on, *others)), key=len) or self.rows
        space = on(self.scene)
        yield identity(space, *(sides for row in rows for sides in chain(on, space, row)))

    def _rows_that_hold(self, on: Elaborations) -> tuple[Printed, ...]:
        return tuple(row for row in self.rows if self._holds(row, on))

    def _holds(self, row: Printed, on: Elaborations) -> bool:
        try:
            space = on(self.scene)
            return all(d.is_zero for d in space.finder.differences(chain(on, space, row)))
        except (Meaningless, NotationError):
            return False

    def about(self) -> Iterator[Printed]:
        yield from (*super().about(), *self.rows)

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        """The other sign on the right side."""
        for neighbour in super().neighbours(texts):
            edit = neighbour.edit
            if edit and edit.path[:1] == (1,) and edit.kind == "sign":
                yield neighbour
