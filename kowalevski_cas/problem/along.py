"""Whether variables are equal to other expressions along the motion with given initial values.

Both solve one system of differential equations, which is regular where the motion begins, and
begin as one: then they are equal. If some derivative of a difference is not zero at the beginning,
they are not.
"""

from __future__ import annotations

from functools import cached_property

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Name
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Along
from kowalevski_cas.problem.place import Misplaced, PointEvaluation

ORDER = 12
"""The largest order of a derivative that is looked at, by the checker as well."""


class InitialValueProblem:
    """The sides of a goal, and the beginning of the motion.

    Raises :class:`Misplaced` if it does not begin with values of all that moves, or where
    something is not defined.
    """

    def __init__(self, goal: Along, at: Evaluation) -> None:
        self.at, setting = at, at.setting
        self.values = {name: at.scalar(formula) for name, formula in goal.equations}
        initial = {name: at.scalar(formula) for name, formula in goal.initial}
        if len(self.values) != len(goal.equations) or len(initial) != len(goal.initial):
            raise Misplaced("a name is given twice")
        if not self.values or not self.values.keys() <= {*setting.variables} or setting.powers:
            raise Misplaced("it is about no variables")
        still = {*setting.constants}
        for name in setting.roots:
            if still.issuperset(self._names(at.roots[name])):
                still.add(name)
        moving = {*setting.variables, *setting.roots} - still
        if initial.keys() != moving:
            raise Misplaced("it does not begin at values of what moves")
        if any(name.startswith(r"\sqrt") for name in moving):
            raise Misplaced("a printed root moves, and may come to zero")
        if not all(still.issuperset(self._names(value)) for value in initial.values()):
            raise Misplaced("what is constant gives the initial values")
        self._begin(initial)

    def _begin(self, initial: dict[str, Element]) -> None:
        """Where the motion begins, roots are roots, and all is defined."""
        self.initial, at = initial, self.at
        for name in at.setting.roots:
            if name in initial and not (initial[name] ** 2 - self.start(at.roots[name])).is_zero:
                raise Misplaced(f"{name} is not a root where it begins")
        try:
            for name in initial:
                self.start(at.derivative(at.scalar(Name(name))))
            for value in self.values.values():
                self.start(value)
            for granted in at.granted:
                self.start(granted).inverse()
        except ZeroDivisionError:
            raise Misplaced("something is not defined where it begins") from None

    def start(self, element: Element) -> Element:
        """What an element is where the motion begins."""
        return self.at.image(element, self._initial)

    def _initial(self, name: str) -> Element:
        return self.initial[name] if name in self.initial else self.at.scalar(Name(name))

    def other(self, element: Element) -> Element:
        """What an element is with the other sides in the place of the variables."""
        return self.at.image(
            element, lambda name: self.values.get(name) or self.at.scalar(Name(name))
        )

    @cached_property
    def differences(self) -> list[Element]:
        """What vanishes where the motion begins."""
        return [self.at.scalar(Name(name)) - value for name, value in self.initial.items()]

    def _names(self, element: Element) -> set[str]:
        """The names of the generators and roots in an element, and in what it is divided by."""
        ring = element.ring
        below = (ring.divisors[index] for index in element.denominator)
        found = {
            ring.polynomials.generators[place]
            for part in (*element.parts.values(), *below)
            for place in ring.polynomials.occurring_places(part)
        }
        bits = {
            bit for mask in element.parts for bit in range(mask.bit_length()) if mask >> bit & 1
        }
        return found | {ring.roots[bit] for bit in bits}

    def below(self, element: Element) -> set[str]:
        """The names in what an element is divided by."""
        ring = element.ring
        occurring = (
            ring.polynomials.occurring_places(ring.divisors[k]) for k in element.denominator
        )
        return {ring.polynomials.generators[place] for places in occurring for place in places}


def check_equal(solved: InitialValueProblem) -> None:
    """Check that both sides solve one regular system, and begin as one."""
    at, names = solved.at, {*solved.values}
    for root in at.setting.roots:
        if not names.isdisjoint(solved._names(at.roots[root])):
            raise Misplaced("a root is about what a side should give")
    for name, value in solved.values.items():
        rate, along = at.rates[name], at.derivative(value)
        if not names.isdisjoint(solved._names(value) | solved._names(along)):
            raise Misplaced("a side is about what it should give")
        if not names.isdisjoint(solved.below(rate)):
            raise Misplaced("the system is not regular")
        if not (along - solved.other(rate)).is_zero:
            raise Misplaced(f"{name} moves otherwise")
        if not (solved.start(at.scalar(Name(name))) - solved.start(value)).is_zero:
            raise Misplaced(f"{name} begins otherwise")


def check_departure(solved: InitialValueProblem, order: int, place: PointEvaluation) -> None:
    """Check that a derivative of this order of some difference is not zero at the beginning."""
    if not 0 <= order <= ORDER:
        raise Misplaced(f"the order is at most {ORDER}")
    at = solved.at
    for name, value in solved.values.items():
        difference = at.scalar(Name(name)) - value
        for _ in range(order):
            difference = at.derivative(difference)
        if not place(difference).is_zero:
            return
    raise Misplaced("the two sides may be equal")
