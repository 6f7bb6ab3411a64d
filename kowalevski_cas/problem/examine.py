"""What all evidence is made of: proofs, and points where what they are about is defined."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import reduce
from operator import add, mul

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name, Negative, Number, Power, Product, Quotient, Sum
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Point, Proof
from kowalevski_cas.problem.goals import Simple
from kowalevski_cas.problem.place import PointEvaluation
from kowalevski_cas.problem.prune import moves
from kowalevski_cas.problem.space import Adjoined, Equation, Setting, all_names

Of = Callable[[Setting], Evaluation]


LARGEST_POWER = 16
"""The largest power of a goal that a proof combines."""


class Unproved(ValueError):
    """Evidence that does not prove what it should; the message says why."""


class Vacuous(Unproved):
    """Evidence without a point: what it shows may be about nothing."""


@dataclass
class Accepted:
    """What was accepted: elements with their denominators, by the space in which they live.

    ``divided`` are those of each simple goal and its evidence, in order, and ``away`` those of the
    evidence. ``places`` are the points of the evidence; ``differs`` the two
    values that differ at the last one.
    """

    divided: list[tuple[Simple, list[Element]]] = field(default_factory=list)
    away: list[list[Element]] = field(default_factory=list)
    places: list[PointEvaluation] = field(default_factory=list)
    differs: tuple[Element, Element] | None = None

    def starts(self, goal: Simple) -> None:
        """Begin with a simple goal."""
        self.divided.append((goal, []))
        self.away.append([])

    def divides(self, elements: Sequence[Element]) -> None:
        """Enter elements that stand in the statement or in its evidence."""
        self.divided[-1][1].extend(e for e in elements if e.denominator)

    def uses(self, elements: Sequence[Element]) -> None:
        """Enter elements of the evidence for the simple goal at hand."""
        self.divides(elements)
        self.away[-1].extend(e for e in elements if e.denominator)


class Examiner:
    """Checks proofs and points, and notes what was accepted.

    ``of`` evaluates spaces.
    """

    def __init__(self, of: Of) -> None:
        self.of = of
        self.accepted = Accepted()

    def _unconditional(self, at: Evaluation) -> None:
        """Refuse evidence that divides by what may vanish: it would show nothing there."""
        from kowalevski_cas.algebra.factors import vanishes_with

        # what is supposed beside the goal would leave nothing of its set
        away = {id(element) for element in (*self.accepted.away[-1], *at.hypotheses)}
        stated = [e for e in self.accepted.divided[-1][1] if id(e) not in away]
        known = {index for element in stated for index in element.denominator}
        known = set() if at.ring.roots else known  # they may be those of norms
        stated_divisors = _divisors(self.accepted.divided[-1][0].formulas())
        below = (part for formula in stated_divisors for part in at.components(formula))
        for element in (*map(at.scalar, at.setting.nonzero), *below):
            for index in element.inverse().denominator:
                if vanishes_with(element, Element(at.ring, {0: at.ring.divisors[index]}, {})):
                    known.add(index)
        if any(element.denominator.keys() - known for element in self.accepted.away[-1]):
            raise Unproved("it divides by what may be zero")

    def _settle(
        self, goals: Sequence[Element], known: Sequence[Element], proof: Proof, at: Evaluation
    ) -> Iterator[Element]:
        """Check a proof; what stands in it is yielded."""
        equal = [_difference(sides, at) for sides in proof.equal]
        yield from equal
        known = [*known, *equal]
        groups = [[at.scalar(entry) for entry in group] for group in proof.product]
        if groups:
            _check_groups(groups, at.setting)
            for group, case in zip(groups, proof.cases, strict=True):
                yield from group
                yield from self._settle(goals, [*known, *group], case, at)
            goals = [reduce(mul, (value_of(group) for group in groups))]
        if not 1 <= proof.power <= LARGEST_POWER:
            raise Unproved("it is no power that is taken")
        rows = proof.rows or ((),) * len(goals)
        if len(rows) != len(goals):
            raise Unproved("there is not a row for each goal")
        for goal, row in zip(goals, rows, strict=True):
            goal = goal**proof.power
            entries = [at.scalar(entry) for entry in row]
            if row and len(row) != len(known):
                raise Unproved("a row does not fit what is known")
            for entry, element in zip(entries, known, strict=False):
                if not entry.is_zero:
                    goal = goal - entry * element
            if not goal.is_zero:
                raise Unproved("the two sides are not equal")
            yield from entries

    def _point(
        self, at: Evaluation, point: Point | None, known: Sequence[Element]
    ) -> PointEvaluation:
        """The point, where known elements vanish and nothing that the goal divides by does."""
        key = tuple(need_point(point).values.items())
        if key not in at.places:
            at.places[key] = PointEvaluation(at, need_point(point))
        place: PointEvaluation = at.places[key]
        if place.point.values.keys() != {*all_names(at.setting)}:
            raise Unproved("the point leaves a value out, or has one too many")
        if not place.vanish(known):
            raise Unproved("the point is not where it should be")
        if not place.defines(self.accepted.divided[-1][1]):
            raise Unproved("something is divided by that vanishes at the point")
        self.accepted.places.append(place)
        return place


def _divisors(formulas: Iterable[Formula]) -> Iterator[Formula]:
    """What formulas divide by, as it stands there."""
    for formula in formulas:
        for node in formula.nodes():
            if isinstance(node, Quotient):
                yield node.denominator


def _check_groups(groups: Sequence[Sequence[Element]], setting: Setting) -> None:
    """Refuse a case that supposes nothing, and squares of what is not real."""
    if not all(groups):
        raise Unproved("there are cases, and each supposes something")
    if any(group[1:] for group in groups) and not is_real(setting):
        raise Unproved("sums of squares need real names")


def _difference(sides: Equation, at: Evaluation) -> Element:
    """What vanishes since both sides have one square, and neither is negative."""
    if not is_real(at.setting) or not all(is_not_negative(side, at.setting) for side in sides):
        raise Unproved("what has the same square may have another sign")
    left, right = map(at.scalar, sides)
    if not (left * left - right * right).is_zero:
        raise Unproved("the squares are not equal")
    return left - right


def is_not_negative(formula: Formula, setting: Setting) -> bool:
    """Whether a formula of real names is made of printed roots, even powers and numbers only."""
    match formula:
        case Number():
            return True
        case Name(name):
            return name.startswith(r"\sqrt") and name in setting.roots
        case Power(base, Number(exponent)):
            return exponent % 2 == 0 or is_not_negative(base, setting)
        case Sum() | Product() | Quotient():
            return all(is_not_negative(child, setting) for child in formula.children())
    return False


def law(goal: Simple, at: Evaluation, bound: Iterable[str] = ()) -> list[Element]:
    """The law of motion, for a goal that is about it: it speaks of where each element is defined.

    Names that are ``bound`` need have no value.
    """
    return at.law if moves(goal, {*at.bound, *bound}) else []


def need_point(point: Point | None) -> Point:
    """The point, if there is one; raises :class:`Vacuous`."""
    if point is None:
        raise Vacuous("no real point is known that satisfies the hypotheses")
    return point


def value_of(group: Sequence[Element]) -> Element:
    """What the checker makes of a group: its one element, or the sum of squares."""
    if len(group) == 1:
        return group[0]
    return reduce(add, (entry * entry for entry in group))


def is_real(setting: Setting) -> bool:
    """Whether all names of a setting are real: no conjugate pairs, no root of −1."""
    if setting.conjugates:
        return False
    return not any(_is_imaginary(setting, name) for name in setting.roots)


def _is_imaginary(setting: Setting, name: str) -> bool:
    step = setting.step(name)
    return isinstance(step, Adjoined) and step.square == Negative(Number(1))
