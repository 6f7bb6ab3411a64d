"""What is printed reads back as the same tree."""

import re
from dataclasses import replace
from xml.etree import ElementTree

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas.notation import (
    Derivative,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    read,
    read_display,
    to_latex,
    to_plain,
)
from kowalevski_cas.notation.formula import Application
from kowalevski_cas.notation.mathml import to_mathml
from kowalevski_cas.notation.typst import to_typst
from tests.notation.strategies import WORDS, formulas

x, y, ell, d, t = Name("x_1"), Name("x_2"), Name(r"\ell"), Name("d"), Name("t")
half = Quotient(Number(1), Number(2))
many = settings(max_examples=8 * settings.default.max_examples)
"""Formulas are many, and printing one costs little."""


@many
@given(formulas)
def test_reading_what_was_printed_gives_the_same_formula(formula):
    tex = to_latex(formula)
    assert read(tex, WORDS) == formula
    assert to_latex(read(tex, WORDS)) == tex


def put_in(bracket, formula):
    """The formula with each part in such brackets, where it stands in any."""
    inner = formula.map_children(lambda part: put_in(bracket, part))
    return replace(inner, bracket=bracket)


@many
@given(formulas, st.sampled_from(["(", "[", r"\{"]))
def test_brackets_stand_as_they_are_printed(formula, bracket):
    tex = to_latex(put_in(bracket, formula))
    assert to_latex(read(tex, WORDS)) == tex
    assert read(tex, WORDS) == formula


@pytest.mark.parametrize("written", [to_latex, to_plain, to_mathml, to_typst])
def test_every_format_has_the_brackets_of_the_print(written):
    one, other = (written(read(f"{a}x_1+1{b}^2m", WORDS)) for a, b in ("()", "[]"))
    assert "[" in other and "[" not in one


def test_a_second_partial_derivative_is_read_as_one_of_one():
    twice = Partial(Partial(ell, "x_1"), "x_1")
    assert read(r"\frac{\partial^2\ell}{\partial x_1^2}", WORDS) == twice


@many
@given(formulas)
def test_plain_text_has_no_macro_and_no_brace_of_tex(formula):
    text = to_plain(formula)
    assert not set(text) & set("\\$&\n")
    assert text.count("(") == text.count(")") and text.count("[") == text.count("]")


CHILDREN = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "mover": 2, "munderover": 3}
"""How many elements those of MathML Core hold that have places for them."""

ELEMENTS = {*CHILDREN} | {*"math mi mn mo mpadded mrow mspace msqrt mtable mtr mtd".split()}


@many
@given(formulas)
def test_mathml_is_of_its_core_and_says_what_is_printed(formula):
    math = ElementTree.fromstring(f"<math>{to_mathml(formula)}</math>")
    for element in math.iter():
        assert element.tag in ELEMENTS
        assert len(element) == CHILDREN.get(element.tag, len(element))
        letters = element.tag in ("mi", "mn", "mo")
        assert bool((element.text or "").strip()) == letters and not (element.tail or "").strip()
    text = "".join(math.itertext())
    assert text.count("(") == text.count(")") and text.count("[") == text.count("]")
    digits = re.sub(r"\D", "", to_latex(formula))
    assert sorted(re.sub(r"\D", "", text)) == sorted(digits)


@many
@given(formulas)
def test_every_node_has_a_place_within_its_parent(formula):
    [statement] = read_display(f"$$ {to_latex(formula)} $$", WORDS)
    for path, (start, end) in statement.spans.items():
        assert start < end
        if path:
            outer = statement.spans[path[:-1]]
            assert outer[0] <= start and end <= outer[1]


