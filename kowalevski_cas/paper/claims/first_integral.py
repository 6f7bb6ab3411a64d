"""First integrals: an expression does not move, everywhere or on an invariant set."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Partial,
    Relation,
    substitute,
)
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.dimension import check_conjugates
from kowalevski_cas.paper.claims.forms import equations, members, minus, rate, vanishes
from kowalevski_cas.paper.claims.invariant_relations import InvariantRelations
from kowalevski_cas.paper.components import parts, sides
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.logarithms import derivative_of, has_logarithm, with_real_logarithms
from kowalevski_cas.paper.names import head
from kowalevski_cas.paper.summation import without_sums
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Fails, Follows, Goal, Rank
from kowalevski_cas.problem.space import Equation, Meaningless


class FirstIntegral(Claim):
    """The printed expression is constant along every motion on the invariant set ``given``.

    All members of a printed chain are the same function, save those that say which value it has,
    in numbers and names of constants; these are equal too, but for a name that is given to it, and
    the function has it at a real point. The function is not constant by itself (nor is any
    component of it, if it is a vector): its differential is independent of those of the set at a
    real point. With a set, the claim includes that the set is invariant. Of logarithms, which stand
    with constant factors, it is the derivatives that are stated.
    """

    given: tuple[Printed, ...] = ()
    main: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        printed = self.constants(on, space)
        values = self._values(on, space, printed)
        there = self._with_names_of(values, on)
        if equal := (*pairwise(sides(values, there)),):
            yield Follows(there, (equal,), ())
        written = [substitute(one, space.plain.logarithms) for one in printed]
        if any(map(has_logarithm, written)):
            yield from self._of_logarithms(on, written)
            return
        chain = [parts(member, space) for member in sides(printed, space)]
        for same in zip(*chain, strict=True):
            yield from self._goals(on, space, same)
        if values and not there.transcendental.dependent:
            same = level(printed[0], values[0], there)
            given = (*same, *equations(on, there, self.given))
            # The first is refuted where no point has the value; the second asks for one that moves.
            yield Fails(there, (), given)
            yield Follows(there, (tuple(vanishes(rate(part)) for part, _ in same),), given)

    def levels(self, on: Elaborations) -> Iterator[Goal]:
        """That the function has the value that is printed of it, if one is, at a real point."""
        space = on(self.scene)
        printed = self.constants(on, space)
        if values := self._values(on, space, printed):
            there = self._with_names_of(values, on)
            given = equations(on, there, self.given)
            yield Fails(there, (), (*level(printed[0], values[0], there), *given))

    def _goals(
        self, on: Elaborations, space: Elaboration, same: tuple[Formula, ...]
    ) -> Iterator[Goal]:
        """What is claimed of one function, or of a component of a vector."""
        still = tuple(vanishes(rate(member)) for member in same)
        given = equations(on, space, self.given)
        check_conjugates([*map(minus, given)], space)
        yield Follows(space, ((*still, *pairwise(same)),), given, self.main)
        if self.given:
            invariant = InvariantRelations(self.id, self.scene, "", self.given, self.main)
            yield from invariant.goals(on)
        # equations between vectors count by their components
        yield Rank(space, (same[-1],), given, 1 + len(space.finder.differences(given)))

    def _of_logarithms(self, on: Elaborations, printed: list[Formula]) -> Iterator[Goal]:
        """The rate of a function with logarithms vanishes, and its differential does not.

        It is about points at which the logarithms, and the roots in their derivatives, are real.
        """
        if len(printed) > 1 or self.given:
            raise Meaningless("a function with logarithms is claimed by itself, on no set")
        space = on(with_real_logarithms(self.scene, printed))
        try:
            _ = space.finder
        except Meaningless as error:
            raise Meaningless(
                f"a logarithm, or an arc, is real nowhere: {error}", error.name
            ) from None

        def vanishing(by: Callable[[Formula], Formula]) -> Equation:
            return vanishes(space.plain(derivative_of(printed[0], by, space)))

        mark = "dot" if self.scene.time == "t" else "prime"
        yield Follows(space, ((vanishing(lambda term: Derivative(term, mark)),),), ())
        names = (*self.scene.variables, *space.velocities.values())
        yield Fails(space, (tuple(vanishing(partial(Partial, by=name)) for name in names),))

    def remark(self, on: Elaborations) -> str:
        """That a function is constant off its set as well, which is more than is claimed."""
        if not self.given:
            return ""
        goals = (goal for goal in replace(self, given=()).goals(on) if isinstance(goal, Follows))
        sides = [pair for goal in goals for conclusion in goal.conclusions for pair in conclusion]
        whole = all(rest.is_zero for rest in on(self.scene).finder.differences(sides))
        return "it is constant along the motions off this set, too" if whole else ""

    def constants(self, on: Elaborations, space: Elaboration) -> list[Formula]:
        """The members that have to be constant; not names that are defined by the others."""
        chain = self._chain(on)
        here = {head(n)[0] for n, place in self.scene.definitions.items() if place == self.own}
        chain = [m for m in chain if _called(m) not in here] or chain
        return [member for member in chain if not _is_level(member, space)] or chain

    def _chain(self, on: Elaborations) -> list[Formula]:
        formula = without_sums(on.texts.formula(self.own))
        return members(formula) if isinstance(formula, Relation) else [formula]

    def _with_names_of(self, values: Sequence[Formula], on: Elaborations) -> Elaboration:
        """The setting in which all names of the values are constants."""
        if not values:
            return on(self.scene)
        names = frozenset[str]().union(*(value.names() for value in values))
        known = {*self.scene.names(), *self.scene.definitions, *self.scene.vectors}
        constants = (*self.scene.constants, *sorted(names - known))
        # A space of its own, also with no new name: the function moves in one that knows no value.
        return on(replace(self.scene, constants=constants))

    def _values(
        self, on: Elaborations, space: Elaboration, printed: list[Formula]
    ) -> list[Formula]:
        """The members that say which value it has; a name that stands in no other says nothing."""
        levels = [m for m in self._chain(on) if m not in printed and _is_level(m, space)]
        names = Counter(node.name for m in levels for node in m.nodes() if isinstance(node, Name))
        return [m for m in levels if not isinstance(m, Name) or names[m.name] > 1]


def level(function: Formula, value: Formula, there: Elaboration) -> tuple[Equation, ...]:
    """The equations, by components, that say which value a function has."""
    both = (parts(member, there) for member in sides([function, value], there))
    return tuple((left, right) for left, right in zip(*both, strict=True))


def _called(member: Formula) -> str:
    """The name that a member is, perhaps with its arguments; none if it is anything else."""
    match member:
        case Name(name):
            return name
        case Application(function, arguments) if all(isinstance(a, Name) for a in arguments):
            return function
    return ""


def _is_level(formula: Formula, space: Elaboration) -> bool:
    """Whether a member only says which value the integral has, as 2h, or 1.

    Its names are constants of the scene, or have no meaning there.
    """
    return not any(
        isinstance(node, Derivative) or (isinstance(node, Name) and _has_value(node.name, space))
        for node in formula.nodes()
    )


def _has_value(name: str, space: Elaboration) -> bool:
    if name in space.scene.variables:
        return True  # also where its functions stand in its place
    try:
        return space.step(name) is not None or name not in space.constants
    except Meaningless:
        return False
