"""Formulas as an author printed them, made plain and broken into lines."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.report.mathematics import display, displays, plain, width
from tests.report.fixtures import EQ16, EQ21, LONG, outcomes

FORMULAS = [o.printed for o in outcomes() if o.printed] + [
    s.tex for o in outcomes() for s in o.steps if s.tex
]


@pytest.mark.parametrize(
    ("printed", "today"),
    [
        (r"{\bf I} \dot {\bs \omega} = {\bf e}_1  \times {\bs \alpha}", r"\mathbf{I}\dot{\boldsymbol{\omega}} = \mathbf{e}_1 \times \boldsymbol{\alpha}"),
        (r"{2z'_1  = x_1 w_2  - y_2 w_1,}", r"2z'_1 = x_1w_2 - y_2w_1,"),
        (r"{\mathop{\rm Im}\nolimits} [x_2^2 c_1] = {\rm const}", r"\operatorname{Im}[x_2^2c_1] = \mathrm{const}"),
        (r"\frac12 \sqrt x \overline {U_1 }", r"\frac{1}{2}\sqrt{x}\overline{U_1}"),
        (r"\displaystyle{\frac {dU_1} {d\tau } =\phantom{-}{\frac {c_1 } {x_1^2 }}}", r"\frac{dU_1}{d\tau} = \frac{c_1}{x_1^2}"),
        (r"[\frac{a}{b}]^2", r"\left[ \frac{a}{b} \right]^2"),
        (r"a &= b \cr c &= d", r"a = b\quad c = d"),
        (r"$x$", "x"),
        (r"\left\langle x\right\rangle y", r"\langle x\rangle y"),
        (r"\bigl\langle x\bigr\rangle y", r"\bigl\langle x\bigr\rangle y"),
        ("{ x = y", "x = y"),
        ("", ""),
    ],
)  # fmt: skip
def test_plain(printed: str, today: str) -> None:
    assert plain(printed) == today


def test_a_row_that_begins_with_a_sign_continues_the_one_above() -> None:
    assert plain(EQ16).count("+ [") == 1
    assert r"\right]^2 + \frac" in plain(EQ21)


@pytest.mark.parametrize("formula", FORMULAS)
def test_plain_is_plain(formula: str) -> None:
    assert plain(plain(formula)) == plain(formula)


@pytest.mark.parametrize("room", [12, 18.5, 28, 41])
@pytest.mark.parametrize("formula", FORMULAS)
def test_lines_hold_everything_and_fit(formula: str, room: float) -> None:
    body = display(formula, room)
    rows = (
        re.sub(r"\\(begin|end)\{aligned\}", "", body).split("\\\\\n")
        if "aligned" in body
        else [body]
    )
    if not body.startswith(r"\begin{aligned}"):
        rows = [body]
    said = re.sub(r"\\[bB]ig+[lr]|\\left|\\right|\\q+uad|\{\}|&|\s", "", "".join(rows))
    assert said == re.sub(r"\\left|\\right|\\q+uad|&|\s", "", plain(formula))
    if room > 20:
        assert all(width(row.replace("&", "")) <= 1.1 * room for row in rows)


def test_a_very_long_step_is_shortened() -> None:
    body = display(LONG * 8, 40, lines=12)
    assert body.count("\\\\\n") == 11
    assert re.search(r"\\cdots \\quad\\text\{\(\d+ more lines\)\}", body)


def test_several_formulas_share_one_display() -> None:
    assert displays(["x' = 1", "y' = 2"], 40) == (
        "\\begin{aligned}\nx' & = 1 \\\\\ny' & = 2\n\\end{aligned}"
    )


PIECES = st.sampled_from(
    [*"{}()[]&^_'+-=, x1ω", r"\frac", r"\sqrt", r"\left(", r"\right)", r"\\", r"\begin{array}{l}",
     r"\end{array}", r"\bf ", r"\bs ", r"\displaystyle", r"\text", r"\phantom", r"\mathop", r"\bigl",
     r"\alpha", r"\quad", "%", "$", r"\left", r"\right", r"\cr", r"\[", "\n"]
)  # fmt: skip


@given(st.lists(PIECES, max_size=40).map("".join), st.sampled_from([5.0, 20.0, 40.0]))
def test_noise_is_set_with_balanced_braces(noise: str, room: float) -> None:
    for tex in (plain(noise), display(noise, room)):
        level = 0
        for brace in re.findall(r"\\.|[{}]", tex):
            level += {"{": 1, "}": -1}.get(brace, 0)
            assert level >= 0
        assert level == 0


def test_a_fraction_taken_apart_keeps_its_denominator() -> None:
    body = display(r"z = \frac{\bigl(a+b\bigr)(c+d+e+f+g+h+i+j+k+l+m+n+o+p)(q+r)}{\sqrt{u}}", 16)
    assert r"\frac{1}{\sqrt{u}}\Bigl(\bigl(a + b\bigr)" in body


@pytest.mark.parametrize(
    "opening", [r"\sqrt", r"\frac", "x^", "{", r"\sqrt{", r"\frac{", r"\left(", "_{"]
)
def test_depth_is_no_trouble(opening: str) -> None:
    display(opening * 1000 + "x", 40)
