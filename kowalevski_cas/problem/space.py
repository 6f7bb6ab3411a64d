r"""Spaces: what a setting means, as plain data in formulas.

A formula of a space is made of numbers, names, ``+ - * /``, whole powers, declared roots,
derivatives along the vector field, partial derivatives, conjugates, vectors and their
products. Whatever else a paper prints (real parts, dots and primes, applied functions,
brackets) has been written out in these when the scene was elaborated.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import NamedTuple

from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.mentions import Mentions, mentions
from kowalevski_cas.problem.trees import Tree, encode

Equation = tuple[Formula, Formula]
"""The two sides."""


class Meaningless(ValueError):
    """A formula without meaning where it stands; ``name`` is the name to blame, if there is one."""

    def __init__(self, message: str, name: str | None = None) -> None:
        super().__init__(message)
        self.name = name


class Contradictory(Meaningless):
    """What is supposed, and is seen to hold nowhere."""


@dataclass(frozen=True)
class NameDefinition:
    """What says what a name means; what many statements ask of it is found once."""

    name: str

    def formulas(self) -> Iterator[Formula]:
        """The formulas in it."""
        for part in fields(self):
            value = getattr(self, part.name)
            yield from (
                formula for formula in (value, *_parts(value)) if isinstance(formula, Formula)
            )

    @cached_property
    def mentions(self) -> tuple[Mentions, ...]:
        """What each formula in it mentions."""
        return tuple(map(mentions, self.formulas()))

    @cached_property
    def trees(self) -> list[Tree]:
        """What it has, as it stands in a certificate."""
        values = (getattr(self, part.name) for part in fields(self))
        return [
            encode(value)
            if isinstance(value, Formula)
            else [*map(encode, value)]
            if _parts(value)
            else value
            for value in values
            if value is not None
        ]


def _parts(value: object) -> tuple[object, ...]:
    return value if isinstance(value, tuple) else ()


@dataclass(frozen=True)
class Let(NameDefinition):
    """A name that stands for a formula."""

    formula: Formula


@dataclass(frozen=True)
class Adjoined(NameDefinition):
    """A name whose square is a formula; ``printed`` is the equation that says so in the paper."""

    square: Formula
    printed: Equation | None = None


@dataclass(frozen=True)
class Raised(NameDefinition):
    """A name for ``base`` to the power of a constant: θ > 0, and dP = m P dθ/θ."""

    base: Formula
    exponent: str


Step = Let | Adjoined | Raised


class EquationOfMotion(NamedTuple):
    """A row of a vector field: ``factor`` times the rates of the names is ``force``."""

    names: tuple[str, ...]
    factor: Formula
    force: Formula


@dataclass(frozen=True, eq=False)
class ChangeOfVariables:
    """The field is that of the space ``old``, carried over by formulas for the new variables.

    Each rate by the new time is ``time`` times the one by the old time.
    """

    old: Setting
    formulas: tuple[tuple[str, Formula], ...]
    time: Formula


class Setting(ABC):
    """What a space and a scene that is being elaborated have in common.

    ``variables`` move, ``constants`` do not; steps define all other names.
    """

    variables: tuple[str, ...]
    constants: tuple[str, ...]

    @property
    @abstractmethod
    def nonzero(self) -> tuple[Formula, ...]:
        """What is taken for granted not to vanish."""

    @property
    @abstractmethod
    def roots(self) -> tuple[str, ...]:
        """The names of the generators that are adjoined roots, in the order of adjunction."""

    @property
    @abstractmethod
    def powers(self) -> tuple[str, ...]:
        """The names of the generators that are powers."""

    @property
    @abstractmethod
    def conjugates(self) -> tuple[tuple[str, str], ...]:
        """The pairs of conjugate names."""

    @property
    @abstractmethod
    def loci(self) -> tuple[tuple[tuple[Equation, ...], Formula], ...]:
        """Declared places of degeneracy: equations, and what does not vanish elsewhere."""

    @cached_property
    def left(self) -> dict[object, Space]:
        """The spaces to which it was pruned, by all that they say."""
        return {}

    @abstractmethod
    def step(self, name: str) -> Step | None:
        """What defines a name; ``None`` for a variable or a constant.

        Raises :class:`~kowalevski_cas.problem.evaluate.Meaningless` if nothing does.
        """

    def numerator(self, formula: Formula) -> Formula:
        """What vanishes with a formula; in variables, constants and roots, if that can be said."""
        return formula

    @property
    @abstractmethod
    def coordinates(self) -> tuple[str, ...]:
        """The roots that are variables: a point gives them values of their own."""

    @property
    def together(self) -> tuple[tuple[str, ...], ...]:
        """Names of which each says something about the others, as the sine about the cosine."""
        return ()

    @property
    def own_variables(self) -> tuple[str, ...]:
        """The variables, for statements that depend on which they are: degrees, volumes, counts.

        Raises :class:`Meaningless` if others stand in the place of some.
        """
        return self.variables

    @property
    @abstractmethod
    def field(self) -> tuple[EquationOfMotion, ...]:
        """The rows of the vector field; none if there is none or a change gives it."""

    @property
    @abstractmethod
    def change(self) -> ChangeOfVariables | None:
        """The change of variables that gives the field."""


@dataclass(frozen=True, eq=False)
class Space(Setting):
    """A setting as it stands in a certificate.

    ``loci`` are no part of it: they say where a search may look.
    """

    variables: tuple[str, ...]
    constants: tuple[str, ...] = ()
    nonzero: tuple[Formula, ...] = ()
    steps: tuple[Step, ...] = ()
    field: tuple[EquationOfMotion, ...] = ()
    change: ChangeOfVariables | None = None
    conjugates: tuple[tuple[str, str], ...] = ()
    loci: tuple[tuple[tuple[Equation, ...], Formula], ...] = ()

    @property
    def together(self) -> tuple[tuple[str, ...], ...]:
        """The roots with the names in their squares, of which they say that these are real."""
        steps = (step for step in self.steps if isinstance(step, Adjoined))
        return tuple((step.name, *sorted(step.square.names())) for step in steps)

    @cached_property
    def _by_name(self) -> dict[str, Step]:
        return {step.name: step for step in self.steps}

    @property
    def roots(self) -> tuple[str, ...]:
        """The names of roots."""
        return tuple(step.name for step in self.steps if isinstance(step, Adjoined))

    @property
    def coordinates(self) -> tuple[str, ...]:
        moving = {name for row in self.field for name in row.names}
        moving |= {name for pair in self.conjugates for name in pair}
        return tuple(name for name in self.roots if name in moving)

    @property
    def powers(self) -> tuple[str, ...]:
        """The names of powers."""
        return tuple(step.name for step in self.steps if isinstance(step, Raised))

    def step(self, name: str) -> Step | None:
        if name in self.variables or name in self.constants:
            return None
        if name not in self._by_name:
            raise Meaningless(f"{name} has no meaning here", name)
        return self._by_name[name]


def all_names(setting: Setting) -> tuple[str, ...]:
    """All names to which a point gives values."""
    return (*generators(setting), *setting.roots)


def generators(setting: Setting) -> tuple[str, ...]:
    """The names that a point gives values to: variables, constants, powers."""
    names: Sequence[str] = (*setting.variables, *setting.constants, *setting.powers)
    return tuple(names)
