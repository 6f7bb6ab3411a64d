"""What holds along the motion that begins at given values: two solutions of one regular system."""

from __future__ import annotations

from .evidence import locate
from .formulas import Map
from .goals import Goal
from .polynomials import Element
from .reading import Json, integer, label, need, pairs, record, say, say_all
from .spaces import Space

ORDER = 12
"""The largest order of a derivative that is looked at."""


class Along(Goal):
    """Along the motion with these initial values variables are equal to other expressions."""

    KEYS = "initial equations"

    def __init__(self, space: Space, data: Json) -> None:
        self.space = space = space.local()  # nothing is said where a side is not defined
        need(space.rates and not space.ring.powers, "nothing moves here as it should")
        self.rates = dict(space.rates or {})
        with space.statement():
            self.values = self._given(data["equations"])
            need(self.values.keys() <= {*space.variables}, "it is about no variables")
            self.start = self._start(self._given(data["initial"]))

    def _given(self, data: Json) -> dict[str, Element]:
        """Names with their values."""
        found = {label(name): self.space.scalar(tree) for name, tree in pairs(data)}
        need(found and len(found) == len(data), "there is no name, or one is given twice")
        return found

    def _start(self, initial: dict[str, Element]) -> Map:
        """What elements are where the motion begins: there all is defined that moves."""
        space, ring = self.space, self.space.ring
        still = {*space.constants}
        for name, square in ring.roots.items():
            if still.issuperset(square.generators()):
                still.add(name)
        need(
            initial.keys() == space.bar.keys() - still, "it does not begin at values of what moves"
        )
        printed = any(name.startswith("\\sqrt") for name in initial)
        need(not printed, "a printed root moves, and may come to zero")  # it would be -r behind it
        for value in initial.values():
            need(still.issuperset(value.generators()), "what is constant gives the initial values")
        start = space.carried(ring, {name: ring.generator(name) for name in still} | initial)
        for name in initial:
            start(space.derivative(ring.generator(name)))  # it is defined there
        for value in self.values.values():
            start(value)
        for name in [*space.known]:
            space.inverse(start(ring.divisors[name]))
        return start

    def holds(self, evidence: Json) -> None:
        """Both sides solve one system, regular where they begin, and begin as one."""
        record(evidence, "point")
        space, ring, names = self.space, self.space.ring, {*self.values}
        self._locate(evidence["point"])
        others = {name: ring.generator(name) for name in space.bar.keys() - names}
        other = space.carried(ring, others | self.values)
        with space.statement():
            for name, value in self.values.items():
                rate, along = self.rates[name], space.derivative(value)
                need(names.isdisjoint(value.generators()), "a side is about what it should give")
                need(names.isdisjoint(along.generators()), "a side moves with what it should give")
                need(self._is_regular(rate, names), "the system is not regular")
                need((along - other(rate)).vanishes(), f"{name} moves otherwise")
                begins = self.start(ring.generator(name)) - self.start(value)
                need(begins.vanishes(), f"{name} begins otherwise")

    def _is_regular(self, rate: Element, names: set[str]) -> bool:
        """Whether a rate is a polynomial in some names."""
        divisors = self.space.ring.divisors
        below = {
            n
            for generator in rate.generators()
            if generator in divisors
            for n in divisors[generator].generators()
        }
        return names.isdisjoint(below)

    def denied(self, evidence: Json) -> None:
        """A derivative of the difference is not zero where the motion begins."""
        record(evidence, "point order")
        space, order = self.space, integer(evidence["order"], 0, ORDER)
        at, ring = self._locate(evidence["point"]), space.ring
        differences = [ring.generator(name) - value for name, value in self.values.items()]
        with space.statement():
            for _ in range(order):
                differences = [*map(space.derivative, differences)]
        need(
            any(at(difference).differs() for difference in differences),
            "the two sides may be equal",
        )

    def _locate(self, point: Json) -> Map:
        """A point where the motion begins."""
        images = self.start.images
        begin = [self.space.ring.generator(name) - value for name, value in images.items()]
        return locate(self.space, point, begin)

    @staticmethod
    def words(data: Json) -> str:
        begins = " and ".join(f"{name} = {say(tree)}" for name, tree in data["initial"])
        return f"{say_all(data['equations'])} along the motion that begins at {begins}"
