r"""Complex balls: rigorous when they refute, and never a proof of equality.

A residual is enclosed by a ball that certainly contains its value. A ball without
zero refutes. A ball with zero says nothing more than its radius, so the precision
is raised until a ball decides or the last precision is reached.

Points are exact Gaussian rationals. Where equations are given, some coordinates are
balls that contain exactly one solution, by the interval method of Newton
(R. E. Moore, 1966): :math:`m-J(U)^{-1}F(m)` lies inside U.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from random import Random
from typing import Any

from flint import acb, acb_mat, arb, ctx

from kowalevski_cas.algebra.derivation import along
from kowalevski_cas.algebra.flint import to_flint
from kowalevski_cas.algebra.points import Answer, ExactPoint, NoPoint, Points, Question
from kowalevski_cas.algebra.programs import Program, Programs
from kowalevski_cas.algebra.residue_points import plan
from kowalevski_cas.algebra.valuation import Valuation

PRECISIONS = (64, 128, 256, 512)
"""Bits, in the order in which they are tried."""

POINTS = 3
"""How many points are taken."""

TRIES = 30
"""How many points are looked at for those at which nothing is divided by zero."""

STEPS = 60
"""How many steps of Newton's method lead to a set."""

GRID = 64
"""The denominator of coordinates that are chosen at random, between -4 and 4."""


class Arithmetic(Points):
    """Balls by FLINT's ``acb``."""

    name = "ball"

    def answer(self, question: Question) -> Answer:
        """No at the first ball without zero; yes, with the largest radius, if there is none."""
        found, radius, bits = 0, 0.0, 0
        random = Random(self.seed)
        try:
            system = NewtonSystem(question.ring, question.given)
        except NoPoint as error:
            return Answer(None, str(error))
        for _ in range(TRIES):
            start = random_point(question.ring.generators, random)
            answer, used = _at(question, system, start)
            if answer is None:
                continue
            if not answer.holds:
                return answer
            found, radius, bits = found + 1, max(radius, answer.radius or 0.0), max(bits, used)
            if found == POINTS:
                break
        if not found:
            return Answer(
                None, "no point was found at which everything is defined and balls decide"
            )
        words = f"{found} points, {bits} bits, seed {self.seed}"
        return Answer(True, words, radius=radius)


