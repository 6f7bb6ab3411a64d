"""Points: whether they are real points of a space, and the values that elements take there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache, reduce
from itertools import combinations
from math import gcd, isqrt
from operator import or_

from kowalevski_cas.algebra.numbers import Substitution, is_negative, rational
from kowalevski_cas.algebra.polynomials import Polynomials
from kowalevski_cas.algebra.present import multiple
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    total,
)
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Point
from kowalevski_cas.problem.space import Adjoined, Raised, Space, Step

MINUS_ONE = Negative(Number(1))
NUMERIC = (Number, Name, Negative, Sum, Product, Quotient, Power)
UNIT = 0
"""The place of i among the roots of the numbers."""


class Misplaced(ValueError):
    """A point that is not where it should be; the message says why."""


class PointEvaluation:
    """A point in a space: calling it gives the value of an element there.

    Names that the point does not mention do not stand in the statement. Raises
    :class:`Misplaced` if the point does not obey the relations of the space, or is not real;
    so does calling it with an element in which another name stands.
    """

    def __init__(self, at: Evaluation, point: Point) -> None:
        self.at, self.point = at, point
        squares = {number for value in point.values.values() for number in _squares(value)}
        self.squares = tuple(sorted(squares))
        self.numbers = _numbers(at.polynomials, self.squares)
        given = {name: self.numbers.scalar(value) for name, value in point.values.items()}
        zero = self.numbers.ring.zero
        generators = {name: given.get(name, zero) for name in at.ring.polynomials.generators}
        self._value = Substitution(at.ring, generators, self.numbers.ring, roots={})
        self._unknown = {k for k, name in enumerate(generators) if name not in given}
        self._unknown_roots = sum(1 << k for k, n in enumerate(at.ring.roots) if n not in given)
        for bit, name in enumerate(at.ring.roots):
            below = at.ring.below[bit]
            if name in given:
                self._value.roots[bit] = given[name] if below is None else given[name] * self(below)
        self._vanishing = dict[int, bool]()
        self._check(given)

    def __call__(self, element: Element) -> Element:
        """The value there; raises ``ZeroDivisionError`` on a zero of the denominator."""
        if not self.knows(element):
            raise Misplaced("the point leaves a value out")
        return self._value(element)

    def knows(self, element: Element) -> bool:
        """Whether the point gives values to all that stands in an element."""
        ring = element.ring
        above = [part for parts, _ in element.summands for part in parts.items()]
        if any(mask & self._unknown_roots for mask, _ in above):
            return False
        if not self._unknown:
            return True
        polynomials = [p for _, p in above]
        polynomials += [ring.divisors[index] for index in element.denominator]
        occurring = map(ring.polynomials.occurring_places, polynomials)
        return all(map(self._unknown.isdisjoint, occurring))

    def vanish(self, elements: Sequence[Element]) -> bool:
        """Whether all elements are defined and vanish there."""
        try:
            return all(self(element).is_zero for element in elements)
        except ZeroDivisionError:
            return False

    def defines(self, elements: Sequence[Element]) -> bool:
        """Whether nothing by which the elements are divided vanishes there."""
        divisors = {index for element in elements for index in element.denominator}
        return not any(map(self._vanishes, divisors))

    def _vanishes(self, index: int) -> bool:
        """Whether a divisor of the ring is zero there."""
        if index not in self._vanishing:
            divisor = Element(self.at.ring, {0: self.at.ring.divisors[index]}, {})
            self._vanishing[index] = self(divisor).is_zero
        return self._vanishing[index]

    def _check(self, given: Mapping[str, Element]) -> None:
        at, setting = self.at, self.at.setting
        partner = {one: other for pair in setting.conjugates for one, other in (pair, pair[::-1])}
        for name, value in given.items():
            step = setting.step(name)
            self._check_step(step, value)
            if isinstance(step, Adjoined) and step.square == MINUS_ONE:
                continue
            bar = given.get(partner.get(name, name))
            if bar is None or not (value.conjugate_root(UNIT) - bar).is_zero:
                raise Misplaced(f"{name} is not real there")
            if name.startswith(r"\sqrt") and name not in partner and is_negative(value):
                raise Misplaced(f"{name} is negative there")
        for element in (*at.granted, *at.norms):
            if self.knows(element) and self(element).is_zero:
                raise Misplaced("what is taken for granted not to vanish does")
        if not self.defines([element for element in at.defined if self.knows(element)]):
            raise Misplaced("what a name stands for is not defined there")

    def _check_step(self, step: Step | None, value: Element) -> None:
        """Check that a root, or a power, is one there."""
        if isinstance(step, Adjoined):
            if not (value * value - self(self.at.roots[step.name])).is_zero:
                raise Misplaced(f"{step.name} is not a root there")
        elif isinstance(step, Raised):
            one = self.numbers.ring.one
            if not (value - one).is_zero or not (self(self.at.scalar(step.base)) - one).is_zero:
                raise Misplaced(f"the value of {step.name} is not known there")


class Pieces:
    """The values of elements at a point, with the roots open that do not stand in what is known.

    On each piece of the space there is a point with the same values of all else, where each root
    has one of its signs. So an element whose value has an inverse is zero on none of them.
    """

    def __init__(self, place: PointEvaluation, known: Sequence[Element]) -> None:
        at, values = place.at, place.point.values
        self.place = place
        numbers = _numbers.__wrapped__(at.polynomials, place.squares)
        given = {name: numbers.scalar(value) for name, value in values.items()}
        generators = {n: given.get(n, numbers.ring.zero) for n in at.ring.polynomials.generators}
        self._value = Substitution(at.ring, generators, numbers.ring, roots={})
        fixed = self._fixed_roots([*known, *self._bases()])
        for bit, name in enumerate(at.ring.roots):
            if name not in given:
                continue
            square, below = self._value(at.ring.radicands[bit]), at.ring.below[bit]
            if fixed >> bit & 1 or square.is_zero or rational(square) == -1:
                root = given[name] if below is None else given[name] * self._value(below)
            else:
                root = numbers.ring.adjoin(f":{name}", square)
            self._value.roots[bit] = root

    def __call__(self, element: Element) -> Element:
        """The value, in which each open root stands for either value."""
        if not self.place.knows(element):
            raise Misplaced("the point leaves a value out")
        return self._value(element)

    def _bases(self) -> Iterator[Element]:
        """The bases of powers, which are 1 at the point."""
        at = self.place.at
        for name in at.setting.powers:
            step = at.setting.step(name)
            if isinstance(step, Raised) and name in self.place.point.values:
                yield at.scalar(step.base)

    def _fixed_roots(self, known: Sequence[Element]) -> int:
        """The roots in elements, and in the squares of such roots."""
        ring = self.place.at.ring
        fixed = reduce(or_, (mask for element in known for mask in element.parts), 0)
        for bit in reversed(range(len(ring.roots))):
            if fixed >> bit & 1:
                fixed = reduce(or_, ring.radicands[bit].parts, fixed)
        return fixed


@cache
def _numbers(arithmetic: type[Polynomials], squares: tuple[int, ...]) -> Evaluation:
    """The numbers in which points have their values: rationals, i, and roots of whole numbers."""
    if any(gcd(*pair) > 1 for pair in combinations(squares, 2)) or any(
        isqrt(n) ** 2 == n for n in squares
    ):
        raise Misplaced("roots at a point may depend on each other")
    steps = [Adjoined("i", MINUS_ONE)]
    steps += [Adjoined(rf"\sqrt{{{number}}}", Number(number)) for number in squares]
    space = Space(variables=(), constants=("",), steps=tuple(steps))
    return Evaluation(space, arithmetic).adjoin_roots()


def _squares(formula: Formula) -> set[int]:
    if isinstance(formula, Root):
        if not isinstance(formula.argument, Number) or formula.argument.value < 2:
            raise Misplaced("a root at a point is no root of a whole number")
        return {formula.argument.value}
    if not isinstance(formula, NUMERIC):
        raise Misplaced("a value at the point is no number")
    return {number for child in formula.children() for number in _squares(child)}


def number_formula(number: Element) -> Formula:
    """A number of a tower of roots over the rationals as a formula.

    Raises :class:`Misplaced` for a root of a root, or of a negative number.
    """
    ring = number.ring
    terms: list[Formula] = []
    for mask, part in number.terms().items():
        for value in part.values():
            factors: list[Formula] = []
            for bit, name in enumerate(ring.roots):
                if mask >> bit & 1:
                    factors.append(_root(name, ring.radicands[bit]))
            terms.append(multiple(value, factors))
    return total(terms)


def _root(name: str, radicand: Element) -> Formula:
    if name == "i":
        return Name("i")
    terms = radicand.terms()
    if set(terms) != {0}:
        raise Misplaced("a value at the point is a root of a root")
    (value,) = terms[0].values()
    whole = value.numerator * value.denominator
    if whole < 0:
        raise Misplaced("a value at the point is an imaginary root")
    root: Formula = Root(Number(whole))
    return root if value.denominator == 1 else Quotient(root, Number(value.denominator))
