"""Points in words: what is a coordinate, and what stands for a number."""

from __future__ import annotations

import pytest

from kowalevski_cas.cli import plain
from kowalevski_cas.notation import Formula, Number, Vocabulary, read
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.verify.outcome import Counterexample, PrintedPoint

NAMES = frozenset({"x", "y", r"\pi", "E", "G"})
WORDS = Vocabulary(NAMES, functions=frozenset({r"\exp", r"\sin"}))


def formula(tex: str) -> Formula:
    return read(tex, WORDS)


def at(values: dict[str, str]) -> PrintedPoint:
    return PrintedPoint({formula(name): formula(value) for name, value in values.items()})


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"x": "2", r"\pi": "3", "y": "1"}, "At x = 2, y = 1, with 3 in place of π"),
        ({r"\pi": "3"}, "With 3 in place of π"),
        ({"x": "2", r"\exp(1)": "3"}, "At x = 2, with 3 in place of exp(1)"),
    ],
)
def test_a_number_is_no_coordinate(values: dict[str, str], words: str) -> None:
    """No algebraic equation of π is known, and so it has no value at a point."""
    told = plain.text(Phrases(WORDS, {}).at(at(values))).replace("\xa0", " ")
    assert told == f"{words} (any number may stand for it: no algebraic equation of it is known): "


def test_functions_of_what_moves_are_coordinates() -> None:
    assert (
        plain.text(Phrases(WORDS, {}).at(at({r"\sin x": "1"}))).replace("\xa0", " ")
        == "At sin(x) = 1: "
    )


def test_by_what_values_are_computed_is_said_behind_them() -> None:
    """What is long is named by the number of its display."""
    short, long = formula("E=x^2"), formula("G=" + "+".join(["x^2y^2"] * 20))
    numbered = Display("g", "", "1", label="(7)")
    defined = (short, Display("f", "", "1")[1]), (long, numbered[1])
    found = Counterexample(at({"x": "1"}), Number(1), Number(2))._replace(defined=defined)
    said = plain.text(Phrases(WORDS, {}).values(found)).replace("\xa0", " ")
    assert said.endswith("the left side is 1, the right side 2. Here E = x² and G as in (7).")
