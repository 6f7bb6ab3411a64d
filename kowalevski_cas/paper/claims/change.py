"""Changes of variables: invertible, with the equations that they lead to, in the right unit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kowalevski_cas.notation import Conjugate, Formula, Name, NotationError
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.forms import chain
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.inverse import SingularChange
from kowalevski_cas.paper.scene import Change, Scene
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.goals import Goal, Rank, identity
from kowalevski_cas.problem.space import Meaningless


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


class InvertibleChange(Claim):
    """The change to ``scene`` has an inverse, and ``pairs`` are conjugates of each other.

    A linear change that has none is refuted by its rank.
    """

    old: Scene
    pairs: tuple[tuple[str, str], ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        old = on(self.old)
        try:
            inverse = on(self.scene).motion.inverse
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

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        for first, _ in self.pairs[:1]:
            claim = replace(self, pairs=((first, first),))
            yield Neighbour(f"{first} as its own conjugate", claim, texts)


ONE, OTHER = [True, False], [False, True]
"""Holding with the printed unit and not with the other one, and the converse."""


class Unit(Claim):
    """The printed square of the imaginary unit makes the change lead to the printed ``rows``.

    A row may be misprinted itself, or hold with either unit. So those vote that hold with one
    of the two only, and the unit with which more of them hold is the right one.
    """

    rows: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        other = on.under(self._other(on.texts))
        held = [(row, self._holds(row, on), self._holds(row, other)) for row in self.rows]
        votes = [[row for row, *both in held if both == wanted] for wanted in (ONE, OTHER)]
        if len(votes[0]) == len(votes[1]):
            raise Meaningless(
                f"as many rows ask for the unit at {self.own.place} as for the other one: "
                "name rows of which more hold with one unit and not with the other"
            )
        space, rows = on(self.scene), max(votes, key=len)
        yield identity(space, *(sides for row in rows for sides in chain(on, space, row)))

    def _other(self, texts: Texts) -> Texts:
        """The texts with the other sign on the right side of the equation."""
        edit = next((n.edit for n in self.neighbours(texts)), None)
        if edit is None:
            raise Meaningless(f"the square of a unit is expected at {self.own.place}")
        # neighbours are those of the print: in texts that are edited so, the other sign is the
        # printed one
        if texts.formula(self.own) != edit.formula:
            return texts.with_edit(self.own, edit)
        return replace(texts, edits={p: f for p, f in texts.edits.items() if p != self.own})

    def _holds(self, row: Printed, on: Elaborations) -> bool:
        try:
            space = on(self.scene)
            return all(d.is_zero for d in space.finder.differences(chain(on, space, row)))
        except (Meaningless, NotationError):
            return False

    def about(self) -> Iterator[Printed]:
        yield from (*super().about(), *self.rows)

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        """The other sign on the right side."""
        for neighbour in super().neighbours(texts, wanted):
            edit = neighbour.edit
            if edit and edit.path[:1] == (1,) and edit.kind == "sign":
                yield neighbour
