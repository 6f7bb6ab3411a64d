"""What is printed, by place: displays, their statements, and readings of them.

Everything that a derivation says refers to a place of the paper; the words and
signs at that place come from a :class:`Texts`. So a changed formula (a mutant,
a correction, the next version of the author's file) is the same derivation
with other texts.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields, replace
from dataclasses import field as default
from typing import Any

from kowalevski_cas.notation import (
    EQUALITIES,
    DefinedNames,
    Edit,
    Formula,
    NotationError,
    PrintedStatement,
    Relation,
    Vocabulary,
    defined_names,
    read,
    read_display,
    read_statement,
    split_display,
)
from kowalevski_cas.paper.times import TimeChange, time_change

IN_WORDS = "in the words of a claim"
"""The source of a formula that the words of a claim give, so that nobody has to display it."""


@dataclass(frozen=True)
class Display:
    """A displayed or inline formula of the paper, as printed.

    ``display[k]`` is its k-th statement in reading order, counted from 1, and iterating gives all
    of them. ``label`` says where it stands in the edition: the number of the equation, or the page.
    """

    id: str
    tex: str
    section: str
    inline: bool = False
    source: str = ""
    """Where a formula comes from that the paper itself does not print."""
    label: str = ""
    cites: tuple[str, ...] = ()
    """The displays that the words before it cite, by their ids."""

    def __getitem__(self, number: int) -> Printed:
        return Printed(self, number)

    def __iter__(self) -> Iterator[Printed]:
        """The statements; raises ``NotationError`` for broken TeX."""
        return (Printed(self, k) for k, _ in enumerate(defined_names(self.tex), 1))

    def reading(self, accepted: Mapping[int, str]) -> str:
        """The TeX with other statements at some numbers.

        Raises ``ValueError`` for a statement that is printed with others, by a ± or an index.
        """
        tex = self.tex
        spans = split_display(tex)
        for number in sorted(accepted, reverse=True):
            if spans.count(spans[number - 1]) > 1:
                raise ValueError(f"{self.id}: print the statements of {tex} one by one")
            start, end = spans[number - 1]
            tex = tex[:start] + accepted[number] + tex[end:]
        return tex


@dataclass(frozen=True)
class Printed:
    """One statement of a display."""

    display: Display
    number: int

    def __hash__(self) -> int:
        return hash((self.display.id, self.number))  # places are looked up all the time

    @property
    def place(self) -> str:
        """The public name of the place: ``eq10.3``."""
        return f"{self.display.id}.{self.number}"

    @property
    def tex(self) -> str:
        """The TeX of the statement alone, as the derivation has it."""
        start, end = split_display(self.display.tex)[self.number - 1]
        return self.display.tex[start:end]

    @property
    def heads(self) -> DefinedNames:
        """What the statement defines."""
        return defined_names(self.display.tex)[self.number - 1]


def edited_formulas(printed: Printed, edit: Edit) -> dict[Printed, Formula]:
    """What an edit of a place makes of it, and of what is printed together with it."""
    beside = {printed.display[number]: formula for number, formula in edit.beside}
    return {printed: edit.formula, **beside}


def statements(*printed: Display | Printed) -> Iterator[Printed]:
    """Single statements, and all those of displays; raises ``TypeError`` for anything else."""
    for statement in printed:
        if isinstance(statement, Display):
            yield from statement
        elif isinstance(statement, Printed):
            yield statement
        else:
            raise TypeError(f"a display or a statement is expected, and not {statement!r}")


def check_attributes(instance: Any, owner: str) -> None:
    """Refuse an attribute of another type than is declared: a display for a statement, say.

    Raises ``TypeError``, which says what to write.
    """
    for field in fields(instance):
        # annotations are postponed in this package: the type of a field is the text of it
        value, kind = getattr(instance, field.name), str(field.type)
        if isinstance(value, Display):
            write = f"(*{value.id},)" if kind.startswith("tuple") else f"{value.id}[1]"
            raise TypeError(
                f"{owner}: {field.name} is to hold statements, not the display {value.id}: "
                f"write its variable as in {write}"
            )
        if (wrong := _type_error(value, kind)) is not None:
            raise TypeError(f"{owner}: {field.name} {wrong}")


_TYPES: Mapping[str, tuple[type, str]] = {
    "Printed": (Printed, "a statement, as display[1]"),
    "str": (str, "a string"),
    "int": (int, "a whole number"),
}


def _type_error(value: object, kind: str) -> str | None:
    """What a value has to be, if it is not of a type; only the types above are looked at."""
    kind, *others = kind.split(" | ") if "[" not in kind or kind[-1] != "]" else [kind]
    if ("None" in others and value is None) or type(value).__name__ in others:
        return None
    if kind.startswith("tuple["):
        if not isinstance(value, tuple):
            return f"is to be a tuple, not {value!r}: add a comma"
        inner = kind[len("tuple[") : -1].removesuffix(", ...")
        inner = inner if "[" in inner else inner.partition(", ")[0]
        return _first_mistyped(value, inner)
    if kind.startswith("Mapping[str, ") and isinstance(value, Mapping):
        inner = kind[len("Mapping[str, ") : -1]
        return _first_mistyped(value, "str") or _first_mistyped(value.values(), inner)
    expected, words = _TYPES.get(kind, (object, ""))
    return None if isinstance(value, expected) else f"is to be {words}, not {value!r}"


def _first_mistyped(values: Iterable[object], kind: str) -> str | None:
    """What the first of some values has to be that is not of a type."""
    wrong = (_type_error(value, kind) for value in values)
    return next(
        (message.replace("to be", "to hold", 1) for message in wrong if message is not None), None
    )


@dataclass(frozen=True, eq=False)
class Texts:
    """The texts at the places of a derivation, read in one vocabulary.

    ``sources`` holds displays, by id, that differ from what the derivation
    prints; ``edits`` holds single statements that are changed on top of that.
    """

    vocabulary: Vocabulary
    sources: Mapping[str, str] = default(default_factory=dict)
    edits: Mapping[Printed, Formula] = default(default_factory=dict)
    _read: dict[str, tuple[PrintedStatement, ...]] = default(default_factory=dict)
    _expressions: dict[str, Formula] = default(default_factory=dict)

    def with_edit(self, printed: Printed, edit: Edit) -> Texts:
        """The same texts with one statement changed."""
        return self.reading(edited_formulas(printed, edit))

    def reading(self, formulas: Mapping[Printed, Formula]) -> Texts:
        """The same texts with other formulas at some places."""
        return replace(self, edits={**self.edits, **formulas})

    def with_source(self, display: Display, tex: str) -> Texts:
        """The same texts with another source of one display."""
        kept = {id: statements for id, statements in self._read.items() if id != display.id}
        return replace(self, sources={**self.sources, display.id: tex}, _read=kept)

    def expression(self, tex: str) -> Formula:
        """A formula that no place prints, in the same vocabulary."""
        if tex not in self._expressions:
            self._expressions[tex] = read(tex, self.vocabulary)
        return self._expressions[tex]

    def as_printed(self, printed: Printed) -> Formula:
        """The formula at a place, which may be an inequality."""
        return self.edits.get(printed, self.statement(printed).formula)

    def comparison(self, printed: Printed) -> Relation:
        """The chain of equalities and inequalities at a place.

        Raises ``NotationError`` for a formula without a sign between two sides.
        """
        return self._chain(printed, self.as_printed(printed), "an inequality")

    def formula(self, printed: Printed) -> Formula:
        """The formula at a place.

        Raises ``NotationError`` if it cannot be read, or if it says that things differ: an
        inequality is never taken for the equality that may have been meant.
        """
        statement, formula = self.statement(printed), self.as_printed(printed)
        if isinstance(formula, Relation) and not formula.is_equality:
            before = [formula.signs.index(sign) for sign in formula.signs if sign not in EQUALITIES]
            end = statement.spans.get((before[0],), (0, statement.start))[1]
            message = f"{printed.place}: an equality is expected, not {formula.signs[before[0]]}"
            raise NotationError(message, statement.tex, end)
        return formula

    def relation(self, printed: Printed) -> Relation:
        """The chain of equalities at a place; raises ``NotationError`` if there is none."""
        return self._chain(printed, self.formula(printed), "an equation")

    def _chain(self, printed: Printed, formula: Formula, what: str) -> Relation:
        if not isinstance(formula, Relation):
            source = self.source(printed.display)
            raise NotationError(f"{what} is expected at {printed.place}", source, 0)
        return formula

    def sides(self, printed: Printed) -> tuple[Formula, Formula]:
        """Both sides of an equation; raises ``NotationError`` if it has more, or is none."""
        members = self.relation(printed).members
        if len(members) != 2:
            statement = self.statement(printed)
            message = f"{printed.place}: an equation with two sides is expected"
            raise NotationError(message, statement.tex, statement.start)
        return members[0], members[1]

    def ends(self, printed: Printed) -> tuple[Formula, Formula]:
        """What a chain of equalities begins and ends with."""
        members = self.relation(printed).members
        return members[0], members[-1]

    def time_change(self, printed: Printed) -> TimeChange:
        """What a printed equation says of another time."""
        change = time_change(*self.sides(printed))
        if change is None:
            source = self.source(printed.display)
            raise NotationError(f"a multiple of t is expected at {printed.place}", source, 0)
        return change

    def statement(self, printed: Printed) -> PrintedStatement:
        """The statement at a place, as it stands before edits.

        It may stand beside others that cannot be read.
        """
        try:
            statements = self.statements(printed.display)
        except NotationError:
            source = self.source(printed.display)
            if 1 < len(split_display(source)) >= printed.number >= 1:
                return read_statement(source, printed.number, self.vocabulary)
            raise
        if not 1 <= printed.number <= len(statements):
            raise NotationError(
                f"{printed.display.id}: statement {printed.number} is asked for, there are "
                f"{len(statements)}",
                self.source(printed.display),
                0,
            )
        return statements[printed.number - 1]

    def statements(self, display: Display) -> tuple[PrintedStatement, ...]:
        """All statements of a display, as they stand before edits."""
        if display.id not in self._read:
            try:
                self._read[display.id] = read_display(self.source(display), self.vocabulary)
            except NotationError as error:
                message = f"{display.id}: {error.message}"
                raise NotationError(message, error.tex, error.position) from None
        return self._read[display.id]

    def source(self, display: Display) -> str:
        """The TeX of a display."""
        return self.sources.get(display.id, display.tex)

    def changes(self, places: Collection[Printed]) -> frozenset[object]:
        """What differs from the derivation at these places, as a key."""
        changed: set[object] = {item for item in self.edits.items() if item[0] in places}
        if self.sources:
            ids = {printed.display.id for printed in places}
            changed |= {item for item in self.sources.items() if item[0] in ids}
        return frozenset(changed)
