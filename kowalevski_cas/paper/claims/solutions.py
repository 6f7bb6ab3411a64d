"""Functions that are other expressions, since both solve one system from one beginning."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Application, Formula, Name, Number
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import equation
from kowalevski_cas.paper.directions import directions
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.families import Generators, Kind, kind_of, template
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Along, Goal
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import EquationOfMotion, Meaningless, Space


class EqualSolutions(Claim):
    """Functions of the time are what the printed ``equations`` say, as those of Landen do.

    On their left sides stand all generators of one family at the time, with one modulus. The right
    sides may have functions of other families, or with other moduli, at multiples of the time. Both
    solve one system of differential equations, and where the time is zero they are equal.
    """

    equations: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        lefts = [on.texts.sides(place)[0] for place in self.equations]
        kind, letters = _generators(lefts, space)
        names = kind.names(Name(self.scene.time))
        sides = [equation(on, space, place)[1] for place in self.equations]
        yield _along(space, kind, names, dict(zip(letters, sides, strict=True)))

    def establishes(self) -> Iterator[Printed]:
        yield from self.equations


def _generators(lefts: list[Formula], space: Elaboration) -> tuple[Kind, list[str]]:
    """The family of which the generators stand there, and their letters in it."""
    time, found = Name(space.scene.time), []
    for left in lefts:
        if not isinstance(left, Application) or left.arguments[:1] != (time,):
            raise Meaningless("a function of the time is expected on the left")
        found.append(left)
    kinds = {kind_of(left) for left in found}
    kind = kinds.pop()
    by_name = {name: letter for letter, name in kind.names(time).items()}
    values = [space.plain(left) for left in found]
    letters = [by_name.get(value.name, "") for value in values if isinstance(value, Name)]
    if kinds or {*letters} != {*kind.family.rates} or len(letters) != len(lefts):
        raise Meaningless("all functions of one family are expected on the left, each once")
    return kind, letters


def _along(
    space: Elaboration, kind: Kind, names: dict[str, str], sides: dict[str, Formula]
) -> Along:
    """The goal: what moves are the functions on the left, and those on the right."""
    reach = Reach(space)
    for formula in (*sides.values(), *kind.parameters):
        reach.formula(formula)
    groups = [g for g in space.transcendental.groups if {*g.names.values()} & reach.names]
    if any(kind == group.kind for group in groups):
        raise Meaningless("the functions on the left stand on the right as well")
    initial: dict[str, Formula] = {}
    field: dict[str, Formula] = {}
    for group in groups:
        initial |= _initial_values(group.kind, group.names)
        moving = {*group.moving} & initial.keys()
        field |= {n: rate for n, rate in _rates(group, space).items() if n in moving}
    initial |= _initial_values(kind, names)
    field |= kind.rates(names)
    moving = {*initial}
    for name in kind.names(Name(space.scene.time)).values():
        reach.names.discard(name)
    for group in groups:
        for name in group.names.values():
            reach.name(name)
    return Along(
        Space(
            variables=tuple(field),
            constants=tuple(n for n in space.constants if n in reach.names - moving),
            nonzero=tuple(f for f in space.nonzero if f.names() <= reach.names),
            steps=tuple(step for step in reach.steps if step.name not in names.values()),
            field=tuple(
                EquationOfMotion((name,), Number(1), space.plain(rate))
                for name, rate in field.items()
            ),
        ),
        tuple(initial.items()),
        tuple((names[letter], side) for letter, side in sides.items()),
    )


def _initial_values(kind: Kind, names: dict[str, str]) -> dict[str, Formula]:
    return {names[letter]: template(tex) for letter, tex in kind.family.zero.items()}


def _rates(group: Generators, space: Elaboration) -> dict[str, Formula]:
    """The rates of generators at a multiple of the time, by the time."""
    time = space.scene.time
    rates = directions(space.transcendental, time)
    names = space.transcendental.names_under(group)
    if names - {*space.constants, time} or time not in names:
        raise Meaningless("a function of a multiple of the time is expected on the right")
    return {name: rates[name] for name in group.names.values()}
