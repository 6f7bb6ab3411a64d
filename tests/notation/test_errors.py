"""An error says what is wrong, shows where, and never takes long."""

import pickle
import random

import pytest

from kowalevski_cas.notation import (
    NotationError,
    Vocabulary,
    read,
    read_display,
    split_display,
    to_latex,
)
from tests.sample import sampled

WORDS = Vocabulary(
    scalars=frozenset(r"x_1 x_2 z_1 w_1 w_2 \omega_1 \omega_2 \omega_3 \ell a d F".split()),
    vectors=frozenset([r"\boldsymbol{\alpha}"]),
    functions=frozenset([r"\varphi"]),
    times=frozenset([r"\tau"]),
)


def complaint(tex):
    with pytest.raises(NotationError) as caught:
        read(tex, WORDS)
    return str(caught.value)


def test_an_undeclared_name_is_shown_with_its_neighbours():
    assert complaint("x'_1 = -x_1 w_3 + z_1 w_1") == (
        "w_3 is not declared here; did you mean \\omega_3, w_1 or w_2?\n"
        "  x'_1 = -x_1 w_3 + z_1 w_1\n"
        "              ^"
    )


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        ("b", "b is not declared here"),
        (r"\alpha", r"\alpha is not declared here; did you mean \boldsymbol{\alpha} or a?"),
        ("l", r"l is not declared here; did you mean \ell?"),
        (r"\omega_4", "\\omega_4 is not declared here; did you mean \\omega_1, \\omega_2 or"),
        (r"\foo x_1", r"the macro \foo is not known here"),
        ("", "there is no formula here"),
        ("a=0, d=0", "2 statements stand here; read_display reads them all"),
        ("(a", "the formula breaks off here"),
        ("a)", "this bracket closes nothing"),
        ("(a]", "( is closed by ]"),
        ("{a", "this brace is never closed"),
        ("a}", "this brace closes nothing"),
        ("= a", "something is missing before ="),
        ("(a = 0)", "the relation = stands inside brackets or an argument"),
        ("a +", "the formula breaks off here"),
        ("a - - d", "two signs in a row"),
        ("a^2^3", "two powers in a row; set brackets"),
        ("(a)_1", "an index stands on something that is not a letter"),
        (".5", "write a zero before the decimal point"),
        ("a^0.5", "TeX puts 0 there, and the rest on the line: set braces"),
        (r"\frac 1.5 2", "does the decimal stand here as a whole? set braces"),
        (r"\int a", "an integral cannot be read: write the derivative that it has"),
        (r"\sum_i a", "print where the sum begins and ends"),
        (r"a \over d", r"write \frac for this \over, or set braces"),
        (r"\partial a", "a derivative is expected here"),
        (r"\sqrt[n]{a}", "print the order of a root as a number above 1"),
        ("1/2d", "does this stand under the slash? set brackets, or use \\frac"),
        ("a/ d d", "does this stand under the slash? set brackets, or use \\frac"),
        (r"a/dd\sin d", "does this stand under the slash? set brackets, or use \\frac"),
        (r"\frac{d}{d\tau} F a", r"how far does the derivative by \tau reach? set brackets"),
        (r"\frac{d^2F}{d\tau}", "the orders above and below differ"),
        (r"\varphi + a", r"the argument of the function \varphi is missing"),
        ("|a", "the formula breaks off here"),
        (r"\begin{tikzcd}a\end{tikzcd}", "the environment tikzcd cannot be read"),
        (r"\begin{pmatrix} a & a \\ a \end{pmatrix}", "the rows of the matrix differ in length"),
        ("a\x00", "a control character stands in the formula"),
        # relations are what they are
        (r"a \mapsto 1", r"the relation \mapsto cannot be read"),
        (r"a = 1 \Rightarrow d = 1", r"the relation \Rightarrow cannot be read"),
        # text among formulas
        (r"a = d\text{ if $d=0$}", "mathematics inside of text cannot be read"),
        (r"a = d\mbox{$+1$}", "mathematics inside of text cannot be read"),
        (r"a \hbox{+} d", "mathematics inside of text cannot be read"),
        (r"a_{\text{$d$}}", "mathematics inside of text cannot be read"),
        (r"a = 0 \text{ or } d = 0", "the words “or” among formulas are not understood"),
        (r"a = \textit{d}", "the words “d” among formulas are not understood"),
        (r"a = d\ref{e}", r"the macro \ref is not known here"),
        ("$a$ $d$", "the mathematics ends here, and more follows"),
        (r"\[a\] \[d\]", "the mathematics ends here, and more follows"),
        # what changes the meaning of what follows
        (r"\let\a=d a", r"the macro \let is not known here"),
        (r"\gdef\a{d} a", r"the macro \gdef is not known here"),
        (r"\edef\a{d} a", r"the macro \edef is not known here"),
        (r"\catcode`\a=13 a", r"the macro \catcode is not known here"),
        # applied names
        (r"F(\tau)", "a product, or F at this argument?"),
        ("x_1(0)", "a product, or x_1 at this argument?"),
        (r"\dot F(\tau)^2", r"a product, or \dot F at this argument?"),
        ("F(a, d)", "a product, or F at this argument?"),
        ("a^{(2)}", "is this a power? then it needs no brackets"),
        # vectors
        (r"\bs\alpha \bs\alpha", "two vectors side by side"),
        (r"a(\bs\alpha\times\bs\alpha)\bs\alpha", "two vectors side by side"),
        (r"\bs\alpha + a", "a vector and a number are added"),
        (r"\bs\alpha = 1", "a vector is set equal to a number"),
        (r"\bs\alpha^3", "a number is expected here, not a vector"),
        (r"\frac{a}{\bs\alpha}", "a number is expected here, not a vector"),
        (r"a/\bs\alpha", "a number is expected here, not a vector"),
        (r"\bs\alpha \times a", "a vector product of a vector and something else"),
        # words and dots that stand for nothing
        (r"a + {\rm const}", "the word const stands at the end of an equation"),
        (r"a = {\rm const} = d", "the word const stands at the end of an equation"),
        (r"a\ldots d", "an ellipsis stands for terms, and for nothing else"),
        ("1\\,000", "two numbers side by side"),
        (r"\begin{pmatrix} a & \\ & d \end{pmatrix}", "an empty cell in a matrix"),
    ],
)
def test_the_message_says_what_is_wrong(tex, message):
    assert complaint(tex).startswith(message)


