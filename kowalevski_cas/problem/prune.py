"""Problems with nothing in their spaces but what the goals lead to."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from kowalevski_cas.notation import Formula, Name, Partial, Root
from kowalevski_cas.problem.goals import (
    Along,
    Count,
    Exists,
    Goal,
    Kernel,
    Problem,
    Rank,
    Simple,
    simple,
)
from kowalevski_cas.problem.mentions import Mentions, mentions
from kowalevski_cas.problem.space import Adjoined, ChangeOfVariables, Raised, Setting, Space, Step


class Reach:
    """What is reached of a setting, from formulas, through definitions of definitions."""

    def __init__(self, setting: Setting) -> None:
        self.setting = setting
        self.bound: set[str] = set()
        self.names: set[str] = set()
        self.steps: list[Step] = []
        self.moving = False

    def formula(self, formula: Formula) -> None:
        """Reach what a formula uses."""
        self._reach(mentions(formula))

    def _reach(self, found: Mentions) -> None:
        for node in found:
            if isinstance(node, Name):
                self.name(node.name)
            elif isinstance(node, Root):
                self._root(node)
            elif isinstance(node, Partial):
                self.name(node.by)
            else:
                self.move()

    def name(self, name: str) -> None:
        """Reach a name, and what defines it."""
        if name in self.names or name in self.bound:
            return
        self.names.add(name)
        step = self.setting.step(name)
        if step is None:
            return
        first, *others = step.mentions
        self._reach(first)
        if isinstance(step, Raised):
            self.name(step.exponent)
        self.steps.append(step)
        for found in others:  # the printed equation of a root, in which it stands
            self._reach(found)

    def _root(self, root: Root) -> None:
        """The declared roots: which of them is meant is a question of values."""
        for name in sorted(self.setting.roots, key=lambda name: not name.startswith(r"\sqrt")):
            step = self.setting.step(name)
            if isinstance(step, Adjoined) and step.square == root.argument:
                self.name(name)
                return
        for name in self.setting.roots:
            if name.startswith(r"\sqrt"):
                self.name(name)

    def move(self) -> None:
        """Reach the whole vector field."""
        if self.moving:
            return
        self.moving = True
        self.whole()
        for row in self.setting.field:
            self.formula(row.factor)
            self.formula(row.force)
            for name in row.names:
                self.name(name)
        if (change := self.setting.change) is not None:
            for name, _ in change.formulas:
                self.name(name)
            old = change.old
            for name in old.variables:
                self.name(name)
            if "i" in old.roots:
                self.name("i")

    def goal(self, goal: Simple) -> None:
        """Reach what a goal uses; a rank is about all variables, a kernel about the motion."""
        _reach_goal(goal, (), self)

    def whole(self) -> None:
        """Reach all variables."""
        for name in self.setting.variables:
            self.name(name)

    def close(self) -> None:
        """Reach the partners of conjugates, what belongs together, and what is granted."""
        before = -1
        while before != len(self.names):
            before = len(self.names)
            for pair in (*self.setting.conjugates, *self.setting.together):
                if self.names & {*pair}:
                    for name in pair:
                        self.name(name)
        for formula in self.setting.nonzero:
            if self._is_reached(self._spoken_of(formula)):
                self.formula(formula)

    def granted(self) -> Iterator[Formula]:
        """What is granted of names that are reached; by other names, if need be."""
        for formula in self.setting.nonzero:
            if self._is_reached(formula):
                yield formula
                continue
            other = self.setting.numerator(formula)
            if other.names() and self._is_reached(other):
                yield other

    def _spoken_of(self, formula: Formula) -> Formula:
        """What is granted, or what a printed root says the sign of, by being real."""
        step = self.setting.step(formula.name) if isinstance(formula, Name) else None
        if isinstance(step, Adjoined) and step.name.startswith(r"\sqrt"):
            return step.square
        return formula

    def _is_reached(self, formula: Formula) -> bool:
        """Whether a formula speaks of names that are reached only."""
        trial = Reach(self.setting)
        trial.names = {*self.names}  # with all to which they lead
        trial.formula(formula)
        return trial.names == self.names


def prune(goals: Iterable[Goal]) -> Problem:
    """The problem of some goals, over spaces that hold what the goals lead to and no more.

    What is left of a setting once more is the same space.
    """
    goals = tuple(goals)
    reaches: dict[Setting, Reach] = {}
    for goal in goals:
        bound = goal.bound if isinstance(goal, Exists) else ()
        for part in simple(goal):
            _reach_goal(part, bound, _reach_of(part.space, reaches))
    made: dict[Setting, Space] = {}
    for setting in reversed([*reaches]):
        _reach_source(setting, reaches)
    for found in reaches.values():
        found.close()
    stated = {part.space for goal in goals for part in simple(goal)}
    for setting in _sources_first(reaches, stated):
        space = _space(reaches[setting], made)
        made[setting] = setting.left.setdefault(_key(space), space)
    return Problem(tuple(_over(goal, made) for goal in goals))


def _reach_of(setting: Setting, reaches: dict[Setting, Reach]) -> Reach:
    """What is reached of a setting, and of the one behind a change."""
    if setting not in reaches:
        reaches[setting] = Reach(setting)
        if setting.change is not None:
            _reach_of(setting.change.old, reaches)
    return reaches[setting]


def _reach_goal(goal: Simple, bound: Iterable[str], reach: Reach) -> None:
    """Reach what a goal uses; a rank is about all variables, a kernel about the motion."""
    reach.bound |= {*bound}
    for formula in goal.formulas():
        reach.formula(formula)
    if isinstance(goal, Rank):
        reach.whole()
    if isinstance(goal, Kernel | Along):
        reach.move()
    for name in goal.names if isinstance(goal, Count) else ():
        reach.name(name)


def moves(goal: Simple, bound: Iterable[str]) -> bool:
    """Whether a goal, in which some names are bound, is about the motion."""
    reach = Reach(goal.space)
    _reach_goal(goal, bound, reach)
    return reach.moving


def _reach_source(setting: Setting, reaches: dict[Setting, Reach]) -> None:
    """The formulas of a change, and the motion behind it, where the new field is needed."""
    change = setting.change
    if change is None or not reaches[setting].moving:
        return
    source = reaches[change.old]
    source.move()
    for _, formula in change.formulas:
        source.formula(formula)
    source.formula(change.time)
    for name in (*change.old.constants, *change.old.roots):
        if name in source.names:
            reaches[setting].name(name)
    _reach_source(change.old, reaches)


def _sources_first(reaches: dict[Setting, Reach], stated: set[Setting]) -> list[Setting]:
    order: list[Setting] = []

    def place(setting: Setting) -> None:
        if setting in order:
            return
        if reaches[setting].moving and setting.change is not None:
            place(setting.change.old)
        order.append(setting)

    for setting in reaches:
        if reaches[setting].names or setting in stated:
            place(setting)
    return order


def _space(reach: Reach, made: dict[Setting, Space]) -> Space:
    setting, known = reach.setting, reach.names
    change = setting.change if reach.moving else None
    return Space(
        variables=tuple(n for n in setting.variables if n in known),
        constants=tuple(n for n in setting.constants if n in known),
        nonzero=tuple(dict.fromkeys(reach.granted())),
        steps=tuple(reach.steps),
        field=setting.field if reach.moving else (),
        change=None
        if change is None
        else ChangeOfVariables(made[change.old], change.formulas, change.time),
        conjugates=tuple(pair for pair in setting.conjugates if {*pair} <= known),
        loci=tuple(
            (equations, condition)
            for equations, condition in setting.loci
            if all(
                map(reach._is_reached, (condition, *(side for two in equations for side in two)))
            )
        ),
    )


def _key(space: Space) -> object:
    """All that a space says, as a key."""
    change = space.change
    come = None if change is None else (id(change.old), change.formulas, change.time)
    return (
        space.variables, space.constants, space.nonzero, space.steps, space.field, come,
        space.conjugates, space.loci,
    )  # fmt: skip


def _over(goal: Goal, made: dict[Setting, Space]) -> Goal:
    if isinstance(goal, Exists):
        inner: list[Simple] = [
            replace(inner_goal, space=made[inner_goal.space]) for inner_goal in goal.goals
        ]
        return replace(goal, goals=tuple(inner))
    return replace(goal, space=made[goal.space])
