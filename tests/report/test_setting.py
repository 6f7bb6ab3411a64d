"""Displays in lines: everything is there, nothing is wider than the page."""

import json
import re
from xml.etree import ElementTree

import pytest

from kowalevski_cas.notation import Name, Number, Power, Product, Sum, to_plain
from kowalevski_cas.notation.latex import LATEX
from kowalevski_cas.notation.mathml import MATHML
from kowalevski_cas.notation.typst import TYPST, to_typst
from kowalevski_cas.report.html import HtmlSetter
from kowalevski_cas.report.latex import LatexSetter
from kowalevski_cas.report.pieces import pieces, source_of, width_of
from kowalevski_cas.report.typst import TypstSetter
from tests.report.fixtures import EQ16, outcomes, read

FORMULAS = [
    *dict.fromkeys(
        formula
        for outcome in outcomes()
        for formula in (*outcome.formulas, *(f for step in outcome.steps for f in step.formulas))
    )
]
SN, CN, U = Name(r"\mathrm{sn}"), Name(r"\mathrm{cn}"), Name("u")
WORDS = Product((Name("k"), Power(SN, Number(2)), CN, U))
FORMULAS += [WORDS, Product((U, Sum((Name("x"), Name("y")))))]
APART = read(r"w_1=-\frac{(x_1w_2+z_1w_1)(x_2w_1+z_2w_2)(x_1+x_2)}{4m(z_1-z_2)}")
SIGNS = read("x_1=-x_2-(-x_1)+[-x_1+(-1)](-2)")
FORMULAS += [*APART, *SIGNS]
LATEX_SETTER, TYPST_SETTER = LatexSetter(), TypstSetter()


@pytest.mark.parametrize("printer", [LATEX, MATHML, TYPST])
def test_pieces_side_by_side_are_the_formula(printer):
    for formula in FORMULAS:
        own = re.sub(r"\s", "", source_of(pieces(formula, printer), printer))
        assert own == re.sub(r"\s", "", printer(formula))


@pytest.mark.parametrize("room", [12, 18.5, 28, 41])
def test_lines_hold_everything(room):
    for formula in FORMULAS:
        body = LATEX_SETTER.display([formula], room)
        said = re.sub(r"\\(begin|end)\{aligned\}|\\[bB]ig+[lr]|\\q+uad|\{\}", "", body)
        said, whole = (
            re.sub(r"\\left|\\right|\\\\|&|\s", "", one)
            for one in (said, LATEX_SETTER.inline(formula))
        )
        # A fraction that is taken apart stands behind its denominator, in brackets.
        assert said == whole or sorted(said) == sorted(whole + "1()" * said.count(r"\frac{1}"))


@pytest.mark.parametrize("room", [12, 18.5, 28, 41])
def test_a_browser_shows_every_letter_of_the_lines(room):
    assert APART and SIGNS
    for formula in FORMULAS:
        setter = HtmlSetter()
        for text in (setter.display([formula], room), setter.inline(formula)):
            for element in ElementTree.fromstring(f"<p>{text}</p>").iter():
                letters = element.tag in ("mi", "mn", "mo")
                assert bool((element.text or "").strip()) == letters
                assert not (element.tail or "").strip()
                assert element.tag != "mfrac" or len(element) == 2


@pytest.mark.parametrize("room", [12, 41])
def test_a_minus_with_nothing_before_it_stands_close_to_what_it_belongs_to(room):
    before = re.compile(r"<mo[^>]*>[=≠(\[]</mo>\s*(<mrow>|<mi></mi>)*<mo( form=\"\w+\")?>[−+]</mo>")
    for formula in FORMULAS:
        for text in (HtmlSetter().display([formula], room), HtmlSetter().inline(formula)):
            assert {one[2] for one in before.finditer(text)} <= {' form="prefix"'}


def test_words_stand_apart_from_other_factors():
    assert LATEX_SETTER.inline(WORDS) == r"k\,\mathrm{sn}^2\,\mathrm{cn}\,u"
    assert TYPST_SETTER.inline(WORDS) == 'k thin upright("sn")^(2) thin upright("cn") thin u'
    assert MATHML(WORDS).count("mspace width") == 3
    assert to_plain(WORDS) == "k sn² cn u"
    nine = Product((Number(3), Number(3)))
    assert (LATEX(nine), to_plain(nine)) == (r"3\times3", "3×3")
    assert LATEX(WORDS) == r"k\mathrm{sn}^2\mathrm{cn}u"  # what is read again has no spaces


def test_a_sign_at_which_a_line_may_be_broken_stays_between_two_parts():
    left = read(EQ16)[0].members[0]
    parts = HtmlSetter().inline(Sum((left, *left.terms))).split(" <math>")
    assert len(parts) > 1
    assert all(part.startswith('<mo form="infix" lspace="0">') for part in parts[1:])


def test_short_formulas_share_a_line_and_others_are_aligned():
    short = read(r"x_1 = 1,\quad x_2 = 2")
    assert LATEX_SETTER.display(short, 40) == r"x_1 = 1,\quad x_2 = 2"
    assert LATEX_SETTER.display(short, 6) == (
        "\\begin{aligned}\nx_1 & = 1 \\\\\nx_2 & = 2\n\\end{aligned}"
    )
    assert TYPST_SETTER.display(short, 6) == "x_(1) & = 1 \\\nx_(2) & = 2"


def test_a_line_begins_before_a_sign():
    body = LATEX_SETTER.display(read(EQ16), 28)
    assert all(re.match(r"& (\\q?quad|2\[)|\\(begin|end)", line) for line in body.split("\n"))


def test_what_is_measured_is_about_what_typst_measures():
    import typst

    asked = (f"measure($ {to_typst(one)} $).width / 1em.to-absolute()" for one in FORMULAS)
    source = f"#context [#metadata(({', '.join(asked)})) <w>]"
    widths = json.loads(typst.query(source.encode(), "<w>", field="value", one=True))
    for formula, width in zip(FORMULAS, widths, strict=True):
        assert 0.75 * width - 1 <= width_of(pieces(formula, LATEX)) <= 1.35 * width + 1.5
