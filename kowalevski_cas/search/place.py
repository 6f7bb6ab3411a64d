"""Real points at which a problem is looked at."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import chain, combinations, count, islice
from operator import itemgetter
from typing import NamedTuple

from kowalevski_cas.algebra.numbers import Substitution, gaussian, is_negative, number_ring, root_in
from kowalevski_cas.algebra.points import ExactPoint
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Conjugate, Name, Negative, Number, Quotient
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Point
from kowalevski_cas.problem.place import Misplaced, Pieces, PointEvaluation, number_formula
from kowalevski_cas.problem.space import Adjoined, Meaningless, Setting, all_names
from kowalevski_cas.search.real import points_with_squares, real_points

Of = Callable[[Setting], Evaluation]
Good = Callable[["Candidate"], bool]

Place = tuple[ExactPoint, Mapping[str, Fraction]]
"""Rational coordinates, and the squares of the others."""

Values = Callable[[Element], Element]
"""What gives elements their values."""

TRIES = 60
"""How many points of one kind are looked at."""

ON_PIECES = 4
"""At how many of them all pieces are looked at."""


class Height(NamedTuple):
    """How far a point is from one that a reader would choose; no moment of inertia is negative."""

    roots: int
    negative_constants: int
    fractions: int
    largest: int


class Candidate:
    """An exact point, before anybody has checked it: the values of elements there.

    Roots that are ``negative`` there have the other one of two values; of the generators that are
    no rational numbers the ``squares`` are.
    """

    def __init__(
        self,
        at: Evaluation,
        point: ExactPoint,
        negative: Container[str] = (),
        squares: Mapping[str, Fraction] = {},  # it is only read
    ) -> None:
        self.at, self.squares = at, squares
        self.rational = [part for value in point.values() for part in value]
        self.is_whole = all(part.denominator == 1 for part in self.rational)
        self.numbers = number_ring(at.polynomials)
        values = {name: gaussian(self.numbers, *value) for name, value in point.items()}
        for name, square in squares.items():
            values[name] = root_in(self.numbers, self.numbers.number(square))
        self._value = Substitution(at.ring, values, self.numbers)
        for bit, (name, below) in enumerate(zip(at.ring.roots, at.ring.below, strict=True)):
            # The generator is the root times what it is over, which may be negative.
            turned = name.startswith(r"\sqrt") and below and is_negative(self._value(below))
            if name in negative or turned:
                self._value.roots[bit] = -self._value.roots[bit]

    def height(self) -> tuple[int, int]:
        """How many square roots are adjoined there, and the largest number of its coordinates."""
        parts = [n for value in self.rational for n in value.as_integer_ratio()]
        return len(self.numbers.roots), max(map(abs, parts), default=0)

    def __call__(self, element: Element) -> Element:
        """The value there; raises ``ZeroDivisionError`` on a zero of the denominator."""
        return self._value(element)

    def vanish(self, elements: Sequence[Element]) -> bool:
        """Whether all elements vanish there."""
        return all(self(element).is_zero for element in elements)

    def point(self, names: Sequence[str]) -> Point:
        """The point as evidence.

        Raises :class:`Misplaced` where a value cannot be written, or if nobody would accept it.
        """
        values = {name: number_formula(self(self.at.scalar(Name(name)))) for name in names}
        point = Point(values)
        PointEvaluation(self.at, point)
        return point


class PointFinder:
    """Points of the spaces of one problem.

    ``of`` evaluates spaces with FLINT.
    """

    def __init__(self, of: Of) -> None:
        self.of = of

    def point(
        self,
        at: Evaluation,
        zero: Sequence[Element] = (),
        divided: Sequence[Element] = (),
        good: Good = lambda candidate: True,
        most: int = 2,
        among: int | None = 1,
        squares: bool = True,
    ) -> Point | None:
        """The point of :meth:`simplest`."""
        found = self.simplest(at, zero, divided, good, most, among, squares)
        return found[1] if found else None

    def simplest(
        self,
        at: Evaluation,
        zero: Sequence[Element],
        divided: Sequence[Element],
        good: Good,
        most: int,
        among: int | None,
        squares: bool,
    ) -> tuple[Height, Point] | None:
        """How simple it is, and a real point: elements vanish, none is divided by 0, all is good.

        It is sought among points in general position, and if ``most`` is not 0 where all variables
        vanish, and then where some do, or all but some, as many as ``most``; and at last, if these
        may be ``squares``, among points at which variables are square roots. It is the simplest
        ``among`` the first of one kind that are good; without a number, the simplest are looked at
        first.
        """
        avoid = [*at.granted, *at.norms, *at.ring.divisors_of([*divided, *at.defined])]
        avoid += _below_law(at) if zero else []
        names = all_names(at.setting)
        norms = [self._norm(at, element) for element in (*zero, *_imaginary_parts(at, names))]
        rational: Iterator[Iterator[Place]] = (
            ((point, {}) for point in real_points(at, names, [*norms, *further], avoid))
            for further in self._sections(at, most)
        )
        irrational = [points_with_squares(at, names, norms, avoid)] if squares else []
        for kind in chain(rational, irrational):
            tried: Iterator[Candidate] = (
                Candidate(at, point, negative, squares)
                for point, squares in islice(kind, TRIES)
                for negative in _negative(at, point)
            )
            if among is None:
                tried = iter(sorted(tried, key=Candidate.height))
            found = islice(_points(tried, names, avoid, zero, good), among or 1)
            if simplest := min(found, key=itemgetter(0), default=None):
                return simplest
        return None

    def on_pieces(self, known: Sequence[Element], certain: Callable[[Values], bool]) -> Good:
        """What asks whether something is certain on each piece of the space over a candidate.

        If it is on none of the first few, it is on none.
        """
        tried = count()

        def good(candidate: Candidate) -> bool:
            at = candidate.at
            if not {*at.ring.roots} - {"i"}:
                return certain(candidate)
            if next(tried) >= ON_PIECES:
                return False
            return certain(
                Pieces(PointEvaluation(at, candidate.point(all_names(at.setting))), known)
            )

        return good

    def _sections(self, at: Evaluation, most: int) -> Iterator[Sequence[Element]]:
        """What vanishes besides: nothing, all variables, some, all but some, roots.

        Known powers are 1. A root is that of what is not negative: there is an edge.
        """
        setting = at.setting
        one = at.ring.one
        fixed: list[Element] = []
        for name in setting.powers:
            step = setting.step(name)
            base = getattr(step, "base", None)
            assert base is not None
            fixed += [at.ring.generator(name) - one, at.scalar(base) - one]
        variables = [at.ring.generator(name) for name in setting.variables]
        whole = len(variables)
        few = [0, whole, *range(1, most + 1), *range(whole - 1, max(whole - 1 - most, 0), -1)]
        for size in dict.fromkeys(few) if most else (0,):
            for chosen in combinations(variables, size):
                yield [*fixed, *chosen]
        squares = [
            square
            for name, square in zip(at.ring.roots, at.ring.radicands, strict=True)
            if name not in setting.coordinates and name != "i"
        ]
        yield from ([*fixed, one] for one in squares if most)
        if most and len(squares) > 1:
            yield [*fixed, *squares]

    @staticmethod
    def _norm(at: Evaluation, element: Element) -> Element:
        """The element times its conjugates by the roots that are no variables.

        A root that is a factor is left out instead, if another factor can vanish.
        """
        for bit, name in enumerate(element.ring.roots):
            inside = {mask >> bit & 1 for mask in element.parts}
            if name == "i" or name in at.setting.coordinates:
                continue
            if inside == {0, 1}:
                element = element * element.conjugate_root(bit)
            elif inside == {1}:
                parts = {mask ^ 1 << bit: part for mask, part in element.parts.items()}
                rest = Element(element.ring, parts, element.denominator)
                varies = any(map(element.ring.polynomials.occurring_places, parts.values()))
                element = rest if varies else element**2
        return element


def _below_law(at: Evaluation) -> list[Element]:
    """What its equations of motion divide by, if a space has any: there no motion is."""
    with suppress(Meaningless):
        return at.ring.divisors_of(at.law) if at.setting.field else []
    return []


def _points(
    tried: Iterable[Candidate],
    names: Sequence[str],
    avoid: Sequence[Element],
    zero: Sequence[Element],
    good: Good,
) -> Iterator[tuple[Height, Point]]:
    """Those candidates as points where elements vanish, nothing to avoid does, and all is good."""
    for candidate in tried:
        with suppress(ZeroDivisionError, Misplaced):
            if candidate.squares and any(candidate(element).is_zero for element in avoid):
                continue
            if candidate.vanish(zero) and good(candidate):
                point = candidate.point(names)
                yield _height(candidate, point), point


def _height(candidate: Candidate, point: Point) -> Height:
    constants = (point.values[name] for name in candidate.at.setting.constants)
    parts = [part for value in point.values.values() for part in value.nodes()]
    numbers = [part.value for part in parts if isinstance(part, Number)]
    return Height(
        len(candidate.numbers.roots),
        sum(isinstance(value, Negative) for value in constants),
        sum(isinstance(part, Quotient) for part in parts),
        max(numbers, default=0),
    )


def _negative(at: Evaluation, point: ExactPoint) -> Iterator[tuple[str, ...]]:
    """Which of the roots are negative that have a name, and no value yet; at first none."""
    free = [n for n in at.ring.roots if n != "i" and n not in point and not n.startswith(r"\sqrt")]
    return chain.from_iterable(combinations(free, size) for size in range(len(free) + 1))


def _imaginary_parts(at: Evaluation, names: Sequence[str]) -> Iterator[Element]:
    """What vanishes where roots without a declared conjugate are real: so are their squares."""
    paired = {name for pair in at.setting.conjugates for name in pair}
    for name in names:
        step = at.setting.step(name)
        if isinstance(step, Adjoined) and name not in paired and at.knows(Conjugate(step.square)):
            yield at.scalar(step.square) - at.scalar(step.square, True)
