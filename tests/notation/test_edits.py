"""One change of one place: every misprint can be made, and every one can be undone."""

import random
from dataclasses import replace as replace_words
from itertools import islice

import pytest

from kowalevski_cas.notation import (
    Name,
    Number,
    Vocabulary,
    edits,
    read,
    read_display,
    replace,
    subtree,
)
from tests.notation import paper
from tests.sample import sampled

WORDS = Vocabulary(scalars=frozenset("x_1 x_2 y_1 a".split()))


def made(tex, kind, words=WORDS):
    [statement] = read_display(tex, words)
    return [edit.tex for edit in edits(statement, words) if edit.kind == kind]


@pytest.mark.parametrize(
    ("tex", "kind", "expected"),
    [
        ("x_1 + x_2 = 0", "sign", ["-x_1 + x_2 = 0", "x_1 - x_2 = 0"]),
        ("a = -x_1", "sign", ["-a = -x_1", "a = x_1"]),
        ("a - (x_1 - x_2)", "sign", ["-a - (x_1 - x_2)", "a + (x_1 - x_2)",
                                     "a - (-x_1 - x_2)", "a - (x_1 + x_2)"]),
        (r"a + \\ + x_1", "sign", [r"-a + \\ + x_1", r"a - \\ - x_1"]),
        ("a x_1", "index", ["a x_2"]),
        ("x'_1", "index", ["x_2'"]),
        ("a x_1", "letter", ["x_1 x_1", "x_2 x_1", "y_1 x_1", "a y_1", "a a"]),
        ("x_1^2", "exponent", ["x_1", "x_1^3"]),
        ("a^3x_1", "exponent", ["a^2x_1", "a^4x_1", "a^3x_1^2"]),
        ("2 a", "coefficient", ["3 a", "4 a"]),
        ("3a", "coefficient", ["4a", "6a", "2a", r"\frac{3}{2}a"]),
        ("a", "coefficient", ["2a", r"\frac{1}{2}a"]),
        ("a x_1(x_1+ x_2)", "factor", ["x_1(x_1 + x_2)", "a(x_1 + x_2)", "ax_1"]),
        (r"\frac{a x_1}{x_2}", "power", [r"ax_1x_2", r"\frac{x_1}{x_2a}", r"\frac{a}{x_2x_1}", r"\frac{x_2}{ax_1}"]),
        (r"a\sqrt{x_1}", "power", [r"\frac{1}{a}\sqrt{x_1}", r"a\frac{1}{\sqrt{x_1}}"]),
    ],
)  # fmt: skip
def test_edits_of_each_kind(tex, kind, expected):
    assert made(tex, kind) == expected


def test_a_function_may_have_lost_its_square_an_exponential_its_sign_and_a_fraction_its_half():
    words = replace_words(WORDS, functions=frozenset({r"\tan", r"\exp"}))
    assert r"a = x_1\tan(x_2)^2" in made(r"a = x_1\tan x_2", "exponent", words)
    assert r"a = \exp(-x_1)" in made(r"a = \exp(x_1)", "sign", words)
    assert r"a = \frac{x_1}{2x_2}" in made(r"a = \frac{x_1}{x_2}", "coefficient")


def test_a_partial_derivative_may_have_lost_an_order_or_have_one_too_many():
    first, second = r"\frac{\partial a}{\partial x_1}", r"\frac{\partial^2 a}{\partial x_1^2}"
    third = r"\frac{\partial^3 a}{\partial x_1^3}"
    formulas = {order: read(tex, WORDS) for order, tex in enumerate((first, second, third), 1)}
    for order in formulas:
        [statement] = read_display(f"{(first, second, third)[order - 1]} = 0", WORDS)
        found = {edit.formula.members[0] for edit in edits(statement, WORDS)}
        assert found & {*formulas.values()} == {
            formulas[k] for k in (order - 1, order + 1) if k in formulas
        }


def test_a_letter_that_is_missing_stands_beside_the_same_letter():
    assert "a = (y_1 + a)x_1x_2" in made("a = (y_1 + a)x_1", "missing")
    assert "a = y_1(y_1 + a)a" in made("a = (y_1 + a)a", "missing")


