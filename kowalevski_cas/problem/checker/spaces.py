"""Spaces: names with definitions and relations, a vector field, and a conjugation."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import nullcontext
from typing import Self

from .division import is_number
from .formulas import Formulas
from .polynomials import Element, Ring
from .reading import (
    Json,
    derives,
    factors,
    integer,
    items,
    label,
    labels,
    names_in,
    need,
    pairs,
    record,
    say,
    say_all,
    squares_in,
)


def _needs(tree: Json, steps: list[Json]) -> set[str]:
    """The names in a condition, and those of the roots that it takes by the sign."""
    squares = squares_in(tree)
    roots = (step for step in steps if squares and step[0] == "root" and step[2] in squares)
    return names_in(tree) | {label(step[1]) for step in roots}


class Space(Formulas):
    """A space of a certificate; ``before`` are those that stand before it.

    Steps, field, change and conjugation agree with each other, or it is rejected.
    """

    def __init__(self, data: Json, before: list[Self], ring: Ring) -> None:
        record(data, "variables", "constants nonzero steps field change conjugates")
        need(not {"field", "change"} <= data.keys(), "a space has a field, or a change")
        ring.spend(20)
        names = (labels(data.get(key, [])) for key in ("variables", "constants"))
        super().__init__(ring, *names)
        self.data = data
        self.old: Self | None = None
        self.granted: list[Element] = []  # what does not vanish where a change comes from
        steps = items(data.get("steps", []))
        self._generate(steps, pairs(data.get("conjugates", [])))
        conditions = [(_needs(tree, steps), tree) for tree in items(data.get("nonzero", []))]
        conditions = self._grant(conditions)
        late: dict[str, list[Json]] = {}  # what is defined by rates is known behind the field
        for step in steps:
            if step[0] == "let" and (derives(step[2]) or names_in(step[2]) & late.keys()):
                need(label(step[1]) not in late, f"{step[1]} is defined twice")
                late[step[1]] = step
                continue
            self.step(*step)
            conditions = self._grant(conditions)
        self.mirror = None
        old = self._change(before, data["change"]) if "change" in data else []
        self._move(items(data.get("field", [])), old)
        conditions = self._grant(conditions)
        for step in late.values():
            self.step(*step)
            conditions = self._grant(conditions)
        need(not conditions, "a condition has a name that is not defined")
        printed = [step[3] for step in steps if step[0] == "root" and len(step) == 4]
        need(all(e.vanishes() for e in self.differences(printed)), "a root has another square")
        self.stating = False

    # names

    def _generate(self, steps: list[Json], both: list[list[Json]]) -> None:
        """Adjoin all names that are generators, with their conjugates."""
        for step in steps:
            need(len(items(step, 3, 4)) == 3 or step[0] in ("root", "power"), "a step is odd")
        adjoined = [label(step[1]) for step in steps if step[0] in ("root", "power")]
        plain = [*self.variables, *self.constants]
        self.bar = {name: self.ring.adjoin(name) for name in (*plain, *adjoined)}
        self.env = {name: (self.bar[name],) for name in plain}
        roots = {step[1] for step in steps if step[0] == "root"}
        swap = {label(a): label(b) for pair in both for a, b in (pair, pair[::-1])}
        kinds = [{*self.variables}, {*self.constants}, roots]
        need(len(swap) == 2 * len(both), "a name is in two pairs of conjugates")
        for a, b in swap.items():
            need(a != b and any({a, b} <= kind for kind in kinds), "a pair of conjugates is odd")
            self.bar[a] = self.ring.generator(b)

    def step(self, kind: Json, name: Json, tree: Json, more: Json = None) -> None:
        """A definition, a root or a power."""
        need(label(name) not in self.env, f"{name} is defined twice")
        if kind == "let":
            self.env[name] = self.value(tree)
            return
        generator, value = self.ring.generator(name), self.scalar(tree)
        self.mirror = None  # what was conjugated before knows nothing of this name
        if kind == "root":
            self.ring.relate(name, value)
            if (value.value() or 0) < 0:
                need(self.bar[name].is_generator(name), "an imaginary number is its own pair")
                self.bar[name] = -generator
        else:
            need(kind == "power" and more in self.constants, "a step is not understood")
            exponent = self.scalar(more)
            need(self.is_real(value) and self.is_real(exponent), "a power of what is not real")
            self.ring.powers[name] = value, exponent
            with self.granting():
                self.enter(value, say(tree))
                self.enter(generator, name)
        self.env[name] = (generator if value.terms or kind == "power" else value,)

    def _grant(self, conditions: list[tuple[set[str], Json]]) -> list[tuple[set[str], Json]]:
        """Know that formulas do not vanish; returns those with what is not defined yet."""
        waiting = []
        for names, tree in conditions:
            self.ring.spend(1 + (len(names) >> 3))
            if names <= self.env.keys() and (self.rates is not None or not derives(tree)):
                self.assume(tree, granted=True)
            else:
                waiting.append((names, tree))
        return waiting

    def assume(self, tree: Json, granted: bool = False) -> None:
        """Know that no factor of a formula vanishes; what is granted is part of the statement."""
        for factor in factors(tree) or [0]:
            with self.statement(granted):
                element = self.scalar(factor)
            need(not is_number(element), "a number is assumed not to vanish")
            with self.granting() if granted else nullcontext():
                self.enter(element, say(factor))

    # motion

    def _move(self, rows: list[Json], others: list[tuple[Element, Element]]) -> None:
        """Enter the rows of a field, and check that all names move as they have to."""
        rates = {} if self.rates is None else self.rates
        if rows:
            self.rates, self.waiting = rates, {*self.variables}
        moved = set[str]()
        for row in rows:
            names, mass, force = items(row, 3)
            mass, force = self.value(mass), self.value(force)
            need(len(items(names)) == len(mass) == len(force), "a row of the field is odd")
            new = {
                label(n): f * self.inverse(m) for n, m, f in zip(names, mass, force, strict=True)
            }
            need(not moved & new.keys() and len(new) == len(names), "a name moves twice")
            self._movable(new)
            others += [(self.scalar(n), rate) for n, rate in new.items() if n not in self.variables]
            rates |= {name: rate for name, rate in new.items() if name in self.ring.at}
            moved |= new.keys()
            self.waiting -= moved
        need(not self.waiting, "a variable does not move")
        for name in (n for n in self.ring.roots if n in rates):  # the product rule then holds
            half = self.ring.generator(name) * rates[name]
            others.append((self.ring.roots[name], half + half))
        for member, rate in others:
            need((self.along(member, rates) - rate).vanishes(), "a name moves otherwise")

    def _movable(self, names: dict[str, Element]) -> None:
        need(names.keys() <= self.env.keys(), "what moves has no name")
        fixed = {*self.constants, *self.ring.powers}
        need(not names.keys() & fixed, "a constant moves, or a power by itself")

    def _change(self, before: list[Self], data: Json) -> list[tuple[Element, Element]]:
        """Enter the rates of new variables, by the chain rule; the inverse has to be one.

        Returns the old names in terms of the new ones, and their rates.
        """
        record(data, "old formulas time")
        self.old = before[integer(data["old"], 0, len(before) - 1)]
        source = self.old.local()
        source.stating, formulas = True, pairs(data["formulas"])
        new = {label(name): source.scalar(tree) for name, tree in formulas}
        need(len(new) == len(formulas) == len(source.variables), "the change is not one to one")
        need({*self.variables} <= new.keys(), "a new variable has no formula")
        self._movable(new)
        here = self.carried(source.ring, {name: self.scalar(name) for name in source.bar})
        back = ((here(e) - self.scalar(name)).vanishes() for name, e in new.items())
        need(all(back), "the inverse does not give the variables back")
        for name, conjugate in source.bar.items():
            both = here(conjugate) - self.conj(here.images[name])
            need(both.vanishes(), f"{name} does not keep its conjugate, it is not real")
        granted = [*source.granted, *map(source.scalar, source.data.get("nonzero", []))]
        self.granted = [here(e) for e in granted]
        time = here(source.scalar(data["time"]))
        self.inverse(time)
        rates = {name: here(source.derivative(e)) * time for name, e in new.items()}
        self.rates = {name: rate for name, rate in rates.items() if name in self.ring.at}
        old = {name: here(source.derivative(source.scalar(name))) * time for name in source.bar}
        rates_here = [(self.scalar(name), rate) for name, rate in rates.items()]
        return [*rates_here, *((here.images[name], rate) for name, rate in old.items())]

    # words

    def setting(self) -> Iterator[str]:
        """The data in plain letters, after those of the space that it comes from."""
        data = self.data
        if self.old is not None:
            yield from (f"before the change, {line}" for line in self.old.setting())
            yield from (f"new: {say_all([pair])}" for pair in data["change"]["formulas"])
            yield f"factor of the time: {say(data['change']['time'])}"
        for key in ("variables", "constants"):
            if data.get(key):
                yield f"{key}: {', '.join(data[key])}"
        yield from (f"conjugates: {a}, {b}" for a, b in data.get("conjugates", []))
        for kind, name, tree, *more in data.get("steps", []):
            if kind == "root":
                yield f"root: {name} ^ 2 = {say(tree)}"
                yield from (f"that is: {say_all([sides])}" for sides in more)
            else:
                power = "".join(f" ^ {say(to)}, where {say(tree)} > 0" for to in more)
                yield f"{kind}: {name} = {say(tree)}{power}"
        for names, mass, force in data.get("field", []):
            yield f"field: {say(mass)} D({', '.join(names)}) = {say(force)}"
