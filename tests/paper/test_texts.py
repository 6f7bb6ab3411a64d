"""Texts: what stands at the places of a paper, as printed or changed."""

import pytest

from kowalevski_cas.notation import NotationError, Vocabulary, edits, to_latex
from kowalevski_cas.paper.texts import Display, Texts

WORDS = Vocabulary(scalars=frozenset({"x", "y"}))
ROWS = Display("rows", r"x=y,\quad y=2x", "1")


@pytest.fixture
def texts():
    return Texts(WORDS)


def test_statements_are_counted_from_one(texts):
    assert [to_latex(texts.formula(ROWS[k])) for k in (1, 2)] == ["x = y", "y = 2x"]
    assert ROWS[2].place == "rows.2"


@pytest.mark.parametrize("number", [0, 3, -1])
def test_a_statement_that_is_not_there(texts, number):
    with pytest.raises(NotationError, match=f"rows: statement {number} is asked for, there are 2"):
        texts.formula(ROWS[number])


def test_an_unreadable_display_is_named(texts):
    with pytest.raises(NotationError, match=r"(?s)^bad: .*x=\("):
        texts.formula(Display("bad", "x=(", "1")[1])


def test_an_edit_changes_one_statement_and_not_the_texts(texts):
    edit = next(edits(texts.statement(ROWS[2]), WORDS))
    edited = texts.with_edit(ROWS[2], edit)
    assert edited.formula(ROWS[2]) == edit.formula != texts.formula(ROWS[2])
    assert edited.formula(ROWS[1]) == texts.formula(ROWS[1])
    assert edited.changes(frozenset({ROWS[2]})) and not edited.changes(frozenset({ROWS[1]}))
    assert not texts.changes(frozenset({ROWS[1], ROWS[2]}))


def test_another_source_is_read_in_place_of_the_printed_one(texts):
    texts.formula(ROWS[1])
    other = texts.with_source(ROWS, "x=3, y=4")
    assert to_latex(other.formula(ROWS[2])) == "y = 4"
    assert to_latex(texts.formula(ROWS[2])) == "y = 2x"
    assert other.changes(frozenset({ROWS[1]})) and not texts.changes(frozenset({ROWS[1]}))


def test_expressions_are_read_once(texts):
    assert texts.expression("x+y") is texts.expression("x+y")


@pytest.mark.parametrize("ask", [Texts.formula, Texts.relation, Texts.sides])
def test_an_inequality_is_never_read_as_an_equality(texts, ask):
    with pytest.raises(NotationError, match=r"rows.2: an equality is expected, not .ne") as caught:
        ask(texts.with_source(ROWS, r"x=y, y=x \ne 2x"), ROWS[2])
    assert caught.value.tex[caught.value.position :].lstrip() == r"\ne 2x"


def test_an_equation_has_two_sides_and_none_is_left_out(texts):
    assert [to_latex(side) for side in texts.sides(ROWS[2])] == ["y", "2x"]
    with pytest.raises(NotationError, match="two sides"):
        texts.with_source(ROWS, "x=y=2").sides(ROWS[1])


@pytest.mark.parametrize("beside", [r"\lim x", r"\oint x\,dy=1", "x=("])
def test_a_statement_is_read_beside_one_that_cannot_be(texts, beside):
    display = Display("rows", rf"x=y,\quad {beside},\quad y=2x", "1")
    if beside == "x=(":  # where brackets do not close nobody knows what a statement is
        display = Display("rows", rf"x=y,\quad {beside}", "1")
    assert to_latex(texts.formula(display[1])) == "x = y"
    with pytest.raises(NotationError):
        texts.formula(display[2])
    (edit,) = (
        one
        for one in edits(texts.statement(display[1]), WORDS)
        if one.formula == texts.expression("x=2y")
    )
    assert edit.tex == display.tex.replace("=y", "=2y")
