"""Goals: what is stated over a space, what shows it, and what denies it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from itertools import product
from math import prod
from typing import ClassVar

from .evidence import PROOF, independent, is_combination, locate, minors, on_each_piece, settle
from .formulas import Map
from .reading import Json, items, names_in, need, pairs, part_of, record, say, say_all
from .spaces import Space


class Goal(ABC):
    """A goal over a space, in which the conditions of its evidence are known.

    ``holds`` and ``denied`` return if the evidence shows the goal, or denies it; else they reject.
    ``words`` says it in plain letters; ``KEYS`` are those of its data.
    """

    KEYS: ClassVar[str]

    @abstractmethod
    def __init__(self, space: Space, data: Json) -> None: ...

    @abstractmethod
    def holds(self, evidence: Json) -> None: ...

    @abstractmethod
    def denied(self, evidence: Json) -> None: ...

    @staticmethod
    @abstractmethod
    def words(data: Json) -> str: ...


def wherever(data: Json) -> str:
    """The given equations of a goal."""
    return f" wherever {say_all(data['given'])}" if data["given"] else ""


class Follows(Goal):
    """Where the given equations hold, one of the conclusions does."""

    KEYS = "given conclusions"

    def __init__(self, space: Space, data: Json) -> None:
        self.space = space
        with space.statement():
            self.given = space.differences(data["given"])
            self.conclusions = [space.differences(item) for item in items(data["conclusions"])]
        stated = self.conclusions or self.given
        need(stated and all(self.conclusions), "nothing is stated")

    def holds(self, evidence: Json) -> None:
        self.shown(evidence, self.space if self.conclusions else self.space.exact())

    def shown(self, evidence: Json, space: Space) -> None:
        """The conclusions follow, by a proof over a space."""
        # for an empty set, a condition that holds nowhere on it would be the whole proof
        record(evidence, "point", f"away {PROOF}" if self.conclusions else PROOF)
        locate(self.space, evidence["point"], self.given if self.conclusions else [])
        unit = self.space.ring.number(1)
        goals = [prod(choice, start=unit) for choice in product(*self.conclusions)]
        settle(space, goals, self.given, part_of(evidence, PROOF))

    def denied(self, evidence: Json) -> None:
        record(evidence, "point", "away")
        self.fails(locate(self.space, evidence["point"], self.given))

    def fails(self, at: Map) -> None:
        """Each conclusion fails at a point."""
        for conclusion in self.conclusions:
            need(any(at(e).differs() for e in conclusion), "the two sides may be equal")

    @staticmethod
    def words(data: Json) -> str:
        if not data["conclusions"]:
            return f"there is no real point where {say_all(data['given'])}"
        return " or ".join(map(say_all, data["conclusions"])) + wherever(data)


class Fails(Follows):
    """At a point where the given equations hold each conclusion fails; with none, on each piece."""

    def holds(self, evidence: Json) -> None:
        record(evidence, "point", "away")
        at = locate(self.space, evidence["point"], self.given)
        self.fails(at)
        if not self.given:
            self.fails(on_each_piece(at, []))

    def denied(self, evidence: Json) -> None:
        """It follows, and without a condition: where one fails, the goal might hold."""
        need("away" not in evidence, "it may fail where a condition does")
        super().shown(evidence, self.space.exact())


class Rank(Goal):
    """At a point the differentials of functions and given equations are so many, independent."""

    KEYS = "functions given rank"

    def __init__(self, space: Space, data: Json) -> None:
        self.space, self.stated = space, data["rank"]
        unit = space.ring.number(1)
        with space.statement():
            self.given = space.differences(data["given"])
            chosen = [e for tree in items(data["functions"]) for e in space.value(tree)]
            chosen += self.given
            need(chosen and space.variables, "nothing is stated")
            with space.granting():  # where they are not defined the point is not
                self.matrix = [[space.along(e, {v: unit}) for v in space.variables] for e in chosen]

    def holds(self, evidence: Json) -> None:
        self._independent(evidence)
        need(len(self.matrix) == self.stated, f"the rank is {len(self.matrix)}")

    def denied(self, evidence: Json) -> None:
        """Their number is another one, or they depend on each other everywhere."""
        if "minors" not in evidence:
            self._independent(evidence)
            need(len(self.matrix) != self.stated, "the rank is as stated")
            return
        record(evidence, "minors")
        square = len(self.matrix) <= len(self.space.variables)
        found, space = minors(self.space.ring, self.matrix) if square else [], self.space.exact()
        for minor, row in zip(found, items(evidence["minors"], len(found)), strict=True):
            need(is_combination(space, minor, row, self.given), "a minor may differ from zero")

    def _independent(self, evidence: Json) -> None:
        record(evidence, "point", "away")
        at = locate(self.space, evidence["point"], self.given)
        independent(on_each_piece(at, self.given), self.matrix)

    @staticmethod
    def words(data: Json) -> str:
        trees = [*data["functions"], *(["+", a, ["-", b]] for a, b in data["given"])]
        shown, size = ", ".join(map(say, trees)), data["rank"]
        whole = f"of the differentials of {shown}, {size} are independent at a real point"
        if size == len(trees):
            whole = f"the differentials of {shown} are independent at a real point"
        if size == len(trees) == 1:
            whole = f"the differential of {shown} does not vanish at a real point"
        return whole + (f" with {say_all(data['given'])}" if data["given"] else "")


def names_of(data: Json) -> set[str]:
    """All names in the formulas of a goal."""
    lists = [*items(data.get("conclusions", [])), data.get("given", [])]
    sides = [side for equations in lists for both in pairs(equations) for side in both]
    return names_in(["", *sides, *items(data.get("functions", [])), data.get("formula", 0)])
