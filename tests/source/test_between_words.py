"""Words among the formulas of a display are words of the text between two formulas."""

from itertools import pairwise

import pytest

from kowalevski_cas.source.files import decode
from kowalevski_cas.source.formulas import typed_formulas


def pieces(display):
    text = rf"\begin{{document}}\[{display}\]\end{{document}}"
    expanded, formulas = typed_formulas(decode("paper.tex", text.encode()))
    between = [expanded.text[one.end : other.start] for one, other in pairwise(formulas)]
    return [one.tex.strip(" ,.") for one in formulas], [words.strip() for words in between]


@pytest.mark.parametrize("macro", [r"\text", r"\mbox", r"\textrm"])
@pytest.mark.parametrize("words", ["with the integral", "if", "где", "so that, by this,"])
def test_words_stand_between_two_formulas(macro, words):
    display = rf"\dot x=y,\qquad{macro}{{{words}}}\qquad \dot y=-x ."
    assert pieces(display) == ([r"\dot x=y", r"\dot y=-x"], [words])


@pytest.mark.parametrize(
    "display",
    [
        r"x_{\text{max}}=1",
        r"a=b\quad\text{and}\quad c=d",
        r"x^2+y^2=\text{const}",
        r"\begin{cases}x,&\text{if } t>0\\ y,&\text{else}\end{cases}",
        r"f(x,\ \text{otherwise})=0",
        r"m\ \text{the mass of the body}",
    ],
)
def test_what_belongs_to_a_formula_stays_in_it(display):
    assert pieces(display) == ([display], [])


def test_what_is_said_behind_the_last_formula_is_no_formula():
    assert pieces(r"x^2=h\quad\text{is an integral}.")[0] == ["x^2=h"]
