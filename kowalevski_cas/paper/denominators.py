"""What a setting divides by, in irreducible factors, and the denominators that are printed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from contextlib import suppress
from functools import cached_property, reduce
from operator import mul
from typing import NamedTuple

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Power, Product, Quotient
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.problem.space import Meaningless


class Shape:
    """The numerator of an element up to a constant factor, in FLINT, as a key."""

    __slots__ = ("_hash", "_parts")

    def __init__(self, element: Element) -> None:
        parts = element.parts
        lead = parts[min(parts)].leading_coefficient() if parts else 1
        self._parts = {mask: part / lead for mask, part in parts.items()}
        # FLINT does not hash polynomials
        self._hash = hash(frozenset((mask, len(part)) for mask, part in parts.items()))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Shape) and self._parts == other._parts

    def __hash__(self) -> int:
        return self._hash


class Divisor(NamedTuple):
    """What is divided by, and the irreducible factors of that."""

    element: Element
    factors: dict[Shape, Element]

    def without(self, known: Set[Shape]) -> Divisor:
        """The product of the factors that are not known, each once."""
        new = {shape: exponent for shape, exponent in self.factors.items() if shape not in known}
        return Divisor(reduce(mul, new.values(), self.element.ring.one), new)


class Divisors:
    """What elements of a setting are divided by, in FLINT; every polynomial is factored once."""

    def __init__(self, setting: Meaning) -> None:
        self.setting = setting
        self._left: dict[int, Divisor] = {}

    @cached_property
    def granted(self) -> set[Shape]:
        """The factors of what is taken for granted not to vanish."""
        return granted_factors(map(self.setting.finder.scalar, self.setting.nonzero))

    @cached_property
    def landmarks(self) -> dict[object, Formula]:
        """The conditions of the declared loci as they are printed, by their shapes."""
        setting = self.setting
        printed = [setting.texts.expression(locus.condition) for locus in setting.scene.loci]
        return {Shape(setting.finder.scalar(setting.plain(f))): f for f in printed}

    @cached_property
    def printed(self) -> dict[Formula, Divisor]:
        """The denominators in all definitions of the scene that have a value by themselves."""
        texts, found = self.setting.texts, list[Formula]()
        for place in self.setting.scene.definitions.values():
            with suppress(Meaningless):  # of a logarithm only the derivative has one
                found.append(self.setting.plain(texts.formula(place)))
        return self.below(found)

    def below(self, formulas: Iterable[Formula]) -> dict[Formula, Divisor]:
        """The factors of all denominators in formulas that mean something in the setting."""
        found = {}
        for formula in _below(formulas):
            with suppress(Meaningless, ZeroDivisionError):
                element = self.setting.finder.scalar(formula)
                cancelled = _common_factors(element)
                factors = factors_below(element.inverse()).items()
                left = {shape: exponent for shape, exponent in factors if shape not in cancelled}
                found[formula] = Divisor(element, left)
        return found

    def left(self, index: int) -> Divisor:
        """What may vanish of the divisor with this index in the ring; without a factor, nothing."""
        if index not in self._left:
            ring = self.setting.finder.ring
            element = Element(ring, {0: ring.divisors[index]}, {})
            self._left[index] = Divisor(element, factors_of(element)).without(self.granted)
        return self._left[index]


def _below(formulas: Iterable[Formula]) -> Iterator[Formula]:
    waiting = [*formulas]
    while waiting:
        formula = waiting.pop()
        waiting += formula.children()
        if isinstance(formula, Quotient):
            below = formula.denominator
            for factor in below.factors if isinstance(below, Product) else (below,):
                yield factor.base if isinstance(factor, Power) else factor


def granted_factors(elements: Iterable[Element]) -> set[Shape]:
    """The irreducible polynomials that vanish nowhere but where one of the elements does."""
    from kowalevski_cas.algebra.factors import vanishes_with

    return {
        shape
        for element in elements
        for shape, factor in factors_below(element.inverse()).items()
        if vanishes_with(element, factor)
    }


def factors_below(element: Element) -> dict[Shape, Element]:
    """The irreducible factors of what an element is divided by."""
    found = map(factors_of, element.ring.divisors_of([element]))
    return {shape: factor for factors in found for shape, factor in factors.items()}


def _common_factors(element: Element) -> set[Shape]:
    """The factors of a numerator that its denominator has as often: it vanishes not by them."""
    counts: dict[Shape, int] = {}
    ring = element.ring
    if len(element.parts) > 1:
        return set()
    (above,) = element.parts.values()
    below = [(ring.divisors[index], -exponent) for index, exponent in element.denominator.items()]
    for polynomial, sign in ((above, 1), *below):
        for factor, exponent in polynomial.factor()[1]:
            shape = Shape(Element(ring, {0: factor}, {}))
            counts[shape] = counts.get(shape, 0) + sign * exponent
    return {shape for shape, count in counts.items() if count <= 0}


def factors_of(element: Element) -> dict[Shape, Element]:
    """The irreducible factors of a numerator without roots, in FLINT."""
    factors = (Element(element.ring, {0: factor}, {}) for factor, _ in element.parts[0].factor()[1])
    return {Shape(factor): factor for factor in factors}
