"""Statements that are false by construction: at a point that was chosen first.

Each is built around a point with small coordinates, in plain integers; nothing of the package
takes part in it.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from random import Random

NAMES = ("x", "y", "z")
Point = dict[str, int]
Powers = tuple[int, ...]


class Polynomial(dict[Powers, int]):
    """Whole coefficients by the exponents of x, y and z."""

    def __call__(self, point: Point) -> int:
        total = 0
        for powers, coefficient in self.items():
            for name, power in zip(NAMES, powers, strict=True):
                coefficient *= point[name] ** power
            total += coefficient
        return total

    def __add__(self, other: "Polynomial | int") -> "Polynomial":
        more = other if isinstance(other, Polynomial) else Polynomial({(0, 0, 0): other})
        keys = {*self, *more}
        return Polynomial({k: v for k in keys if (v := self.get(k, 0) + more.get(k, 0))})

    def __mul__(self, other: "Polynomial | int") -> "Polynomial":
        more = other if isinstance(other, Polynomial) else Polynomial({(0, 0, 0): other})
        total = Polynomial()
        for a, left in self.items():
            for b, right in more.items():
                powers = tuple(i + j for i, j in zip(a, b, strict=True))
                total += Polynomial({powers: left * right})
        return total

    def partial(self, index: int) -> "Polynomial":
        """The derivative by a variable."""
        found = Polynomial()
        for powers, coefficient in self.items():
            if powers[index]:
                lower = tuple(p - (k == index) for k, p in enumerate(powers))
                found += Polynomial({lower: coefficient * powers[index]})
        return found

    @property
    def tex(self) -> str:
        terms = []
        for powers, coefficient in sorted(self.items(), reverse=True):
            letters = "".join(f"{n}^{p}" for n, p in zip(NAMES, powers, strict=True) if p)
            terms.append(f"{coefficient:+d}{letters}")
        return "".join(terms).removeprefix("+") or "0"


@dataclass(frozen=True)
class Falsehood:
    """A statement, and the point at which it fails; none if no point satisfies its hypotheses.

    ``about`` names the claim as in :mod:`tests.laws.systems`.
    """

    about: str
    tex: tuple[str, ...]
    motion: tuple[str, ...] = (r"\dot x=0", r"\dot y=0", r"\dot z=0")
    given: tuple[str, ...] = ()
    nonzero: tuple[str, ...] = ()
    root: str = ""
    number: int = 0
    point: Point | None = field(default=None)


class Maker:
    """Falsehoods, the same ones for the same seed."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)

    def point(self) -> Point:
        return {name: self.random.randint(-2, 2) for name in NAMES}

    def polynomial(self, terms: int = 3, degree: int = 2) -> Polynomial:
        """A polynomial that is not constant."""
        while True:
            found = Polynomial()
            for _ in range(self.random.randint(1, terms)):
                powers = [0, 0, 0]
                for _ in range(self.random.randint(0, degree)):
                    powers[self.random.randrange(3)] += 1
                found += Polynomial({tuple(powers): self.random.choice((-3, -2, -1, 1, 2, 3))})
            if any(map(any, found)):
                return found

    def zero_at(self, point: Point) -> Polynomial:
        found = self.polynomial()
        return found + -found(point)

    def not_zero_at(self, point: Point) -> Polynomial:
        found = self.polynomial()
        return found if found(point) else found + self.random.choice((-1, 1))

    def motion(self) -> list[Polynomial]:
        return [self.polynomial() for _ in NAMES]

    # -- kinds of falsehoods ----------------------------------------------------------

    def identity(self) -> Falsehood:
        point = self.point()
        left, more = self.polynomial(), self.not_zero_at(point)
        return Falsehood("identity", (f"{left.tex}={(left + more).tex}",), point=point)

    def implication(self) -> Falsehood:
        """What nearly follows: a combination of what is given, and something besides."""
        point = self.point()
        given = [self.zero_at(point) for _ in range(self.random.randint(1, 2))]
        stated = self.not_zero_at(point)
        for one in given:
            stated += one * self.polynomial(2, 1)
        return Falsehood(
            "implication", (f"{stated.tex}=0",), given=tuple(f"{g.tex}=0" for g in given),
            point=point,
        )  # fmt: skip

    def factor(self) -> Falsehood:
        """One factor of what is given, at a point where the other one vanishes."""
        point = self.point()
        stated, other = self.not_zero_at(point), self.zero_at(point)
        return Falsehood(
            "implication", (f"{stated.tex}=0",), given=(f"{(stated * other).tex}=0",), point=point
        )

    def integral(self) -> Falsehood:
        while True:
            point, motion, stated = self.point(), self.motion(), self.polynomial()
            if _rate(stated, motion)(point):
                return Falsehood("integral", (stated.tex,), _moves(motion), point=point)

    def integral_on_a_set(self) -> Falsehood:
        while True:
            point, motion, stated = self.point(), self.motion(), self.polynomial()
            given = self.zero_at(point)
            if _rate(stated, motion)(point):
                return Falsehood(
                    "integral", (stated.tex,), _moves(motion), (f"{given.tex}=0",), point=point
                )

    def invariant(self) -> Falsehood:
        while True:
            point, motion = self.point(), self.motion()
            stated = [self.zero_at(point) for _ in range(self.random.randint(1, 2))]
            if any(_rate(one, motion)(point) for one in stated):
                tex = tuple(f"{one.tex}=0" for one in stated)
                return Falsehood("invariant", tex, _moves(motion), point=point)

    def nothing_given(self) -> Falsehood:
        """No real point satisfies what is given."""
        one, other = self.polynomial(2), self.polynomial(2)
        squares = one * one + other * other + self.random.randint(1, 3)
        given = self.random.choice(
            [
                (f"{squares.tex}=0",),
                (f"{one.tex}=0", f"{(one * other + 1).tex}=0"),
                (f"{one.tex}=0", f"{(one + 1).tex}=0"),
            ]
        )
        return Falsehood("implication", (f"{self.polynomial().tex}=0",), given=given)

    def excluded(self) -> Falsehood:
        """What is given says that something vanishes that is taken for granted not to."""
        one = self.polynomial(2)
        given = self.random.choice((one, one * self.random.choice((-2, 3)), one * one))
        stated = self.random.choice((one, one * self.polynomial(2), self.polynomial()))
        return Falsehood(
            "implication", (f"{stated.tex}=0",), given=(f"{given.tex}=0",), nonzero=(one.tex,)
        )

    def dimension(self) -> Falsehood:
        """A set that is smooth at the point, with another dimension than it has there."""
        while True:
            point = self.point()
            stated = [self.zero_at(point) for _ in range(self.random.randint(1, 2))]
            rows = [[one.partial(k)(point) for k in range(3)] for one in stated]
            if _rank(rows) == len(rows):
                right = 3 - len(rows)
                number = self.random.choice([n for n in (0, 1, 2, 3) if n != right])
                tex = tuple(f"{one.tex}=0" for one in stated)
                return Falsehood("dimension", tex, number=number, point=point)

    def dependent(self) -> Falsehood:
        """A function and a function of it."""
        one = self.polynomial()
        other = self.random.choice((one * one, one * 2 + 1, one * one + one * -3))
        return Falsehood("independence", (f"h={one.tex}", f"g={other.tex}"))

    def branch(self) -> Falsehood:
        """One of the two roots of a square."""
        point = self.point()
        one = self.not_zero_at(point)
        return Falsehood("identity", (f"r={one.tex}",), root=f"r^2={(one * one).tex}", point=point)


KINDS: tuple[Callable[[Maker], Falsehood], ...] = (
    Maker.identity, Maker.implication, Maker.factor, Maker.integral, Maker.integral_on_a_set,
    Maker.invariant, Maker.nothing_given, Maker.excluded, Maker.dimension, Maker.dependent,
    Maker.branch,
)  # fmt: skip


def _moves(motion: list[Polynomial]) -> tuple[str, ...]:
    return tuple(rf"\dot {name}={rate.tex}" for name, rate in zip(NAMES, motion, strict=True))


def _rate(function: Polynomial, motion: list[Polynomial]) -> Polynomial:
    total = Polynomial()
    for index, rate in enumerate(motion):
        total += function.partial(index) * rate
    return total


def _rank(rows: list[list[int]]) -> int:
    left = [[Fraction(entry) for entry in row] for row in rows]
    rank = 0
    for column in range(len(rows[0])):
        pivot = next((row for row in left if row[column]), None)
        if pivot is None:
            continue
        rank += 1
        left = [
            [a - row[column] / pivot[column] * b for a, b in zip(row, pivot, strict=True)]
            for row in left
            if row is not pivot
        ]
    return rank