def test_a_factor_may_be_missing_in_a_term_a_denominator_and_a_root():
    found = made(r"x_1 + \frac{1}{\sqrt{x_2}}", "missing")
    assert r"x_1a + \frac{1}{\sqrt{x_2}}" in found
    assert r"x_1 + \frac{a}{\sqrt{x_2}}" in found
    assert r"x_1 + \frac{1}{a\sqrt{x_2}}" in found
    assert r"x_1 + \frac{1}{\sqrt{x_2a}}" in found


def test_a_rate_may_be_missing_that_stands_elsewhere():
    assert r"a = \dot x_1x_2 + y_1\dot{x}_1" in made(r"a = \dot x_1x_2 + y_1", "missing")


def test_the_misprint_of_the_time_variable_is_one_sign_away():
    words = Vocabulary(scalars=frozenset(["i"]))
    assert "i^2=-1" in made("i^2=1", "sign", words)


def test_the_index_that_a_complex_frequency_should_have_is_found():
    [statement] = read_display(r"x'_1 = -x_1 w_1", paper.WORDS)
    found = {edit.words: edit.tex for edit in edits(statement, paper.WORDS)}
    assert found[r"for $w_1$ read $\omega_3$"] == r"x'_1 = -x_1 \omega_3"
    assert found["for $w_1$ read $w_3$"] == "x'_1 = -x_1 w_3"


def test_kinds_come_in_the_order_of_plausibility():
    [statement] = read_display(paper.DISPLAYS["eq12"], paper.WORDS)
    kinds = [edit.kind for edit in edits(statement, paper.WORDS)]
    order = ["sign", "index", "letter", "exponent", "coefficient", "factor", "power", "missing"]
    order.append("exchange")
    assert list(dict.fromkeys(kinds)) == order
    assert kinds == sorted(kinds, key=order.index)


@pytest.mark.parametrize("name", sampled(paper.DISPLAYS, 6))
def test_the_edited_source_reads_as_the_edited_formula(name):
    tex = paper.DISPLAYS[name]
    statements = read_display(tex, paper.WORDS)
    for place, statement in enumerate(statements):
        found = list(edits(statement, paper.WORDS))
        for edit in random.Random(place).sample(found, min(4, len(found))):
            assert edit.formula != statement.formula
            assert edit.formula == replace(statement.formula, edit.path, edit.replacement)
            after = [s.formula for s in read_display(edit.tex, paper.WORDS)]
            expected = [s.formula for s in statements]
            expected[place] = edit.formula
            assert after == expected


@pytest.mark.parametrize("name", sampled(paper.DISPLAYS, 1))
def test_the_edits_on_the_way_to_a_formula_are_all_that_lead_to_it(name):
    for place, statement in enumerate(read_display(paper.DISPLAYS[name], paper.WORDS)):
        found = list(edits(statement, paper.WORDS))
        for edit in random.Random(place).sample(found, min(4, len(found))):
            near = list(edits(statement, paper.WORDS, wanted=edit.formula))
            assert [e for e in near if e.formula == edit.formula] == [
                e for e in found if e.formula == edit.formula
            ]


def test_an_edit_leaves_the_rest_of_the_source_alone():
    [statement] = read_display(paper.DISPLAYS["eq21"], paper.WORDS)
    for edit in islice(edits(statement, paper.WORDS), 40):
        if edit.words.startswith(r"change the sign of $\frac{1}{\alpha_1^2"):
            assert edit.tex.count("\\displaystyle") == 2
            assert edit.tex.count(r"}]^2  -}") == 1
            assert edit.tex.count(r"\phantom{\Psi=} - \frac") == 1
            break
    else:
        pytest.fail("the sign of the second row is not among the edits")


def test_an_edit_is_undone_by_an_edit():
    words = Vocabulary(scalars=frozenset(["x_1", "x_2"]))
    [statement] = read_display("2x_1^2 - x_2", words)
    for edit in edits(statement, words):
        if edit.kind in ("sign", "index", "letter"):
            [wrong] = read_display(edit.tex, words)
            assert statement.formula in {back.formula for back in edits(wrong, words)}


def test_replacing_a_subtree():
    formula = read("a(x_1 + x_2)", WORDS)
    assert subtree(formula, (1, 0)) == Name("x_1")
    assert replace(formula, (1, 0), Number(3)) == read("a(3 + x_2)", WORDS)
    with pytest.raises(IndexError):
        replace(formula, (2,), Number(3))
