"""Goals: one theorem over a space each. A problem is what a claim states, without evidence."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.space import Equation, Setting

Main = tuple[tuple[str, ...], ...]
"""Sets of variables in which a division is tried: a hint to the search, no part of a statement."""


class Theorem:
    """What all goals over a space have."""

    def formulas(self) -> Iterator[Formula]:
        """Every formula of the statement."""
        yield from _formulas(tuple(vars(self).values()))


def _formulas(value: object) -> Iterator[Formula]:
    if isinstance(value, Formula):
        yield value
    for part in value if isinstance(value, tuple) else ():
        yield from _formulas(part)


@dataclass(frozen=True, eq=False)
class Follows(Theorem):
    """Wherever the ``given`` equations hold, all equations of one of the ``conclusions`` do.

    One conclusion is the ordinary case, and an identity if nothing is given; no conclusion
    says that the given equations have no common real point.
    """

    space: Setting
    conclusions: tuple[tuple[Equation, ...], ...]
    given: tuple[Equation, ...] = ()
    main: Main = ()


class Fails(Follows):
    """At a real point where the given equations hold some equation of each conclusion fails."""


@dataclass(frozen=True, eq=False)
class Rank(Theorem):
    """At a real point of the ``given`` equations ``rank`` differentials are independent.

    They are those of the functions and of the given equations, and so many in number.
    """

    space: Setting
    functions: tuple[Formula, ...]
    given: tuple[Equation, ...]
    rank: int


@dataclass(frozen=True, eq=False)
class Count(Theorem):
    """For all constants for which there is a solution there are exactly ``number`` real ones.

    The equations are for the variables in ``names``; no other variable stands in them.
    """

    space: Setting
    equations: tuple[Equation, ...]
    names: tuple[str, ...]
    number: int


@dataclass(frozen=True, eq=False)
class Kernel(Theorem):
    """The polynomials f in the variables with D f = ``factor`` f, up to a degree, are known.

    For almost all values of the constants they are the linear combinations of products of one of
    the ``solutions`` and of some of the ``integrals``. The degree counts each variable with its
    positive weight, in the order of the variables.
    """

    space: Setting
    factor: Formula
    solutions: tuple[Formula, ...]
    integrals: tuple[Formula, ...]
    weights: tuple[int, ...]
    degree: int


@dataclass(frozen=True, eq=False)
class Along(Theorem):
    """Along the motion with ``initial`` values variables are equal to the other sides.

    The other sides solve the same system, which is regular where they begin, and begin as one.
    """

    space: Setting
    initial: tuple[tuple[str, Formula], ...]
    equations: tuple[tuple[str, Formula], ...]


Simple = Follows | Rank | Count | Kernel | Along


@dataclass(frozen=True, eq=False)
class Exists:
    """There are rational ``numbers``, and ``expressions``, for which all goals hold."""

    goals: tuple[Simple, ...]
    expressions: tuple[str, ...] = ()
    numbers: tuple[str, ...] = ()

    @property
    def bound(self) -> tuple[str, ...]:
        """The names that are bound."""
        return (*self.numbers, *self.expressions)


Goal = Simple | Exists


def simple(goal: Goal) -> tuple[Simple, ...]:
    """The goals without a bound name that a goal consists of: itself, or those below it."""
    return goal.goals if isinstance(goal, Exists) else (goal,)


class Problem(NamedTuple):
    """What a claim states."""

    goals: tuple[Goal, ...]


def identity(space: Setting, *equations: Equation) -> Follows:
    """The goal that equations hold identically."""
    return Follows(space, (equations,))
