r"""Floating point: many points at once in NumPy's arrays, fast, and not to be trusted.

Beside each value goes the size of what it was computed from (running error analysis,
J. H. Wilkinson, 1963): a residual counts as zero where it is small against that. No
bound comes with the answer, for a term that is too small to be seen is not seen.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from kowalevski_cas.algebra.derivation import along
from kowalevski_cas.algebra.points import Answer, NoPoint, Points, Question
from kowalevski_cas.algebra.programs import Program, Programs
from kowalevski_cas.algebra.residue_points import plan
from kowalevski_cas.algebra.valuation import Valuation

POINTS = 64
"""How many points are taken at random."""

STEPS = 40
"""How many steps of Newton's method lead to a set."""

TOLERANCE = 2.0**-36
"""A residual below this part of its size counts as zero: 16 of the 52 bits may be lost."""

Array = Any
"""An array of complex numbers, or of real ones, a point each."""


class Rounded:
    """Values at many points, with the sizes of what they were computed from."""

    __slots__ = ("size", "value")
    # so an array on the left leaves the operation to this class, and does not run over it
    __array_ufunc__ = None

    def __init__(self, value: Array, size: Array) -> None:
        self.value = value
        self.size = size

    def __add__(self, other: Rounded) -> Rounded:
        if not isinstance(other, Rounded):
            return NotImplemented
        return Rounded(self.value + other.value, self.size + other.size)

    def __mul__(self, other: Rounded | int) -> Rounded:
        if isinstance(other, Rounded):
            return Rounded(self.value * other.value, self.size * other.size)
        if not isinstance(other, int):
            return NotImplemented
        return Rounded(self.value * other, self.size * abs(other))

    __rmul__ = __mul__

    def __rtruediv__(self, other: int) -> Rounded:
        value = other / self.value
        return Rounded(value, self.size * abs(value / self.value))

    def root(self, signs: Array) -> Rounded:
        """A square root at each point, of this sign."""
        value = signs * np.sqrt(self.value)
        return Rounded(value, np.abs(value) + self.size / np.abs(value))


class Arithmetic(Points):
    """Complex numbers of NumPy in double precision."""

    name = "floating"

    def answer(self, question: Question) -> Answer:
        """Whether the residuals are small at all points at which they are finite."""
        with np.errstate(all="ignore"):
            try:
                point = self.point(question)
                return (
                    self._rank(question, point) if question.rows else self._small(question, point)
                )
            except (NoPoint, ArithmeticError, np.linalg.LinAlgError) as error:
                return Answer(None, f"in floating point: {error}")

    def point(self, question: Question) -> Valuation:
        """Random points, moved by Newton's method to where the given equations hold."""
        random = np.random.default_rng(self.seed)
        ring = question.ring
        shape = (len(ring.generators), POINTS)
        numbers = random.normal(size=shape) + 1j * random.normal(size=shape)
        signs = {name: random.choice((-1.0, 1.0), size=POINTS) for name in ring.roots}
        values = dict(zip(ring.generators, numbers, strict=True))
        if question.given:
            values = newton(ring, question.given, values, signs)
        return at(values, signs)

    def _small(self, question: Question, point: Valuation) -> Answer:
        programs = question.residuals or question.somewhere
        ratios = np.array([np.broadcast_to(ratio(point(p)), POINTS) for p in programs])
        finite = np.isfinite(ratios).all(axis=0)
        if not finite.any():
            return Answer(None, "in floating point nothing is finite at any point")
        worst = ratios[:, finite].max()
        words = f"{worst:.0e} of the size of the terms at {finite.sum()} points, seed {self.seed}"
        if question.somewhere:
            return Answer(bool(worst > TOLERANCE), words)
        if worst <= TOLERANCE:
            return Answer(True, words)
        known = np.where(finite, ratios, 0)
        which, where = map(int, np.unravel_index(known.argmax(), known.shape))
        words = "left minus right side, in floating point, which is not to be trusted"
        left = _text(point(programs[which]), where)
        coordinates = _coordinates(question, point, where)
        return Answer(False, words, point=coordinates, left=left)

    def _rank(self, question: Question, point: Valuation) -> Answer:
        """The rank by singular values, the largest one at any of the points."""
        rows = [[np.broadcast_to(point(e).value, POINTS) for e in row] for row in question.rows]
        matrices = np.moveaxis(np.array(rows), 2, 0)
        finite = np.isfinite(matrices).all(axis=(1, 2))
        if not finite.any():
            return Answer(None, "in floating point nothing is finite at any point")
        ranks = np.linalg.matrix_rank(matrices[finite])
        found = int(ranks.max())
        where = int(np.flatnonzero(finite)[ranks.argmax()])
        words = f"by singular values at {finite.sum()} points, seed {self.seed}"
        return Answer(
            found == question.rank,
            words,
            point=_coordinates(question, point, where),
            left=str(found),
            right=str(question.rank),
        )


def at(values: Mapping[str, Array], signs: Mapping[str, Array]) -> Valuation:
    """The valuation at many points, with the roots of these signs."""
    generators = {name: Rounded(value, np.abs(value)) for name, value in values.items()}
    return Valuation(number, generators, lambda name, square: square.root(signs[name]))


def newton(
    ring: Programs,
    equations: Sequence[Program],
    values: Mapping[str, Array],
    signs: Mapping[str, Array],
) -> dict[str, Array]:
    """Values at which the equations hold; not a number where they were not reached."""
    unknowns = [name for _, names in plan(tuple(equations)) for name in names]
    slopes: list[list[Any]] = [[along(e, {name: ring.one}) for name in unknowns] for e in equations]
    found = dict(values)
    for _ in range(STEPS):
        point = at(found, signs)
        left = _stack([point(equation) for equation in equations])
        matrix = np.array([_stack([point(slope) for slope in row]) for row in slopes])
        matrix = np.nan_to_num(np.moveaxis(matrix, 2, 0), posinf=1.0, neginf=1.0)
        # a column each: NumPy 2 takes an array of two dimensions for one matrix of right sides
        step = np.linalg.solve(matrix, np.moveaxis(left, 1, 0)[:, :, None])[:, :, 0]
        for k, name in enumerate(unknowns):
            found[name] = found[name] - step[:, k]
    point = at(found, signs)
    ratios = np.array([np.broadcast_to(ratio(point(e)), POINTS) for e in equations])
    reached = ratios.max(axis=0) < TOLERANCE
    if not reached.any():
        raise NoPoint(f"no point of the set was reached in {STEPS} steps")
    return {name: np.where(reached, value, np.nan) for name, value in found.items()}


def _stack(values: Sequence[Rounded]) -> Array:
    return np.array([np.broadcast_to(value.value, POINTS) for value in values])


def number(value: Fraction) -> Rounded:
    """A rational number, the same at all points; raises ``OverflowError`` for large ones."""
    rounded = float(value)
    return Rounded(complex(rounded), abs(rounded))


def ratio(value: Rounded) -> Array:
    """How large values are against what they were computed from; zero for an exact zero."""
    sizes = np.asarray(value.size)
    return np.where(sizes == 0, 0.0, np.abs(value.value) / np.where(sizes == 0, 1.0, sizes))


def _coordinates(question: Question, point: Valuation, where: int) -> dict[str, str]:
    """The coordinates of one of the points."""
    found = point.coordinates(question.ring)
    return {name: _text(value, where) for name, value in found.items()}


def _text(value: Rounded, where: int) -> str:
    found = complex(np.broadcast_to(value.value, POINTS)[where])
    return f"{found.real:.6g}{found.imag:+.6g}i"