@pytest.mark.parametrize(
    ("formula", "tex"),
    [
        (Product((ell, Name("a"))), r"\ell a"),
        (Product((Number(2), x, Sum((x, y)))), "2x_1(x_1 + x_2)"),
        (Product((x, Number(2))), r"x_1\cdot 2"),
        (Sum((Negative(x), Negative(Sum((x, y))))), "-x_1 - (x_1 + x_2)"),
        (Power(Sum((half, x)), Number(2)), r"\left(\frac{1}{2} + x_1\right)^2"),
        (Product((x, Sum((y, Product((x, Sum((x, y)))))))), "x_1[x_2 + x_1(x_1 + x_2)]"),
        (Power(x, Number(12)), "x_1^{12}"),
        (Derivative(Name(r"\omega_{12}"), "dot"), r"\dot{\omega}_{12}"),
        (Derivative(Derivative(x, "dot"), "dot"), r"\ddot{x}_1"),
        (Derivative(Product((x, y)), "dot"), r"\dot{(x_1x_2)}"),
        (Derivative(Derivative(x, "prime"), "prime"), "x_1''"),
        (Derivative(Sum((x, y)), "prime"), "(x_1 + x_2)'"),
        (Derivative(x, r"\tau"), r"\frac{dx_1}{d\tau}"),
        (Derivative(ell, "t"), r"\frac{d\ell}{dt}"),
        (Derivative(Sum((x, y)), r"\tau"), r"\frac{d}{d\tau}(x_1 + x_2)"),
        (Partial(ell, "x_1"), r"\frac{\partial\ell}{\partial x_1}"),
        (Partial(Sum((x, y)), "t"), r"\frac{\partial}{\partial t}(x_1 + x_2)"),
        # the scalar d is not the d of a derivative
        (Quotient(Product((d, x)), Product((d, t))), r"\frac{dx_1}{d\cdot t}"),
    ],
)
def test_formulas_are_printed_tidily(formula, tex):
    assert to_latex(formula) == tex


@pytest.mark.parametrize(
    ("formula", "text"),
    [
        (Name(r"\omega_{12}"), "ω₁₂"),
        (Name(r"\boldsymbol{\alpha}"), "𝛂"),
        (Name("y_A"), "y_A"),
        (Power(x, Number(12)), "x₁¹²"),
        (Power(x, Negative(half)), "x₁^(−1/2)"),
        (Root(Product((x, y))), "√(x₁x₂)"),
        (Product((Root(x), y)), "√x₁ x₂"),
        (Derivative(x, "prime"), "x₁′"),
        (Derivative(x, "dot"), "ẋ₁"),
        (Derivative(Sum((x, y)), r"\tau"), "d/dτ(x₁ + x₂)"),
        (Partial(ell, "x_1"), "∂ℓ/∂x₁"),
        (Quotient(Product((x, y)), Product((d, t))), "x₁x₂/(dt)"),
        (Product((half, x)), "(1/2)x₁"),
        (Sum((half, Negative(x))), "1/2 − x₁"),
        (Product((x, Power(Name(r"\mathrm{sn}"), Number(2)))), "x₁ sn²"),
        (Product((ell, Name(r"\mathrm{sn}"))), "ℓ sn"),
    ],
)
def test_plain_text_is_what_one_would_type(formula, text):
    assert to_plain(formula) == text


@pytest.mark.parametrize("function", ["f", r"\varphi", r"\ln", r"\mathrm{sn}", r"\mathbf{F}"])
def test_an_argument_stands_close_to_its_function(function):
    import typst

    one = to_typst(Application(function, (x,)))
    wide = f"measure($ {one} $).width - measure($ {to_typst(Name(function))} $).width"
    source = f"#context [#metadata(({wide} - measure($ ({to_typst(x)}) $).width) / 1pt) <w>]"
    assert abs(float(typst.query(source.encode(), "<w>", field="value", one=True))) < 0.5


def test_typst_sets_every_kind_of_node():
    import typst

    seen = set()

    @settings(many, database=None)
    @given(formulas)
    def collect(formula):
        seen.add(to_typst(formula))

    collect()
    typst.compile("\n".join(f"$ {text} $" for text in sorted(seen)).encode())
