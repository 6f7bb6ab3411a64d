"""Evidence: what a search found for a goal. It is never trusted; :mod:`accept` checks it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from kowalevski_cas.notation import Formula

Row = tuple[Formula, ...]


class Point(NamedTuple):
    """A real point: the value of each variable, constant, root and power.

    Values are made of rationals, i, and square roots of whole numbers.
    """

    values: Mapping[str, Formula]


class Proof(NamedTuple):
    """Why goals vanish where known expressions do.

    ``rows`` combine each goal from what is known; no rows at all: the goals vanish
    identically. Or some ``product`` of groups is combined by the one row, and in the case of
    each group, which is known to vanish there, the goals are proved once more. A group of
    several expressions stands for the sum of their squares. What is combined is the goal, or
    the product, to a ``power``: it vanishes with it. The sides of ``equal`` have one square, and
    neither is negative: so their differences are known, too.
    """

    rows: tuple[Row, ...] = ()
    product: tuple[Row, ...] = ()
    cases: tuple[Proof, ...] = ()
    power: int = 1
    equal: tuple[tuple[Formula, Formula], ...] = ()


class Entailment(NamedTuple):
    """That something follows: a proof, and a point at which the hypotheses hold.

    Without a point nothing is shown: it may be about nothing.
    """

    proof: Proof = Proof()
    point: Point | None = None


class At(NamedTuple):
    """A point at which something fails, or differentials are independent."""

    point: Point


class Minors(NamedTuple):
    """That differentials are dependent: each maximal minor as a combination of what is given."""

    rows: tuple[Row, ...]


class Found(NamedTuple):
    """Formulas for bound names, and the evidence for each goal in which they stand."""

    values: Mapping[str, Formula]
    evidence: tuple[Evidence, ...]


class Regardless(NamedTuple):
    """Points at which one goal fails whatever the bound names are.

    An equation of the goal is a polynomial in the bound names at each point; the sum of these
    with the rational weights is a number other than zero. Bound expressions may have other
    values at other points, so their coefficients vanish at each.
    """

    goal: int
    points: tuple[tuple[Formula, Point], ...]


class Factor(NamedTuple):
    """A factor of minors as a sum of squares, perhaps modulo the equations.

    With ``granted``, the place of something that is granted not to vanish, and a row that
    combines it from the bases of the squares and the equations: the factor does not vanish then.
    """

    factor: Formula
    squares: tuple[tuple[Formula, Formula], ...] = ()
    row: Row = ()
    granted: tuple[int, Row] | None = None


class Roots(NamedTuple):
    """All solutions of equations, by the real roots of an eliminant of a form of the unknowns.

    ``solved`` gives each unknown by numerator and denominator, ``rows`` show this from the
    equations, ``quotients`` the converse; ``minors`` are Hermite's as products of ``factors``.
    """

    root: str
    form: Formula
    eliminant: Row
    solved: tuple[tuple[str, Formula, Formula], ...]
    rows: tuple[Row, ...]
    quotients: Row
    factors: tuple[Factor, ...]
    minors: tuple[tuple[Formula, tuple[int, ...]], ...]
    point: Point


class Solutions(NamedTuple):
    """More real solutions than there should be."""

    points: tuple[Point, ...]


class Further(NamedTuple):
    """A polynomial that is missing in a kernel; at the point it is independent of what is known."""

    formula: Formula
    point: Point


class Departure(NamedTuple):
    """Where a motion begins, and the order of a derivative of which the two sides differ."""

    point: Point
    order: int


Evidence = Entailment | At | Minors | Found | Regardless | Roots | Solutions | Further | Departure


@dataclass(frozen=True)
class Denial:
    """Evidence that the goal at this place of a problem is false.

    A tuple is evidence for all goals; this is none, so that the two cannot be confused.
    """

    goal: int
    evidence: Evidence