class NewtonSystem:
    """Equations that some generators are to be solved for, with their partial derivatives."""

    def __init__(self, ring: Programs, equations: Sequence[Program]) -> None:
        self.ring = ring
        self.equations = list(equations)
        self.unknowns = [name for _, names in plan(tuple(equations)) for name in names]
        self.slopes: list[list[Any]] = [
            [along(equation, {name: ring.one}) for name in self.unknowns] for equation in equations
        ]

    def solve(self, values: Mapping[str, acb]) -> dict[str, acb]:
        """The values, with balls for the unknowns, each around exactly one solution.

        Raises ``ZeroDivisionError`` where Newton's method does not lead to one.
        """
        if not self.unknowns:
            return dict(values)
        found = dict(values)
        for _ in range(STEPS):
            step = self._step(found, found)
            for name, change in zip(self.unknowns, step, strict=True):
                found[name] = (found[name] - change).mid()
            if max(float(change.abs_upper()) for change in step) < 2.0 ** (8 - ctx.prec):
                break
        # Newton's method doubles the digits: from a box of half of them it leads well inside
        width = arb(0, arb(2) ** (-ctx.prec // 2))
        box = found | {name: found[name] + acb(width, width) for name in self.unknowns}
        step = self._step(found, box)
        for name, change in zip(self.unknowns, step, strict=True):
            found[name] = found[name] - change
            if not box[name].contains_interior(found[name]):
                raise ZeroDivisionError("no solution is enclosed")
        return found

    def _step(self, middle: Mapping[str, acb], box: Mapping[str, acb]) -> list[acb]:
        """The quotient of the equations at the middle by the derivatives in the box."""
        at, around = ball_point(self.ring, middle), ball_point(self.ring, box)
        matrix = acb_mat([[around(slope) for slope in row] for row in self.slopes])
        step = matrix.solve(acb_mat([[at(equation)] for equation in self.equations]))
        if not all(step[k, 0].is_finite() for k in range(len(self.unknowns))):
            raise ZeroDivisionError("division by zero")
        return [step[k, 0] for k in range(len(self.unknowns))]


def _at(question: Question, system: NewtonSystem, start: ExactPoint) -> tuple[Answer | None, int]:
    """What one point says, and with how many bits; ``None`` if something is undefined there."""
    answer: Answer | None = None
    unknown: dict[str, acb] = {}
    for bits in PRECISIONS:
        with ctx.workprec(bits):
            values = exact_balls(start) | unknown
            try:
                values = system.solve(values)
            except ZeroDivisionError:
                return None, bits
            unknown = {name: values[name].mid() for name in system.unknowns}
            point = ball_point(question.ring, values)
            answer = _residuals(question, point) if question.residuals else None
            answer = answer or _rest(question, point)
        if answer is not None and (not answer.holds or not question.residuals):
            break
    return answer, bits


def random_point(names: Iterable[str], random: Random) -> ExactPoint:
    """Random Gaussian rationals on a grid."""

    def coordinate() -> Fraction:
        return Fraction(random.randint(-4 * GRID, 4 * GRID), GRID)

    return {name: (coordinate(), coordinate()) for name in names}


def number(value: Fraction) -> acb:
    """A rational number as a ball."""
    return acb(arb(to_flint(value)))


def exact_balls(exact: ExactPoint) -> dict[str, acb]:
    """The coordinates of an exact point, in the precision that is set."""
    unit = acb(0, 1)
    return {name: number(re) + number(im) * unit for name, (re, im) in exact.items()}


def ball_point(ring: Programs, values: Mapping[str, acb]) -> Valuation:
    """The valuation at a point; roots that have no value are taken as their main values."""
    generators = {name: values[name] for name in ring.generators}

    def choose(name: str, square: acb) -> acb:
        return values[name] if name in values else square_root(square)

    return Valuation(number, generators, choose)


def square_root(value: acb) -> acb:
    """A square root, with the branch cut turned away from the value."""
    return value.sqrt() if value.real.mid() >= 0 else acb(0, 1) * (-value).sqrt()


def _residuals(question: Question, point: Valuation) -> Answer | None:
    """What the balls around the residuals say; ``None`` if they are not finite."""
    balls = [point(program) for program in question.residuals]
    if not all(ball.is_finite() for ball in balls):
        return None
    for ball in balls:
        if not ball.contains(0):
            return _no(question, point, ball.str(8), "0", "left minus right side")
    return Answer(True, radius=max(float(ball.rad()) for ball in balls))


def _rest(question: Question, point: Valuation) -> Answer | None:
    """What is said of something that has to move, or of a rank; ``None`` if it is not clear."""
    if question.somewhere:
        values = [point(program) for program in question.somewhere]
        away = [value for value in values if value.is_finite() and not value.contains(0)]
        return Answer(True, radius=float(away[0].rad())) if away else None
    if not question.rows:
        return None
    rows = [[point(entry) for entry in row] for row in question.rows]
    found, radius = rank(rows)
    if found > question.rank or question.rank > min(len(rows), len(rows[0])):
        words = "the rank there is at least this, and the one claimed"
        return _no(question, point, str(found), str(question.rank), words)
    return Answer(True, radius=radius) if found == question.rank else None


def rank(rows: list[list[acb]]) -> tuple[int, float]:
    """The rank that balls without zero guarantee, and the largest radius that was met."""
    rows, found, radius = [list(row) for row in rows], 0, 0.0
    while rows:
        radius = max(radius, *(float(entry.rad()) for row in rows for entry in row))
        sure = [
            (float(entry.abs_lower()), k, column)
            for k, row in enumerate(rows)
            for column, entry in enumerate(row)
            if entry.is_finite() and not entry.contains(0)
        ]
        if not sure:
            break
        found += 1
        _, k, column = max(sure)
        pivot = rows.pop(k)
        factors = [row[column] / pivot[column] for row in rows]
        rows = [
            [
                a - f * b if j != column else acb(0)
                for j, (a, b) in enumerate(zip(row, pivot, strict=True))
            ]
            for f, row in zip(factors, rows, strict=True)
        ]
    return found, radius


def _no(question: Question, point: Valuation, left: str, right: str, words: str) -> Answer:
    found = point.coordinates(question.ring)
    values = {name: value.str(8, radius=False) for name, value in found.items()}
    return Answer(
        False, f"{words}, in balls of {ctx.prec} bits", point=values, left=left, right=right
    )
