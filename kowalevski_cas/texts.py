"""What is printed, by place: displays, their statements, and readings of them.

Everything that a derivation says refers to a place of the paper; the words and
signs at that place come from a :class:`Texts`. So a changed formula (a mutant,
a correction, the next version of the author's file) is the same derivation
with other texts.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kowalevski_cas.notation import (
    NotationError,
    Statement,
    Vocabulary,
    read_display,
)


@dataclass(frozen=True, slots=True)
class Display:
    """A displayed or inline formula of the paper, as printed.

    ``display[k]`` is its k-th statement in reading order, counted from 1.
    """

    id: str
    tex: str
    section: str
    inline: bool = False

    def __getitem__(self, number: int) -> Printed:
        return Printed(self, number)


@dataclass(frozen=True, slots=True)
class Printed:
    """One statement of a display."""

    display: Display
    number: int

    @property
    def place(self) -> str:
        """The public name of the place: ``eq10.3``."""
        return f"{self.display.id}.{self.number}"


class Texts:
    """The texts at the places of a derivation, read in one vocabulary.

    ``replaced`` holds, by place, statements that stand there instead of what the
    derivation prints.
    """

    def __init__(
        self,
        vocabulary: Vocabulary,
        replaced: Mapping[Printed, str] | None = None,
        base: Texts | None = None,
    ) -> None:
        self.vocabulary = vocabulary
        self.replaced = dict(replaced or {})
        self.base = base
        self._displays: dict[Display, tuple[Statement, ...]] = {}
        self._statements: dict[Printed, Statement] = {}

    def replace(self, printed: Printed, tex: str) -> Texts:
        """The same texts with another statement at one place."""
        base = self.base or self
        return Texts(self.vocabulary, {**self.replaced, printed: tex}, base)

    def statement(self, printed: Printed) -> Statement:
        """The statement at a place; raises ``NotationError`` if it cannot be read."""
        if printed not in self._statements:
            self._statements[printed] = self._read(printed)
        return self._statements[printed]

    def _read(self, printed: Printed) -> Statement:
        if (tex := self.replaced.get(printed)) is not None:
            return self._only(read_display(tex, self.vocabulary), printed, tex)
        if self.base is not None:
            return self.base.statement(printed)
        if printed.display not in self._displays:
            display = printed.display
            try:
                self._displays[display] = read_display(display.tex, self.vocabulary)
            except NotationError as error:
                message = f"{display.id}: {error.message}"
                raise NotationError(message, error.tex, error.position) from None
        statements = self._displays[printed.display]
        if not 1 <= printed.number <= len(statements):
            raise NotationError(
                f"{printed.display.id} has {len(statements)} statements, "
                f"number {printed.number} is asked for",
                printed.display.tex,
                0,
            )
        return statements[printed.number - 1]

    @staticmethod
    def _only(statements: tuple[Statement, ...], printed: Printed, tex: str) -> Statement:
        if len(statements) != 1:
            raise NotationError(f"one statement is expected at {printed.place}", tex, 0)
        return statements[0]

    def source(self, printed: Printed) -> str:
        """The TeX of the statement at a place."""
        return self.statement(printed).source
