"""Problems, and what evidence proves about them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from .along import Along
from .counts import Count
from .division import tree_of
from .evidence import locate, numbers_of
from .formulas import rational
from .goals import Fails, Follows, Goal, Rank, names_of
from .kernels import Kernel
from .polynomials import Element, Ring
from .reading import Json, integer, items, label, labels, need, pairs, record, say, say_all
from .spaces import Space

KINDS: dict[str, type[Goal]] = {
    "follows": Follows,
    "fails": Fails,
    "rank": Rank,
    "count": Count,
    "kernel": Kernel,
    "along": Along,
}


class Problem:
    """Spaces and goals."""

    def __init__(self, spaces: Json, goals: Json, ring: Ring, kind: type[Space] = Space) -> None:
        self.spaces = list[Space]()
        for data in items(spaces):
            self.spaces.append(kind(data, self.spaces, ring.another()))
        self.goals = items(goals)
        need(self.goals, "there is no goal")
        for goal in self.goals:
            self._look(goal)

    def _look(self, goal: Json, inner: bool = False) -> None:
        """Look at the shape of a goal."""
        need(type(goal) is dict and type(goal.get("goal")) is str, "a goal is expected")
        if goal["goal"] == "exists" and not inner:
            record(goal, "goal numbers expressions goals")
            need(labels([*items(goal["numbers"]), *items(goal["expressions"])]), "no name is bound")
            need(items(goal["goals"]), "nothing is stated")
            for one in goal["goals"]:
                self._look(one, inner=True)
            return
        known = goal["goal"] in KINDS and not (
            inner and goal["goal"] in ("count", "kernel", "along")
        )
        need(known, "the goal is unknown")
        record(goal, f"goal space {KINDS[goal['goal']].KEYS}")
        integer(goal["space"], 0, len(self.spaces) - 1)
        for key in {"rank", "number"} & goal.keys():
            integer(goal[key], 0, 1000)

    def holds(self, goal: Json, evidence: Json) -> Theorem:
        """What the evidence proves."""
        if goal["goal"] == "exists":
            return self._exists(goal, evidence)
        space = self.stage(goal, evidence)
        KINDS[goal["goal"]](space, goal).holds(evidence)
        return theorem(sentence(goal), space, evidence)

    def denied(self, goal: Json, evidence: Json) -> Theorem:
        """What the evidence refutes."""
        if goal["goal"] == "exists":
            return self._exists_not(goal, evidence)
        space = self.stage(goal, evidence)
        KINDS[goal["goal"]](space, goal).denied(evidence)
        return theorem(sentence(goal, holds=False), space, evidence)

    def stage(self, goal: Json, evidence: Json, values: Json = ()) -> Space:
        """The space of a goal, with its conditions, and bound names that stand for values."""
        need(type(evidence) is dict, "evidence is expected")
        space: Space = self.spaces[goal["space"]].local()
        for tree in items(evidence.get("away", [])):
            space.assume(tree)
        found = {name: space.value(tree) for name, tree in values}
        need(not found.keys() & space.env.keys(), "a bound name has another meaning")
        space.env |= found
        return space

    # what exists

    def _exists(self, goal: Json, evidence: Json) -> Theorem:
        """Values for the bound names, with which all goals hold."""
        record(evidence, "values evidence")
        bound = goal["numbers"] + goal["expressions"]
        values = {label(name): tree for name, tree in pairs(evidence["values"])}
        need([name for name, _ in evidence["values"]] == bound, "values are for other names")
        entries = items(evidence["evidence"], len(goal["goals"]))
        used, found = set[str](), list[Theorem]()
        for inner, entry in zip(goal["goals"], entries, strict=True):
            names = names_of(inner) & values.keys()
            used |= names
            space = self.stage(inner, entry, [(n, values[n]) for n in bound if n in names])
            for name in (n for n in goal["numbers"] if n in names):
                rational(space, values[name])
            KINDS[inner["goal"]](space, inner).holds(entry)
            found.append(theorem(sentence(inner), space, entry))
        need(used == {*bound}, "a bound name is not used")
        shown = ", ".join(f"{name} = {say(tree)}" for name, tree in values.items())
        return Theorem(f"{sentence(goal)}, namely {shown}", parts=found)

    def _exists_not(self, goal: Json, evidence: Json) -> Theorem:
        """Points where an equation fails, whatever the bound names stand for."""
        record(evidence, "inner points")
        inner = goal["goals"][integer(evidence["inner"], 0, len(goal["goals"]) - 1)]
        plain = (
            inner["goal"] == "follows" and inner["given"] == [] and len(inner["conclusions"]) == 1
        )
        need(plain, "no identity is denied")
        space = self.stage(inner, {})
        bound = {name: space.bind(name)[0] for name in goal["numbers"] + goal["expressions"]}
        space.ring.unknown |= {bound[name] for name in goal["expressions"]}
        with space.statement():
            differences = space.differences(inner["conclusions"][0])
        single = len(pairs(evidence["points"])) == 1 or not goal["expressions"]
        need(single, "expressions may differ from point to point")
        points = [point for _, point in evidence["points"]]
        numbers = numbers_of(space, points)
        weights = [numbers.ring.number(rational(space, w)) for w, _ in evidence["points"]]
        places = [locate(space, point, [], numbers) for point in points]

        def total(part: Element) -> Element:
            return numbers.ring.total(w * at(part) for w, at in zip(weights, places, strict=True))

        fixed = any(fails_regardless(e, [*bound.values()], total) for e in differences)
        need(fixed, "the two sides may be equal")
        return theorem(sentence(goal, holds=False), space, {"points": points})


def fails_regardless(
    element: Element, unknown: list[str], total: Callable[[Element], Element]
) -> bool:
    """Whether the total of an element is not zero, whatever the unknown names stand for."""
    parts: dict[tuple[int, ...], Element] = {(): element}
    for name in unknown:
        parts = {(*k, e): p for k, q in parts.items() for e, p in q.split(name).items()}
    free = parts.pop((0,) * len(unknown), element.ring.number(0))
    return total(free).differs() and all(total(part).vanishes() for part in parts.values())


# -- words -------------------------------------------------------------------------


def sentence(goal: Json, holds: bool = True) -> str:
    """A goal in plain letters, or that it does not hold."""
    if goal["goal"] == "fails":
        return sentence({**goal, "goal": "follows"}, not holds)
    if goal["goal"] == "exists":
        kinds = {"rational numbers": goal["numbers"], "expressions": goal["expressions"]}
        shown = " and ".join(f"{kind} {', '.join(names)}" for kind, names in kinds.items() if names)
        words = f"there are {shown} with {'; '.join(map(sentence, goal['goals']))}"
    else:
        words = KINDS[goal["goal"]].words(goal)
    return words if holds else f"it is false that {words}"


@dataclass(frozen=True)
class Theorem:
    """What was proved, in plain letters: where, and about what.

    ``divisors`` are the polynomials, as formulas, that are supposed not to vanish.
    """

    words: str
    where: Sequence[str] = ()
    about: Sequence[str] = ()
    divisors: Sequence[Json] = ()
    parts: Sequence[Theorem] = ()

    def summary(self) -> str:
        """The theorem in a line, with its conditions."""
        where = [*self.where, *(condition for part in self.parts for condition in part.where)]
        return self.words + (f", for {', '.join(dict.fromkeys(where))} != 0" if where else "")

    def lines(self, indent: str = "  ") -> Iterator[str]:
        """All of it."""
        yield indent + self.words
        for line in (*self.about, *(f"for {condition} != 0" for condition in self.where)):
            yield f"{indent}  {line}"
        for part in self.parts:
            yield from part.lines(f"{indent}  ")


def theorem(words: str, space: Space, evidence: Json) -> Theorem:
    """A theorem over a space."""
    points = evidence.get("points", [evidence["point"]] if "point" in evidence else [])
    about = [*space.setting(), *(f"point: {say_all(p['values'])}" for p in points)]
    where = [*space.known.values()]
    space.ring.spend(sum(map(len, (*where, *about))) >> 3)
    return Theorem(words, where, about, [*map(tree_of, space.supposed())])
