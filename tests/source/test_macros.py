from dataclasses import replace
from itertools import pairwise

import pytest

from kowalevski_cas.source import definitions, macros
from kowalevski_cas.source.files import decode
from kowalevski_cas.source.macros import expand
from kowalevski_cas.source.text import SourceError


def written(text: str) -> str:
    return expand(decode("paper.tex", text.encode())).text.strip()


@pytest.mark.parametrize(
    ("text", "result"),
    [
        (r"\newcommand {\bs}{\boldsymbol} ${\bs \alpha}$", r"${\boldsymbol \alpha}$"),
        (r"\newcommand\R{\mathbf R} $\R^9$", r"$\mathbf R^9$"),
        (r"\def\v#1{{\bf #1}} $\v{e}_1+\v x$", r"${\bf e}_1+{\bf x}$"),
        (r"\newcommand{\p}[2][t]{\frac{d#2}{d#1}} $\p{x}=\p[s]{y}$", r"$\frac{dx}{dt}=\frac{dy}{ds}$"),
        (r"\DeclareMathOperator{\diag}{diag} $\diag(a)$", r"$\operatorname{diag}(a)$"),
        (r"\def\be{\begin{equation}}\def\ee{\end{equation}}\be x=1\ee", r"\begin{equation} x=1\end{equation}"),
        (r"\newcommand{\om}{\omega} $\om x$, $\om$", r"$\omega x$, $\omega$"),
        (r"\newcommand{\a}{\b}\newcommand{\b}{x} $\a$", "$x$"),
        (r"\renewcommand{\a}{1}\renewcommand{\a}{2} $\a$", "$2$"),
    ],
)  # fmt: skip
def test_macros_are_written_out(text, result):
    assert written(text) == result


def test_a_macro_stays_apart_from_a_letter():
    assert written(r"\newcommand{\om}{\omega}$\om{}x$") == r"$\omega{}x$"
    assert written(r"\def\m#1{\omega}$\m1x$") == r"$\omega x$"
    assert written(r"\newcommand{\y}{x}$\omega\y$") == r"$\omega x$"
    assert written(r"\newcommand{\y}{x}\newcommand{\o}{\omega\y\y}$\o$") == r"$\omega xx$"


def test_what_is_written_out_knows_where_it_came_from():
    text = "\\newcommand{\\bs}{\\boldsymbol}\n$x+\\bs y$"
    expanded = expand(decode("paper.tex", text.encode()))
    at = expanded.text.index("\\boldsymbol")
    start, end = expanded.origin(at, at + 5)
    assert text[start:end] == "\\bs"
    at = expanded.text.rindex("y")
    assert text[slice(*expanded.origin(at, at + 1))] == "y"
    assert text[slice(*expanded.origin(at - 3, at))] == "\\bs "


def test_a_macro_that_expands_into_itself_is_left_alone():
    expanded = expand(decode("paper.tex", rb"\newcommand{\a}{x\a} $\a$ $y$"))
    assert expanded.text.strip() == r"$\a$ $y$"
    assert [words for _, words in expanded.notes] == [
        r"the macro \a expands into itself; it is left alone"
    ]


def test_macros_that_double_are_refused():
    names = "abcdefghijklmnopqrstuvwxyz"
    lines = [rf"\def\{a}{{\{b}\{b}\{b}}}" for a, b in pairwise(names)]
    with pytest.raises(SourceError, match=r"macros to write out|too much text"):
        written("\n".join([*lines, r"\def\z{x}", r"$\a$"]))


def test_macros_that_grow_stay_within_limits():
    names = "abcdefghij"
    lines = [rf"\def\{a}#1{{\{b}{{#1#1#1#1}}}}" for a, b in pairwise(names)]
    text = "\n".join([*lines, r"\def\j#1{#1}", rf"$\a{{{'x' * 1000}}}$"])
    assert len(written(text)) < macros.LONGEST


def test_definitions_that_are_not_understood_are_noted():
    expanded = expand(decode("paper.tex", rb"\def\a(#1){x} \newcommand{\b} $x$"))
    assert len(expanded.notes) == 2
    assert "not understood" in expanded.notes[0][1]


def test_unclosed_definitions_take_no_time():
    expanded = expand(decode("paper.tex", rb"\def\a{" * 30_000))
    assert len(expanded.notes) == definitions.FAILURES


STYLE = rb"""\ProvidesPackage{own}
\newcommand{\mbf}[1]{\boldsymbol{#1}} \def\pl{\partial} \providecommand{\od}[2]{\frac{d#1}{d#2}}
\DeclareMathOperator*{\Tr}{Tr} \newcommand{\twice}[2][x]{2#1#2}
"""


@pytest.mark.parametrize(
    ("text", "result"),
    [
        (r"$\mbf{r}\od{x}{t}$", r"$\boldsymbol{r}\frac{dx}{dt}$"),
        (r"$\frac{\pl H}{\pl q}$", r"$\frac{\partial H}{\partial q}$"),
        (r"$\Tr A \twice{y} \twice[z]{y}$", r"$\operatorname{Tr} A 2xy 2zy$"),
        (r"\renewcommand{\pl}{d} $\pl x$", "$d x$"),
        (r"\let\d\pl $\d x$", r"$\partial x$"),
        (r"\newcommand{\pl}{d} $\pl x$", r"$\pl x$"),  # new twice: what holds cannot be told
    ],
)
def test_macros_of_style_files_hold_before_those_of_the_source(text, result):
    source = replace(decode("paper.tex", text.encode()), styles=(decode("own.sty", STYLE),))
    assert expand(source).text.strip() == result


def test_what_a_style_file_says_that_is_not_understood_is_noted():
    style = decode("own.sty", rb"\def\a(#1){x} \newcommand{\b}{y}")
    expanded = expand(replace(decode("paper.tex", rb"$\a\b$"), styles=(style,)))
    assert expanded.text.strip() == r"$\a y$"
    assert expanded.notes[0][1].startswith("in a style file: this")
    assert r"\a" in expanded.definitions.unclear
