"""Formulas and words in plain text, for a terminal."""

from __future__ import annotations

from collections.abc import Iterable

from kowalevski_cas.notation import (
    Formula,
    NotationError,
    Vocabulary,
    print_prose,
    read_display,
    read_prose,
    to_plain,
)
from kowalevski_cas.verify.outcome import Condition, Counterexample, Value


def formulas(found: Iterable[Formula], source: str = "") -> str:
    """The formulas of a display on one line; its source where they could not be read."""
    return ", ".join(map(to_plain, found)) or " ".join(source.split())


def display(source: str, vocabulary: Vocabulary) -> str:
    """The formulas of a display by its source."""
    try:
        found = read_display(source, vocabulary)
    except NotationError:
        found = ()
    return formulas((statement.formula for statement in found), source)


def words(text: str, vocabulary: Vocabulary) -> str:
    """Words with mathematics between dollars."""
    return print_prose(read_prose(text, vocabulary), str, to_plain)


def nonzero(condition: Condition) -> str:
    """What a condition says."""
    return f"{to_plain(condition.expression)} ≠ 0"


def where(conditions: Iterable[Condition]) -> str:
    """What several conditions say."""
    return f"where {', '.join(map(nonzero, conditions))}"


def needs(condition: Condition, vocabulary: Vocabulary) -> str:
    """What a statement needs, and why."""
    return f"needs {nonzero(condition)}: {words(condition.words, vocabulary)}"


def evidence(found: Counterexample, vocabulary: Vocabulary) -> list[str]:
    """Both values, and the point at which they are taken."""
    values = [(name, value) for name, value in found.point.values.items() if name != value]
    point = ", ".join(f"{to_plain(name)} = {_value(value)}" for name, value in values)
    said = f"  ({words(found.words, vocabulary)})" if found.words else ""
    return [
        f"    values    {_value(found.left)} against {_value(found.right)}{said}",
        f"    at        {point}",
    ]


def _value(value: Value) -> str:
    return value if isinstance(value, str) else to_plain(value)