def test_the_caret_stands_under_the_place():
    _, formula, caret = complaint(r"a + \frac{F}{x_3}").split("\n")
    assert formula[caret.index("^") :] == "x_3}"


def test_of_a_long_formula_only_the_neighbourhood_is_shown():
    _, formula, caret = complaint(" + ".join(["x_1"] * 60 + ["q"] + ["x_2"] * 60)).split("\n")
    assert len(formula) <= 75
    assert formula[caret.index("^")] == "q"


def test_of_several_lines_the_right_one_is_shown():
    assert complaint("a +\n  q +\n d").split("\n")[1:] == ["    q +", "    ^"]


def test_an_error_crosses_to_another_process():
    with pytest.raises(NotationError) as caught:
        read("a + q", WORDS)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


@pytest.mark.parametrize(
    "tex",
    sampled(
        [
            "(" * 1000 + "a" + ")" * 1000,
            "{" * 1000 + "a" + "}" * 1000,
            r"\frac{1}{" * 1000 + "a" + "}" * 1000,
            r"\sqrt" * 1000 + "a",
            r"\dot" * 10000 + "a",
            r"\Re " * 1000 + "a",
            r"\frac{d}{d\tau}" * 1000 + "F",
            "a^{" * 1000 + "2" + "}" * 1000,
            "a" + "'" * 10000,
            "a" + "/a" * 10000,
            r"-2(a+\sqrt{d" * 45 + "}a)^2" * 45,
            r"\begin{pmatrix}" * 1000,
            r"\left(" * 1000,
            "x" * 1_000_000,
            "1" * 50_000,
            "a\x07",
        ],
        5,
    ),
)
def test_hostile_input_is_refused(tex):
    with pytest.raises(NotationError):
        read_display(tex, WORDS)


@pytest.mark.slow
def test_noise_is_read_or_refused_and_what_is_read_prints():
    chance = random.Random(7)
    pieces = [chr(code) for code in range(32, 127)] + [
        *(r"\frac \sqrt \dot \bf \text \left \\ & \begin{array}{l} \end{array} α".split()),
        *(r"x_1 a F ^2 _1 ( ) { } = + - \times \varphi \Re \begin{pmatrix} \end{pmatrix}".split()),
        "\n",
    ]
    read_well = 0
    for _ in range(4000):
        tex = "".join(chance.choice(pieces) for _ in range(chance.randrange(25)))
        try:
            split_display(tex)
            statements = read_display(tex, WORDS)
        except NotationError as error:
            assert str(error).startswith(error.message)
            continue
        for statement in statements:
            read_well += 1
            assert read(to_latex(statement.formula), WORDS) == statement.formula
    assert read_well > 20
